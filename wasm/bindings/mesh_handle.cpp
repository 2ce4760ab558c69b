#include "bindings/mesh_handle.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "bindings/field_options.h"
#include "bindings/path.h"
#include "distance/shortest_path.h"
#include "intrinsic/straightest.h"
#include "mesh/error.h"
#include "mesh/loop_subdivision.h"
#include "mesh/shapes.h"

namespace karcher::bindings {
namespace {

void checkLevels(int levels) {
  constexpr int kMostLevels = 6;
  if (levels >= 1 && levels <= kMostLevels) return;
  throw Error(ErrorCode::kBadArgument, "a mesh can be refined 1 to " + std::to_string(kMostLevels) +
                                           " times at once, not " + std::to_string(levels));
}

Vec3 normalOf(const Geometry& geometry, int face) {
  return toSpace(geometry, face, {1, 0}).cross(toSpace(geometry, face, {0, 1}));
}

/// Whether a triangle with this entry in `engineFace` is a part of the surface.
bool isFace(const Numbering& numbering, int engineFace) {
  if (engineFace >= 0) return true;
  const FaceImage& image = numbering.images[-1 - engineFace];
  return !image.isDuplicate && !image.pieces.empty();
}

}  // namespace

MeshHandle::MeshHandle(ImportedMesh imported)
    : numbering_(std::move(imported.numbering)),
      droppedPositions_(std::move(imported.droppedPositions)),
      repairs_(std::move(imported.repairs)),
      surface_(std::move(imported.mesh)),
      fieldSets_(std::make_shared<FieldSets>(surface_)) {}

val MeshHandle::info() {
  const Topology shape = topology(mesh());
  val repairs = val::array();
  for (int i = 0; i < repairs_.count(); ++i) {
    val repair = val::object();
    repair.set("kind", std::string(repairName(repairs_[i].kind)));
    repair.set("count", repairs_[i].count);
    repair.set("message", repairs_[i].sentence);
    repairs.set(i, repair);
  }
  val info = val::object();
  info.set("vertices", mesh().vertexCount());
  info.set("triangles", mesh().faceCount());
  info.set("components", shape.components);
  info.set("boundaryLoops", shape.boundaryLoops);
  info.set("genus", shape.genus);
  info.set("meanEdge", surface_.geometry().meanEdge);
  info.set("diagonal", surface_.geometry().diagonal);
  info.set("repairs", repairs);
  return info;
}

val MeshHandle::positions() const {
  Array<double> result;
  result.reserve(3 * numbering_.engineVertex.size());
  int dropped = 0;
  for (const int v : numbering_.engineVertex) {
    append(result, v < 0 ? droppedPositions_[dropped++] : mesh().positions[v]);
  }
  return toJs(result);
}

val MeshHandle::triangles() const {
  Array<int> result;
  result.reserve(3 * numbering_.engineFace.size());
  for (int t = 0; t < numbering_.inputFaceCount(); ++t) {
    const Triangle corners = numbering_.inputCorners(mesh(), t);
    result.insert(result.end(), {corners[0], corners[1], corners[2]});
  }
  return toJs(result);
}

val MeshHandle::kept() const {
  Array<uint8_t> areFaces;
  areFaces.reserve(numbering_.engineFace.size());
  for (const int f : numbering_.engineFace) areFaces.push_back(isFace(numbering_, f) ? 1 : 0);
  Array<int> boundary;
  for (int h = 0; h < mesh().halfedgeCount(); ++h) {
    if (mesh().twin[h] >= 0) continue;
    boundary.push_back(numbering_.inputVertex[mesh().tail(h)]);
    boundary.push_back(numbering_.inputVertex[mesh().head(h)]);
  }
  val result = val::object();
  result.set("areFaces", toJs(areFaces));
  result.set("boundary", toJs(boundary));
  return result;
}

val MeshHandle::fans() const {
  const int vertices = numbering_.engineVertex.count();
  const Array<int> component = componentOfVertices(mesh());
  Array<int> numbers;
  Array<int> copies;
  Array<int> parts(numbering_.engineVertex.size(), -1);
  for (int v = 0; v < mesh().vertexCount(); ++v) {
    const int input = numbering_.inputVertex[v];
    if (numbering_.engineVertex[input] == v) {
      numbers.push_back(input);
      parts[input] = component[v];
    } else {
      numbers.push_back(vertices + copies.count());
      copies.push_back(input);
      parts.push_back(component[v]);
    }
  }
  Array<int> corners;
  corners.reserve(3 * numbering_.engineFace.size());
  for (int t = 0; t < numbering_.inputFaceCount(); ++t) {
    const Triangle own = numbering_.engineCorners(mesh(), t);
    const bool isThere = own.minCoeff() >= 0;
    for (const int v : own) corners.push_back(isThere ? numbers[v] : -1);
  }
  val result = val::object();
  result.set("corners", toJs(corners));
  result.set("copies", toJs(copies));
  result.set("parts", toJs(parts));
  return result;
}

val MeshHandle::marks() const {
  val parts = val::array();
  for (int i = 0; i < marks_.parts.count(); ++i) {
    val part = val::object();
    part.set("name", marks_.parts[i].name);
    part.set("triangles", marks_.parts[i].triangles);
    parts.set(i, part);
  }
  val materials = val::array();
  for (int i = 0; i < marks_.materials.count(); ++i) materials.set(i, marks_.materials[i]);
  const auto arrayOrNull = [](const auto& array) {
    return array.empty() ? val::null() : toJs(array);
  };
  val result = val::object();
  result.set("parts", parts);
  result.set("partOf", arrayOrNull(marks_.part));
  result.set("materials", materials);
  result.set("materialOf", arrayOrNull(marks_.material));
  result.set("colors", arrayOrNull(marks_.colors));
  val notRead = val::array();
  const int others = marks_.otherElements;
  if (others > 0) {
    notRead.set(
        0, std::to_string(others) + (others == 1 ? " element that is no face was left out."
                                                 : " elements that are no faces were left out."));
  }
  result.set("notRead", notRead);
  return result;
}

std::unique_ptr<MeshHandle> MeshHandle::subdivided(int levels) const {
  checkLevels(levels);
  TriangleSoup soup = loopSubdivision(mesh());
  for (int level = 1; level < levels; ++level) {
    soup = loopSubdivision(buildMesh(std::move(soup.positions), std::move(soup.triangles)));
  }
  return std::make_unique<MeshHandle>(importMesh(std::move(soup)));
}

val MeshHandle::carried(const val& points, int levels) const {
  checkLevels(levels);
  Array<double> wire;
  for (SurfacePoint point : pointsFromJs(numbering_, mesh(), points)) {
    // Face f becomes the faces 4 f + k at its corners k, and the face 4 f + 3 between the middles
    // of its edges (loop_subdivision.cpp). Doubling is exact, and subtraction from 1 loses at most
    // the last bit.
    for (int level = 0; level < levels; ++level) {
      const Vec3 bary = point.bary;
      int corner = 0;
      const double most = bary.maxCoeff(&corner);
      const int next = (corner + 1) % 3;
      const int last = (corner + 2) % 3;
      if (most >= 0.5) {
        point = {4 * point.face + corner, {2 * most - 1, 2 * bary[next], 2 * bary[last]}};
      } else {
        point = {4 * point.face + 3, {1 - 2 * bary[2], 1 - 2 * bary[0], 1 - 2 * bary[1]}};
      }
    }
    wire.push_back(point.face);
    append(wire, point.bary);
  }
  return toJs(wire);
}

val MeshHandle::checkedPoint(const val& point) const {
  return toJs(numbering_, pointFromJs(numbering_, mesh(), point));
}

val MeshHandle::position(const val& point) const {
  return toJs(karcher::position(mesh(), pointFromJs(numbering_, mesh(), point)));
}

val MeshHandle::positionsOf(const val& points) const {
  Array<double> places;
  for (const SurfacePoint& point : pointsFromJs(numbering_, mesh(), points)) {
    append(places, karcher::position(mesh(), point));
  }
  return toJs(places);
}

val MeshHandle::normal(const val& point) const {
  return toJs(normalOf(geometry(), pointFromJs(numbering_, mesh(), point).face));
}

val MeshHandle::frame(const val& point) const {
  const SurfacePoint own = pointFromJs(numbering_, mesh(), point);
  const int face = toInput(numbering_, own).face;
  const auto corner = [&](const Vec3& bary) {
    return karcher::position(mesh(), toEngine(numbering_, mesh(), face, bary));
  };
  const Vec3 along = (corner(Vec3::UnitY()) - corner(Vec3::UnitX())).normalized();
  const Vec3 normal = normalOf(geometry(), own.face);
  val axes = val::array();
  axes.set(0, toJs(along));
  axes.set(1, toJs(normal.cross(along)));
  axes.set(2, toJs(normal));
  return axes;
}

val MeshHandle::planes() const {
  Array<int> faces;
  for (const int v : numbering_.engineVertex) {
    faces.push_back(v < 0 ? -1 : toInput(numbering_, vertexPoint(mesh(), v)).face);
  }
  Array<uint8_t> turnedOver;
  for (int t = 0; t < numbering_.inputFaceCount(); ++t) {
    turnedOver.push_back(numbering_.isTurnedOver(t) ? 1 : 0);
  }
  val planes = val::object();
  planes.set("faceOf", toJs(faces));
  planes.set("turnedOver", toJs(turnedOver));
  return planes;
}

val MeshHandle::nearestPoint(const val& place) {
  if (!faceTree_) faceTree_.emplace(mesh());
  const Array<double> numbers = fromJs<double>(place);
  const FaceTree::Nearest nearest = faceTree_->nearest({numbers[0], numbers[1], numbers[2]});
  val result = val::object();
  result.set("point", toJs(numbering_, SurfacePoint{nearest.face, nearest.bary}));
  result.set("distance", nearest.distance);
  return result;
}

/// The direction of a vector in space, projected to a face: a unit vector in the face's frame.
Vec2 MeshHandle::directionInFace(int face, const val& direction) const {
  const Array<double> space = fromJs<double>(direction);
  const Vec2 vector = toFace(surface_.geometry(), face, {space[0], space[1], space[2]});
  constexpr double kPerpendicular = 1e-12;
  const double norm = vector.norm();
  const double length = std::hypot(space[0], space[1], space[2]);
  if (length == 0) throw Error(ErrorCode::kBadArgument, "the direction has length 0");
  if (!(norm > kPerpendicular * length)) {
    throw Error(ErrorCode::kBadArgument,
                "the direction is perpendicular to the face that it starts in");
  }
  return vector / norm;
}

val MeshHandle::straightest(const val& from, const val& direction, double length) const {
  const SurfacePoint start = pointFromJs(numbering_, mesh(), from);
  if (!(length >= 0)) {
    throw Error(ErrorCode::kBadArgument,
                "the length must be at least 0, not " + inSentence(length));
  }
  const Vec2 unit = directionInFace(start.face, direction);
  const StraightestPath path = traceStraightest(surface_.geometry(), start, length * unit);
  val result = val::object();
  result.set("end", toJs(numbering_, path.path.end()));
  result.set("remaining", path.remaining);
  result.set("stop", std::string(traceStopName(path.stop)));
  result.set("path", pathToJs(numbering_, mesh(), path.path.points, path.path.length()));
  return result;
}

val MeshHandle::shortestPath(const val& from, const val& to) const {
  const SurfacePath path =
      karcher::shortestPath(surface_.geometry(), pointFromJs(numbering_, mesh(), from),
                            pointFromJs(numbering_, mesh(), to));
  return pathToJs(numbering_, mesh(), path.points, path.length());
}

Array<double> MeshHandle::distancesFromPoints(const Array<SurfacePoint>& sources, const val& field,
                                              double radius) {
  Array<double> distances(static_cast<size_t>(mesh().vertexCount()), kInfinity);
  const auto solver = makeDistanceSolver(surface_, fieldOptionsFromJs(field));
  for (const SurfacePoint& source : sources) {
    solver->setSource(source);
    solver->grow(radius);
    for (int v = 0; v < distances.count(); ++v) {
      distances[v] = std::min(distances[v], solver->distance(v));
    }
  }
  return distances;
}

val MeshHandle::distance(const val& from, const val& field, double radius) {
  const Array<double> distances =
      distancesFromPoints(pointsFromJs(numbering_, mesh(), from), field, radius);
  Array<double> result;
  result.reserve(numbering_.engineVertex.size());
  for (const int v : nearestVertices(distances)) {
    const double distance = v < 0 ? kInfinity : distances[v];
    // Distances beyond the radius may not be final.
    const bool isKnown = distance < kInfinity && distance <= radius;
    result.push_back(isKnown ? distance : std::nan(""));
  }
  return toJs(result);
}

Array<int> MeshHandle::nearestVertices(const Array<double>& distances) const {
  // A vertex where fans of faces meet is several vertices of the engine.
  Array<int> nearest = numbering_.engineVertex;
  for (int v = 0; v < distances.count(); ++v) {
    int& least = nearest[numbering_.inputVertex[v]];
    if (distances[v] < distances[least]) least = v;
  }
  for (int v = 0; v < nearest.count(); ++v) {
    const int own = numbering_.engineVertex[v];
    if (own >= 0) nearest[v] = nearest[numbering_.inputVertex[own]];
  }
  return nearest;
}

std::unique_ptr<MeshHandle> meshFromObj(const val& bytes, const val& parts, bool repair,
                                        double weld) {
  ObjOptions options{repair, {}};
  if (!parts.isNull()) options.parts = fromJs<int>(parts);
  ObjContents contents;
  {
    const Array<char> text = fromJs<char>(bytes);
    contents = readObj({text.data(), text.size()}, options);
  }
  ObjMarks marks = std::move(contents.marks);
  auto mesh = std::make_unique<MeshHandle>(importObj(std::move(contents), {repair, weld}));
  mesh->setMarks(std::move(marks));
  return mesh;
}

namespace {

Array<Vec3> positionsOf(const Array<double>& coordinates) {
  Array<Vec3> positions;
  positions.reserve(coordinates.size() / 3);
  for (int i = 0; i < coordinates.count(); i += 3) {
    positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  return positions;
}

}  // namespace

std::unique_ptr<MeshHandle> meshFromPolygons(const val& positions, const val& corners,
                                             const val& sizes, bool repair, double weld) {
  PolygonSoup soup;
  soup.positions = positionsOf(fromJs<double>(positions));
  soup.corners = fromJs<int>(corners);
  soup.cornerCount = fromJs<int>(sizes);
  return std::make_unique<MeshHandle>(importPolygons(std::move(soup), {repair, weld}));
}

std::unique_ptr<MeshHandle> meshFromArrays(const val& positions, const val& triangles, bool repair,
                                           double weld) {
  const Array<double> coordinates = fromJs<double>(positions);
  const Array<int> corners = fromJs<int>(triangles);
  TriangleSoup soup;
  soup.positions = positionsOf(coordinates);
  for (int i = 0; i < corners.count(); i += 3) {
    soup.triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
  }
  return std::make_unique<MeshHandle>(importMesh(std::move(soup), {repair, weld}));
}

std::unique_ptr<MeshHandle> builtInShape(const std::string& name, int triangles) {
  for (const Shape shape : kShapes) {
    if (name != shapeName(shape)) continue;
    auto mesh = std::make_unique<MeshHandle>(importMesh(makeShape(shape, triangles)));
    mesh->setSmooth(curvatureBound(shape));
    return mesh;
  }
  throw Error(ErrorCode::kBadArgument, "there is no shape '" + name + "'");
}

}  // namespace karcher::bindings
