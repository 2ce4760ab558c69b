#pragma once

#include <memory>
#include <string>
#include <utility>

#include "bindings/wire.h"
#include "mesh/face_tree.h"
#include "rcm/mean.h"

namespace karcher::bindings {

/// A mesh as JavaScript holds it.
class MeshHandle {
 public:
  explicit MeshHandle(ImportedMesh imported);
  MeshHandle(const MeshHandle&) = delete;
  MeshHandle& operator=(const MeshHandle&) = delete;

  Surface& surface() { return surface_; }
  const TriangleMesh& mesh() const { return surface_.mesh(); }
  const Geometry& geometry() const { return surface_.geometry(); }
  const Numbering& numbering() const { return numbering_; }
  /// Of the mesh's curves and centers of mass.
  const std::shared_ptr<FieldSets>& fieldSets() const { return fieldSets_; }

  /// Of a mesh that an OBJ file gave.
  void setMarks(ObjMarks marks) { marks_ = std::move(marks); }
  /// {parts, partOf, materials, materialOf, colors}, as types.ts has them; parts are none of a mesh
  /// that no OBJ file gave.
  val marks() const;

  /// Of a mesh that approximates a known smooth surface.
  void setSmooth(const std::optional<CurvatureBound>& bound) { smooth_ = bound; }

  val info();
  int inputVertices() const { return numbering_.engineVertex.count(); }
  val positions() const;
  val triangles() const;
  /// Refined by Loop subdivision, `levels` times.
  std::unique_ptr<MeshHandle> subdivided(int levels) const;

  val checkedPoint(const val& point) const;
  val position(const val& point) const;
  /// Of points one after the other: x, y, z each.
  val positionsOf(const val& points) const;
  /// Of the point's face.
  val normal(const val& point) const;
  /// {point, distance}; `place` is a Float64Array of three numbers.
  val nearestPoint(const val& place);
  /// {end, remaining, stop, path}; `direction` is a Float64Array of three numbers, in space.
  val straightest(const val& from, const val& direction, double length) const;
  val shortestPath(const val& from, const val& to) const;

  // Vectors and directions are in space, three numbers each; a direction of length 0 is none.
  /// {vectors, directions}
  val logMap(const val& from, const val& points, const val& directions) const;
  /// The vectors of all vertices of the caller; NaN where no path leads.
  val logMapOfVertices(const val& from);
  /// {points, directions, remaining}
  val expMap(const val& from, const val& vectors, const val& directions) const;
  val mirror(const val& line, const val& points, const val& directions) const;
  /// The vectors at the end of the path of the log map.
  val transport(const val& from, const val& to, const val& vectors) const;

  // `field` is {method, solver, rings}.
  /// To the nearest of points that come one after the other.
  val distance(const val& from, const val& field);
  bool hasRingGraph(int rings) const { return surface_.hasRingGraph(rings); }
  /// Makes what fields share; the graph too, unless it was built in slices.
  void prepareFields(const val& field);
  /// `start` is a point, or an empty array for the engine's choice. `certificate` is there where it
  /// is asked for.
  val centerOfMass(const val& points, const val& weights, const val& start, bool normalize,
                   bool looksForOthers, bool certifies, const val& field);
  /// {point, position, energy, status}: of each row of weights, one after the other.
  val centersOfMass(const val& points, const val& rows, const val& start, bool normalize,
                    bool isChecked, const val& field);
  /// {weights, isMinimum}; `given` is empty for equal weights.
  val weightsOf(const val& point, const val& points, const val& given, bool nonNegative,
                const val& field);
  /// `distances` holds one field after another, each with a distance a vertex of the caller.
  val centerOfMassOfDistances(const val& distances, const val& weights, const val& start,
                              bool normalize);
  val circle(const val& center, double radius, const val& arcs, int samples, int levels,
             const val& field, double tolerance);
  /// `direction` as for `straightest`.
  val ellipse(const val& center, double along, double across, const val& direction, const val& arcs,
              int samples, int levels, const val& field);
  /// A list of paths (path.h): exact ones, or linear ones of the solver's distances.
  val isolines(const val& center, double radius, bool exact, const val& field);
  /// A list of paths. `side` is 1 for the left, -1 for the right, 0 for both.
  val offset(const val& outlines, double distance, int side) const;
  /// A list of {area, perimeter, boundary, share, triangles, sides}, one a shape or one of all. Of
  /// each shape `counts` has the number of its outlines, `insides` a point or none.
  val regions(const val& outlines, const val& counts, const val& insides, const std::string& rule,
              const std::string& combine) const;
  /// A list of {positions, triangles, faces}, one a cell.
  val cut(const val& outlines) const;

 private:
  Vec2 directionInFace(int face, const val& direction) const;
  /// Per vertex of the engine; kInfinity where no path leads.
  Array<double> distancesFromPoint(const SurfacePoint& source, const val& field);
  MeanOptions meanOptions(const val& start, bool normalize) const;
  val meanToJs(const Mean& mean) const;
  Array<double> engineDistances(const Array<double>& distances, size_t field) const;

  Numbering numbering_;
  Array<Vec3> droppedPositions_;
  Array<Repair> repairs_;
  ObjMarks marks_;
  Surface surface_;
  std::optional<CurvatureBound> smooth_;
  std::optional<FaceTree> faceTree_;  ///< made when it is first asked for
  std::shared_ptr<FieldSets> fieldSets_;
  /// Of the last center of mass.
  std::shared_ptr<FieldSet> fields_;
};

/// `bytes` is a Uint8Array with the content of an OBJ file, `parts` null for all of it or numbers
/// of its parts; `weld` is ImportOptions'.
std::unique_ptr<MeshHandle> meshFromObj(const val& bytes, const val& parts, bool repair,
                                        double weld);
/// `positions` is a Float64Array, `triangles` an Int32Array, each three numbers an item.
std::unique_ptr<MeshHandle> meshFromArrays(const val& positions, const val& triangles, bool repair,
                                           double weld);
/// The same of polygons: `corners` has the vertices of one after the other, `sizes` their numbers
/// of corners.
std::unique_ptr<MeshHandle> meshFromPolygons(const val& positions, const val& corners,
                                             const val& sizes, bool repair, double weld);
/// A built-in shape, by its name in the JavaScript API.
std::unique_ptr<MeshHandle> builtInShape(const std::string& name, int triangles);

}  // namespace karcher::bindings
