#include "bindings/mesh_handle.h"

#include <utility>

#include "intrinsic/straightest.h"
#include "mesh/error.h"
#include "mesh/loop_subdivision.h"
#include "mesh/shapes.h"

namespace karcher::bindings {

MeshHandle::MeshHandle(ImportedMesh imported)
    : numbering_(std::move(imported.numbering)),
      droppedPositions_(std::move(imported.droppedPositions)),
      repairs_(std::move(imported.repairs)),
      mesh_(std::move(imported.mesh)),
      geometry_(buildGeometry(mesh_)) {}

val MeshHandle::info() const {
  const Topology shape = topology(mesh_);
  val repairs = val::array();
  for (int i = 0; i < repairs_.count(); ++i) {
    val repair = val::object();
    repair.set("kind", std::string(repairName(repairs_[i].kind)));
    repair.set("count", repairs_[i].count);
    repair.set("message", repairs_[i].sentence);
    repairs.set(i, repair);
  }
  val info = val::object();
  info.set("vertices", mesh_.vertexCount());
  info.set("triangles", mesh_.faceCount());
  info.set("components", shape.components);
  info.set("boundaryLoops", shape.boundaryLoops);
  info.set("genus", shape.genus);
  info.set("meanEdge", geometry_.meanEdge);
  info.set("diagonal", geometry_.diagonal);
  info.set("repairs", repairs);
  return info;
}

val MeshHandle::positions() const {
  Array<double> result;
  result.reserve(3 * numbering_.engineVertex.size());
  int dropped = 0;
  for (const int v : numbering_.engineVertex) {
    append(result, v < 0 ? droppedPositions_[dropped++] : mesh_.positions[v]);
  }
  return toJs(result);
}

val MeshHandle::triangles() const {
  Array<int> result;
  result.reserve(3 * numbering_.engineFace.size());
  for (const int f : numbering_.engineFace) {
    for (int k = 0; k < 3; ++k) result.push_back(numbering_.inputVertex[mesh_.corner(f, k)]);
  }
  return toJs(result);
}

std::unique_ptr<MeshHandle> MeshHandle::subdivided(int levels) const {
  constexpr int kMostLevels = 6;
  if (levels < 1 || levels > kMostLevels) {
    throw Error(ErrorCode::kBadArgument, "a mesh can be refined 1 to " +
                                             std::to_string(kMostLevels) + " times at once, not " +
                                             std::to_string(levels));
  }
  TriangleSoup soup = loopSubdivision(mesh_);
  for (int level = 1; level < levels; ++level) {
    soup = loopSubdivision(buildMesh(std::move(soup.positions), std::move(soup.triangles)));
  }
  return std::make_unique<MeshHandle>(importMesh(std::move(soup)));
}

val MeshHandle::checkedPoint(const val& point) const {
  return toJs(numbering_, pointFromJs(numbering_, mesh_, point));
}

val MeshHandle::vertexPoint(int vertex) const {
  return toJs(numbering_, karcher::vertexPoint(mesh_, engineVertex(numbering_, vertex)));
}

val MeshHandle::position(const val& point) const {
  return toJs(karcher::position(mesh_, pointFromJs(numbering_, mesh_, point)));
}

val MeshHandle::straightest(const val& from, const val& direction, double length) const {
  const SurfacePoint start = pointFromJs(numbering_, mesh_, from);
  const Array<double> space = fromJs<double>(direction);
  const Vec2 vector = toFace(geometry_, start.face, {space[0], space[1], space[2]});
  constexpr double kPerpendicular = 1e-12;
  const double norm = vector.norm();
  if (!(length >= 0)) throw Error(ErrorCode::kBadArgument, "a length must be at least 0");
  if (!(norm > kPerpendicular * std::hypot(space[0], space[1], space[2]))) {
    throw Error(ErrorCode::kBadArgument,
                "the direction of a geodesic must not be perpendicular to its first face");
  }
  const StraightestPath path = traceStraightest(geometry_, start, length / norm * vector);
  val result = val::object();
  result.set("end", toJs(numbering_, path.points.back()));
  result.set("remaining", path.remaining);
  result.set("polyline", toJs(polyline(mesh_, path.points)));
  return result;
}

std::unique_ptr<MeshHandle> meshFromObj(const val& bytes) {
  const Array<char> text = fromJs<char>(bytes);
  return std::make_unique<MeshHandle>(importObj({text.data(), text.size()}));
}

std::unique_ptr<MeshHandle> meshFromArrays(const val& positions, const val& triangles) {
  const Array<double> coordinates = fromJs<double>(positions);
  const Array<int> corners = fromJs<int>(triangles);
  TriangleSoup soup;
  for (int i = 0; i < coordinates.count(); i += 3) {
    soup.positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  for (int i = 0; i < corners.count(); i += 3) {
    soup.triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
  }
  return std::make_unique<MeshHandle>(importMesh(std::move(soup)));
}

std::unique_ptr<MeshHandle> builtInShape(const std::string& name, int triangles) {
  for (const Shape shape : kShapes) {
    if (name != shapeName(shape)) continue;
    return std::make_unique<MeshHandle>(importMesh(makeShape(shape, triangles)));
  }
  throw Error(ErrorCode::kBadArgument, "there is no shape '" + name + "'");
}

}  // namespace karcher::bindings
