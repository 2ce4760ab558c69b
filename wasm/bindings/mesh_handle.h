#pragma once

#include <memory>
#include <string>

#include "bindings/wire.h"
#include "intrinsic/geometry.h"

namespace karcher::bindings {

/// A mesh as JavaScript holds it.
class MeshHandle {
 public:
  explicit MeshHandle(ImportedMesh imported);
  MeshHandle(const MeshHandle&) = delete;
  MeshHandle& operator=(const MeshHandle&) = delete;

  const TriangleMesh& mesh() const { return mesh_; }
  const Numbering& numbering() const { return numbering_; }

  val info() const;
  val positions() const;
  val triangles() const;
  /// Refined by Loop subdivision, `levels` times.
  std::unique_ptr<MeshHandle> subdivided(int levels) const;

  val checkedPoint(const val& point) const;
  val vertexPoint(int vertex) const;
  val position(const val& point) const;
  /// `direction` is a Float64Array of three numbers, in space.
  val straightest(const val& from, const val& direction, double length) const;

 private:
  Numbering numbering_;
  Array<Vec3> droppedPositions_;
  Array<Repair> repairs_;
  TriangleMesh mesh_;
  Geometry geometry_;
};

/// `bytes` is a Uint8Array with the content of an OBJ file.
std::unique_ptr<MeshHandle> meshFromObj(const val& bytes);
/// `positions` is a Float64Array, `triangles` an Int32Array, each three numbers an item.
std::unique_ptr<MeshHandle> meshFromArrays(const val& positions, const val& triangles);
/// A built-in shape, by its name in the JavaScript API.
std::unique_ptr<MeshHandle> builtInShape(const std::string& name, int triangles);

}  // namespace karcher::bindings
