#include "rcm/voronoi.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "distance/window.h"
#include "mesh/error.h"
#include "mesh/rounding.h"

/// Sites are added one after the other. In each triangle the earlier sites have convex pieces. From
/// each piece, the new site takes the part that is nearer to the new site by more than rounding. A
/// corner of a piece is a vertex of the mesh, or it lies between two earlier corners, when a site
/// takes only one of the two. This pair of earlier corners names the new corner. So pieces on both
/// sides of an edge have the same corners, and no gap opens, whatever the rounding. Pieces of one
/// site are not merged, because other pieces share their corners.
namespace karcher {
namespace {

/// A convex part of a triangle, given by its corners in counterclockwise order.
struct Piece {
  int site = -1;
  Array<int> corners;

  int after(int i) const { return corners[(i + 1) % corners.count()]; }
};

/// The name of a pair of corners, the same in either order.
uint64_t nameOf(int a, int b) {
  return static_cast<uint64_t>(std::min(a, b)) << 32 | static_cast<uint64_t>(std::max(a, b));
}

class Pieces {
 public:
  Array<int> nearest;  ///< the nearest site of each vertex

  explicit Pieces(const TriangleMesh& mesh)
      : nearest(mesh.positions.size(), -1), mesh_(mesh), least_(mesh.positions.size(), kInfinity) {
    for (int v = 0; v < mesh.vertexCount(); ++v) corners_.push_back(vertexPoint(mesh, v));
    for (const Triangle& face : mesh.faces) pieces_.push_back({{-1, {face[0], face[1], face[2]}}});
  }

  /// Adds the next site by its distances to the vertices.
  void add(int site, const Array<double>& distances) {
    own_.clear();
    isNearer_.clear();
    for (const auto& [face, bary] : corners_) {
      double squared = 0;
      for (int k = 0; k < 3; ++k) {
        if (bary[k] > 0) squared += bary[k] * square(distances[mesh_.corner(face, k)]);
      }
      isNearer_.push_back(squared < (1 - kLocalRounding) * least_[own_.count()] ? 1 : 0);
      own_.push_back(squared);
    }
    for (Array<Piece>& pieces : pieces_) divide(pieces, site);
    for (int corner = 0; corner < own_.count(); ++corner) {
      if (isNearer_[corner] == 0) continue;
      least_[corner] = own_[corner];
      if (corner < nearest.count()) nearest[corner] = site;
    }
  }

  /// The sides between pieces of different sites.
  Array<SurfacePath> lines() const {
    Array<SurfacePath> found;
    std::unordered_map<uint64_t, int> siteBeside;
    for (const Array<Piece>& pieces : pieces_) {
      if (pieces.count() == 1) continue;
      siteBeside.clear();
      for (const Piece& piece : pieces) {
        for (int i = 0; i < piece.corners.count(); ++i) {
          const auto [from, to] = std::pair(piece.corners[i], piece.after(i));
          const auto [side, isFirst] = siteBeside.try_emplace(nameOf(from, to), piece.site);
          if (isFirst || side->second == piece.site) continue;
          found.push_back(pathThrough(mesh_, {corners_[from], corners_[to]}));
        }
      }
    }
    return found;
  }

  /// The site of the piece that holds a point.
  int siteAt(const SurfacePoint& point) const {
    const auto placeOf = [&](int corner) -> Vec2 {
      return inFace(mesh_, corners_[corner], point.face).bary.tail<2>();
    };
    int site = -1;
    double deepest = -kInfinity;
    for (const Piece& piece : pieces_[point.face]) {
      double depth = kInfinity;
      for (int i = 0; i < piece.corners.count(); ++i) {
        const Vec2 from = placeOf(piece.corners[i]);
        const Vec2 side = placeOf(piece.after(i)) - from;
        depth = std::min(depth, cross(side, point.bary.tail<2>() - from));
      }
      if (depth > deepest) {
        deepest = depth;
        site = piece.site;
      }
    }
    return site;
  }

 private:
  /// Gives to the new site the parts of a face's pieces that are nearer to the new site.
  void divide(Array<Piece>& pieces, int site) {
    const auto isNearer = [&](int corner) { return isNearer_[corner] != 0; };
    for (int i = pieces.count() - 1; i >= 0; --i) {
      if (std::none_of(pieces[i].corners.begin(), pieces[i].corners.end(), isNearer)) continue;
      const Piece piece = std::move(pieces[i]);
      Piece kept{piece.site, {}};
      Piece taken{site, {}};
      for (int k = 0; k < piece.corners.count(); ++k) {
        const auto [here, next] = std::pair(piece.corners[k], piece.after(k));
        (isNearer(here) ? taken : kept).corners.push_back(here);
        if (isNearer(here) == isNearer(next)) continue;
        kept.corners.push_back(cornerBetween(here, next));
        taken.corners.push_back(kept.corners.back());
      }
      pieces[i] = std::move(taken);
      if (!kept.corners.empty()) pieces.push_back(std::move(kept));
    }
  }

  /// The corner between two given corners at the point where the new site is as near as the nearest
  /// earlier site.
  int cornerBetween(int here, int next) {
    const auto [known, isNew] = between_.try_emplace(nameOf(here, next), corners_.count());
    if (!isNew) return known->second;
    const auto [a, b] = std::minmax(here, next);
    const double from = own_[a] - least_[a];
    const double part = std::clamp(from / (from - (own_[b] - least_[b])), 0.0, 1.0);
    corners_.push_back(pointBetween(mesh_, corners_[a], corners_[b], part));
    least_.push_back(least_[a] + part * (least_[b] - least_[a]));
    return known->second;
  }

  const TriangleMesh& mesh_;
  Array<SurfacePoint> corners_;  ///< the vertices, then the corners on edges and inside faces
  Array<double> least_;          ///< the squared distance from each corner to its nearest site
  Array<Array<Piece>> pieces_;   ///< the pieces of each face
  std::unordered_map<uint64_t, int> between_;
  // The new site's squared distance from each corner, and whether it is nearer than all earlier
  // sites.
  Array<double> own_;
  Array<char> isNearer_;
};

}  // namespace

VoronoiDiagram voronoi(const Geometry& geometry, DistanceSolver& solver,
                       const Array<Array<SurfacePoint>>& sites) {
  const TriangleMesh& mesh = *geometry.mesh;
  if (sites.empty()) {
    throw Error(ErrorCode::kTooFewPoints, "a Voronoi diagram needs at least one site");
  }
  Pieces pieces(mesh);
  for (int i = 0; i < sites.count(); ++i) {
    if (sites[i].empty()) {
      throw Error(ErrorCode::kTooFewPoints, "site " + std::to_string(i) + " has no points");
    }
    Array<double> least(mesh.positions.size(), kInfinity);
    for (const SurfacePoint& point : sites[i]) {
      const Array<double> distances = distancesFrom(solver, point, mesh.vertexCount());
      for (int v = 0; v < least.count(); ++v) least[v] = std::min(least[v], distances[v]);
    }
    pieces.add(i, least);
  }
  VoronoiDiagram diagram;
  diagram.arrangement = arrange(geometry, pieces.lines());
  diagram.areas.assign(sites.size(), 0);
  for (const SurfacePoint& inside : pointsInside(geometry, diagram.arrangement)) {
    const double area = diagram.arrangement.cellArea[diagram.siteOfCell.count()];
    diagram.siteOfCell.push_back(pieces.siteAt(inside));
    if (diagram.siteOfCell.back() >= 0) diagram.areas[diagram.siteOfCell.back()] += area;
  }
  diagram.nearest = std::move(pieces.nearest);
  return diagram;
}

Region cellOfSite(const VoronoiDiagram& diagram, int site) {
  if (site < 0 || site >= diagram.areas.count()) {
    const std::string count = std::to_string(diagram.areas.count());
    throw Error(ErrorCode::kBadIndex,
                "there is no site " + std::to_string(site) + ": the diagram has " + count);
  }
  Region region;
  for (const int of : diagram.siteOfCell) region.push_back(of == site ? 1 : 0);
  return region;
}

}  // namespace karcher
