#include <cmath>

#include "bindings/mesh_handle.h"
#include "bindings/path.h"
#include "curves/offset.h"
#include "distance/path_distance.h"
#include "mesh/error.h"
#include "mesh/sorted_numbers.h"
#include "regions/cut.h"
#include "regions/region.h"

namespace karcher::bindings {
namespace {

/// The data from which JavaScript decides whether a point lies in a region. `share` tells for each
/// input triangle whether none, all or a part of it is inside. For triangles that are partly
/// inside, `sides` has the sides of the inner part, sorted by triangle. A side is four numbers: the
/// second and third weights of its start, and the second and third weights of its end. `triangles`
/// has the triangle of each side.
struct Inside {
  enum : uint8_t { kNone = 0, kAll = 1, kPart = 2 };
  Array<uint8_t> share;
  Array<int> triangles;
  Array<double> sides;
};

Inside insideOf(const TriangleMesh& mesh, const Numbering& numbering, const Arrangement& all,
                const Region& region) {
  Inside inside;
  inside.share.assign(static_cast<size_t>(numbering.inputFaceCount()), Inside::kNone);
  Array<int> faces;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    int in = 0;
    int out = 0;
    for (int h = all.firstOfFace[f]; h < all.firstOfFace[f + 1]; ++h) {
      ++(region[all.cell(h)] != 0 ? in : out);
    }
    if (in == 0) continue;
    const int triangle = numbering.inputFace[f];
    const bool isAll = out == 0 && numbering.engineFace[triangle] == f;
    inside.share[triangle] = isAll ? Inside::kAll : Inside::kPart;
    if (!isAll) faces.push_back(f);
  }
  sortNumbers(faces, [&](int a, int b) { return numbering.inputFace[a] < numbering.inputFace[b]; });
  const auto append = [&](const SurfacePoint& point) {
    inside.sides.push_back(point.bary[1]);
    inside.sides.push_back(point.bary[2]);
  };
  for (const int f : faces) {
    for (int h = all.firstOfFace[f]; h < all.firstOfFace[f + 1]; ++h) {
      if (region[all.cell(h)] == 0) continue;
      inside.triangles.push_back(numbering.inputFace[f]);
      append(toInput(numbering, vertexInFace(mesh, all, f, all.tail[h])));
      append(toInput(numbering, vertexInFace(mesh, all, f, all.head(h))));
    }
  }
  return inside;
}

val regionToJs(const Geometry& geometry, const Numbering& numbering, const Arrangement& all,
               const Region& region) {
  const TriangleMesh& mesh = *geometry.mesh;
  val result = val::object();
  val boundary = val::array();
  double perimeter = 0;
  int count = 0;
  for (const Array<int>& loop : boundaryOf(all, region)) {
    const SurfacePath path = pathOf(geometry, all, loop);
    perimeter += path.length();
    boundary.set(count++, pathToJs(numbering, mesh, path.points, path.length(), true));
  }
  const Inside inside = insideOf(mesh, numbering, all, region);
  result.set("area", areaOf(all, region));
  result.set("perimeter", perimeter);
  result.set("boundary", boundary);
  result.set("share", toJs(inside.share));
  result.set("triangles", toJs(inside.triangles));
  result.set("sides", toJs(inside.sides));
  return result;
}

Array<SurfacePath> pathsFromJs(const Numbering& numbering, const TriangleMesh& mesh,
                               const val& outlines) {
  Array<SurfacePath> paths;
  const int count = outlines["length"].as<int>();
  for (int i = 0; i < count; ++i) {
    paths.push_back({pointsFromJs(numbering, mesh, outlines[i]), {}});
  }
  return paths;
}

/// The region of a shape. `inside` holds a point inside, or the inner side of the first outline (1
/// for the left, 0 for the right), or nothing.
Region regionOf(const Geometry& geometry, const Numbering& numbering, const Arrangement& all,
                const PathRange& range, FillRule rule, const val& inside) {
  const Array<double> numbers = fromJs<double>(inside);
  if (numbers.count() == 1) {
    return enclosedBeside(all, range, rule, numbers[0] > 0 ? PathSide::kLeft : PathSide::kRight);
  }
  const TriangleMesh& mesh = *geometry.mesh;
  const Array<SurfacePoint> given = pointsFromJs(numbering, mesh, inside);
  std::optional<int> cell;
  if (!given.empty()) cell = all.cellOfPiece[pieceHolding(mesh, all, given[0])];
  return enclosed(all, range, rule, cell);
}

/// Whether a region lies left of the first outline.
bool isLeftOf(const Arrangement& all, const PathRange& range, FillRule rule, const Region& region) {
  const std::optional<int> left = cellBeside(all, range, rule, PathSide::kLeft);
  if (left) return region[*left] != 0;
  const std::optional<int> right = cellBeside(all, range, rule, PathSide::kRight);
  return !right || region[*right] == 0;
}

}  // namespace

val MeshHandle::regions(const val& outlines, const val& counts, const val& insides,
                        const std::string& rule, const std::string& combine) const {
  const Array<SurfacePath> paths = pathsFromJs(numbering_, mesh(), outlines);
  const Array<int> outlinesOf = fromJs<int>(counts);
  const FillRule fill = rule == "nonZero" ? FillRule::kNonZero : FillRule::kEvenOdd;
  const Arrangement all = arrange(geometry(), paths);
  Array<Region> regions;
  Array<int> areLeft;
  PathRange range;
  for (int i = 0; i < outlinesOf.count(); ++i) {
    range = {range.first + range.count, outlinesOf[i]};
    regions.push_back(regionOf(geometry(), numbering_, all, range, fill, insides[i]));
    areLeft.push_back(isLeftOf(all, range, fill, regions.back()) ? 1 : 0);
  }
  if (combine != "none") {
    const Boolean how = combine == "union"          ? Boolean::kUnion
                        : combine == "intersection" ? Boolean::kIntersection
                        : combine == "difference"   ? Boolean::kDifference
                                                    : Boolean::kExclusion;
    for (int i = 1; i < regions.count(); ++i) regions[0] = combined(regions[0], regions[i], how);
    regions.resize(1);
  }
  val result = val::array();
  for (int i = 0; i < regions.count(); ++i) {
    val one = regionToJs(geometry(), numbering_, all, regions[i]);
    if (combine == "none") one.set("isLeft", areLeft[i] != 0);
    result.set(i, one);
  }
  return result;
}

val MeshHandle::cut(const val& outlines, const val& report) const {
  // On large meshes, the fractions below are about the passed fractions of the time.
  const auto reached = [&](double done) {
    if (!report(done).as<bool>()) refuse("the cut was given up");
  };
  reached(0);
  const Array<SurfacePath> paths = pathsFromJs(numbering_, mesh(), outlines);
  const Arrangement all = arrange(geometry(), paths);
  reached(0.4);
  const CutSurface surface = cutApart(geometry(), all);
  reached(0.7);
  val result = val::array();
  int count = 0;
  for (const CutPart& part : partsOf(surface, all.cellCount())) {
    Array<double> positions;
    for (const Vec3& p : part.positions) append(positions, p);
    Array<int> triangles;
    for (const Triangle& t : part.triangles) triangles.insert(triangles.end(), {t[0], t[1], t[2]});
    Array<int> faces;
    for (const int f : part.faceOf) faces.push_back(numbering_.inputFace[f]);
    val one = val::object();
    one.set("positions", toJs(positions));
    one.set("triangles", toJs(triangles));
    one.set("faces", toJs(faces));
    result.set(count++, one);
  }
  reached(1);
  return result;
}

val MeshHandle::offset(const val& outlines, const val& distances, int side, int corners,
                       double miterLimit) const {
  const Array<SurfacePath> paths = pathsFromJs(numbering_, mesh(), outlines);
  const OffsetSide which = side > 0   ? OffsetSide::kLeft
                           : side < 0 ? OffsetSide::kRight
                                      : OffsetSide::kBoth;
  val list = val::array();
  int count = 0;
  const OffsetCorners how{static_cast<CornerShape>(corners), miterLimit};
  const Array<double> along = fromJs<double>(distances);
  for (const Isoline& line : offsetLines(geometry(), paths, along, which, how)) {
    list.set(count++, pathToJs(numbering_, mesh(), line.points, line.length, line.closed));
  }
  return list;
}

val MeshHandle::distanceFromPaths(const val& outlines, const val& points) const {
  Array<double> distances =
      distancesFromPaths(geometry(), pathsFromJs(numbering_, mesh(), outlines),
                         pointsFromJs(numbering_, mesh(), points));
  for (double& distance : distances) {
    if (distance == kInfinity) distance = std::nan("");
  }
  return toJs(distances);
}

}  // namespace karcher::bindings
