#include "distance/find_path.h"

#include <algorithm>
#include <utility>

#include "distance/shortest_path.h"
#include "intrinsic/straighten.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The largest distance between points for the thorough searches, in mean edges.
constexpr double kNear = 100;

/// The weight (strip_search.h) of searches between points that are farther apart than kNear.
constexpr double kGreedyWeight = 1.2;

/// The length, in mean edges, of the pieces in which the search improves a path.
constexpr double kPiece = 24;

/// Whether a comes before b, in an order of a path's ends that depends neither on the path's
/// direction nor on the surface's position in space. It compares the largest and then the smallest
/// barycentric weights, then the total angles at the vertices with the largest weights, and last
/// the numbers of these vertices and of the faces.
bool isBefore(const Geometry& geometry, const SurfacePoint& a, const SurfacePoint& b) {
  const auto told = [&](const SurfacePoint& point) {
    int corner = 0;
    const double most = point.bary.maxCoeff(&corner);
    const int vertex = geometry.mesh->corner(point.face, corner);
    return std::pair(vertex, Vec3(most, point.bary.minCoeff(), geometry.totalAngle[vertex]));
  };
  const auto [vertexOfA, ofA] = told(a);
  const auto [vertexOfB, ofB] = told(b);
  for (int k = 0; k < 3; ++k) {
    if (std::abs(ofA[k] - ofB[k]) > kChainRounding) return ofA[k] < ofB[k];
  }
  return std::pair(vertexOfA, a.face) < std::pair(vertexOfB, b.face);
}

class PathFinder {
 public:
  PathFinder(const Geometry& geometry, FindPathWorkspace& workspace, SurfacePath& path)
      : geometry_(geometry), mesh_(*geometry.mesh), workspace_(workspace), path_(path) {}

  bool run(const SurfacePoint& from, const SurfacePoint& to) {
    const double chord = (position(mesh_, to) - position(mesh_, from)).norm();
    const bool isNear = chord <= kNear * geometry_.meanEdge;
    const double weight = isNear ? 1 : kGreedyWeight;
    length_ = kInfinity;
    if (!searchStrip(mesh_, from, to, {.maxFaces = mesh_.faceCount(), .weight = weight},
                     workspace_.strip.search, workspace_.strip.strip)) {
      return false;
    }
    take(from, to, false);
    if (!isNear) {
      searchPieces(0);
      searchPieces(0.5);
      return true;
    }
    searchStrip(mesh_, to, from, {.maxFaces = mesh_.faceCount(), .weight = weight},
                workspace_.strip.search, workspace_.strip.strip);
    take(to, from, true);
    searchTautStrip(geometry_, from, to, workspace_.taut, workspace_.strip.strip);
    take(from, to, false);
    searchTautStrip(geometry_, to, from, workspace_.taut, workspace_.strip.strip);
    take(to, from, true);
    searchPieces(0);
    searchPieces(0.5);
    return true;
  }

 private:
  /// Takes the path in the strip if it is shorter than the current one.
  void take(const SurfacePoint& from, const SurfacePoint& to, bool reversed) {
    Array<SurfacePoint>& points = workspace_.points;
    points.clear();
    points.push_back(from);
    const double length = appendShorterStripPath(geometry_, from, to, workspace_.strip, points);
    if (!(length < length_ * (1 - kLocalRounding))) return;
    length_ = length;
    if (reversed) std::reverse(points.begin(), points.end());
    path_.points.assign(points.begin(), points.end());
    measure(mesh_, path_);
  }

  /// Searches the path again in pieces of equal length. The first piece has `first` times this
  /// length, unless `first` is 0.
  void searchPieces(double first) {
    // A path has no length if its points lie at one place but share no face.
    if (!(path_.length() > 0)) return;
    const int count = std::max(1, static_cast<int>(path_.length() / (kPiece * geometry_.meanEdge)));
    const double step = path_.length() / count;
    SurfacePath& pieces = workspace_.pieces;
    pieces.points.clear();
    pieces.lengths.clear();
    double at = 0;
    for (double end = first > 0 ? first * step : step; at < path_.length(); end += step) {
      const double to = end < path_.length() - step / 4 ? end : path_.length();
      appendSearched(at, to, pieces);
      at = to;
    }
    straighten(geometry_, pieces, workspace_.strip);
    if (pieces.length() < path_.length() * (1 - kLocalRounding)) std::swap(pieces, path_);
  }

  /// Appends the part of the path between two lengths, or a shorter one that a search finds.
  void appendSearched(double from, double to, SurfacePath& out) {
    const SurfacePoint start = pointAlong(mesh_, path_, from);
    const SurfacePoint end = pointAlong(mesh_, path_, to);
    Array<SurfacePoint>& piece = workspace_.piece;
    piece.clear();
    piece.push_back(start);
    if (!haveCommonFace(mesh_, start, end) &&
        searchStrip(mesh_, start, end, {.maxFaces = mesh_.faceCount()}, workspace_.strip.search,
                    workspace_.strip.strip) &&
        appendShorterStripPath(geometry_, start, end, workspace_.strip, piece) <
            (to - from) * (1 - kLocalRounding)) {
      for (const SurfacePoint& point : piece) appendPoint(mesh_, point, out);
    } else {
      appendPart(mesh_, path_, from, to, out);
    }
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  FindPathWorkspace& workspace_;
  SurfacePath& path_;
  double length_ = kInfinity;
};

}  // namespace

bool findPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
              FindPathWorkspace& workspace, SurfacePath& out, const FindPathOptions& options) {
  const TriangleMesh& mesh = *geometry.mesh;
  if (haveCommonFace(mesh, from, to)) {
    out.points.assign({from, to});
    measure(mesh, out);
    return true;
  }
  // The search always starts at the same end, so that both directions find the same path.
  const bool backwards = isBefore(geometry, to, from);
  const SurfacePoint first = backwards ? to : from;
  const SurfacePoint last = backwards ? from : to;
  if (!PathFinder(geometry, workspace, out).run(first, last)) return false;
  if (options.certified) {
    const SurfacePath shortest = shortestPath(geometry, first, last);
    if (shortest.length() < out.length() * (1 - kLocalRounding)) {
      out.points = shortest.points;
    }
  }
  if (backwards) std::reverse(out.points.begin(), out.points.end());
  measure(mesh, out);
  return true;
}

}  // namespace karcher
