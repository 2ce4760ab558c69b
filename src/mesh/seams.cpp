#include "mesh/seams.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mesh/edges.h"
#include "mesh/near_points.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

/// The default tolerance is at most this number times the shortest edge, and at most kFloatRounding
/// times the diagonal.
constexpr double kNearPartOfEdge = 0.01;
/// The largest tolerance relative to the shortest edge, so that triangles keep their shape. It also
/// limits a caller's own tolerance.
constexpr double kMostPartOfEdge = 1.0 / 3;

class Seams {
 public:
  Seams(const Array<Vec3>& positions, const Array<int>& order, WorkFaces& faces,
        const SeamOptions& options, DisjointSets& target)
      : positions_(positions), order_(order), faces_(faces), options_(options), target_(target) {}

  SeamRepairs close() {
    findPlaces();
    if (options_.exact) {
      weldExactly();
      return std::move(repairs_);
    }
    Edges edges = findEdges();
    if (!edges.branching.empty() || !edges.mirrored.empty()) {
      if (leaveOutDuplicates(edges)) edges = findEdges();
    }
    if (!edges.boundary.empty() && options_.tolerance != 0 && joinNearPlaces(edges.boundary)) {
      edges = findEdges();
    }
    weld(edges);
    return std::move(repairs_);
  }

 private:
  /// Half-edges grouped by the places of their vertices.
  struct Edges {
    Array<int> boundary;                 ///< edges with one half-edge
    Array<int> branching;                ///< edges with more than two half-edges
    Array<std::array<int, 2>> mirrored;  ///< edges with two half-edges in the same direction
  };

  int placeAt(int h) const { return place_[faces_.corners[h / 3][h % 3]]; }

  void findPlaces() {
    place_.resize(positions_.size());
    std::iota(place_.begin(), place_.end(), 0);
    for (int i = 1; i < order_.count(); ++i) {
      if (positions_[order_[i]] == positions_[order_[i - 1]]) {
        place_[order_[i]] = place_[order_[i - 1]];
      }
    }
  }

  template <class Visit>
  void forEachEdgeByPlace(Visit&& visit) const {
    if (!placesDiffer()) return forEachEdge(faces_.corners, positions_.count(), visit);
    Array<Triangle> byPlace = faces_.corners;
    for (Triangle& t : byPlace) t = {place_[t[0]], place_[t[1]], place_[t[2]]};
    forEachEdge(byPlace, positions_.count(), visit);
  }

  /// Whether any two vertices share a place.
  bool placesDiffer() const {
    for (const int v : order_) {
      if (place_[v] != v) return true;
    }
    return false;
  }

  Edges findEdges() {
    Edges edges;
    forEachEdgeByPlace([&](int, std::span<const EdgeSide> sides) {
      const int h = sides[0].halfedge;
      if (sides.size() == 1) {
        edges.boundary.push_back(h);
      } else if (sides.size() > 2) {
        for (const EdgeSide& side : sides) edges.branching.push_back(side.halfedge);
      } else if (placeAt(h) == placeAt(sides[1].halfedge)) {
        edges.mirrored.push_back({h, sides[1].halfedge});
      }
    });
    return edges;
  }

  bool leaveOutDuplicates(const Edges& edges) {
    Array<int> suspects;
    Array<uint8_t> branches(faces_.corners.size(), 0);
    for (const int h : edges.branching) {
      suspects.push_back(h / 3);
      branches[h / 3] = 1;
    }
    for (const auto& [g, h] : edges.mirrored) {
      suspects.push_back(g / 3);
      suspects.push_back(h / 3);
    }
    const auto key = [&](int f) {
      const Triangle& t = faces_.corners[f];
      const Triangle places(place_[t[0]], place_[t[1]], place_[t[2]]);
      const int low = places.minCoeff();
      const int high = places.maxCoeff();
      return std::array<int, 3>{low, high, places.sum() - low - high};
    };
    sortNumbers(suspects, [&](int f, int g) { return key(f) < key(g); });
    suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
    Array<int> uses;
    Array<uint8_t> gone;
    for (int i = 0; i < suspects.count();) {
      const int first = suspects[i];
      int reversed = -1;  // the first face of the other orientation that stays
      for (++i; i < suspects.count() && key(suspects[i]) == key(first); ++i) {
        const int f = suspects[i];
        int kept = first;
        std::array<int, 3> corner = match(f, first);
        const bool turned = (corner[1] - corner[0] + 3) % 3 == 2;
        if (turned && reversed >= 0) {
          kept = reversed;
          corner = match(f, reversed);
        } else if (turned) {
          if (uses.empty()) uses = countUses();
          if (!branches[f] || !(hangsOnNone(f, uses) || sameVertices(f, first))) {
            reversed = f;
            continue;
          }
        }
        if (gone.empty()) gone.assign(faces_.corners.size(), 0);
        gone[f] = 1;
        for (int k = 0; k < 3; ++k) {
          const int other = corner[static_cast<size_t>(k)];
          target_.unite(faces_.corners[f][k], faces_.corners[kept][other]);
        }
        repairs_.duplicates.push_back({faces_.source[f], faces_.source[kept], corner});
      }
    }
    if (gone.empty()) return false;
    faces_.leaveOut([&](int f) { return gone[f] != 0; });
    faces_.renumber(target_.names());
    return true;
  }

  std::array<int, 3> match(int f, int kept) const {
    std::array<int, 3> corner = {};
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) {
        if (placeAt(3 * f + k) == placeAt(3 * kept + j)) corner[static_cast<size_t>(k)] = j;
      }
    }
    return corner;
  }

  Array<int> countUses() const {
    Array<int> uses(positions_.size(), 0);
    for (const Triangle& t : faces_.corners) {
      for (const int v : t) ++uses[v];
    }
    return uses;
  }

  bool hangsOnNone(int f, const Array<int>& uses) const {
    const Triangle& t = faces_.corners[f];
    return uses[t[0]] == 1 && uses[t[1]] == 1 && uses[t[2]] == 1;
  }

  /// Whether two faces at the same places have the same vertices.
  bool sameVertices(int f, int g) const {
    for (const int v : faces_.corners[f]) {
      if ((faces_.corners[g].array() != v).all()) return false;
    }
    return true;
  }

  /// Unites the places of boundary vertices that lie near each other.
  bool joinNearPlaces(const Array<int>& boundary) {
    Array<double> reach = shortestEdges(boundary);
    Array<int> points;
    double most = 0;
    for (int v = 0; v < reach.count(); ++v) {
      if (reach[v] == kInfinity) continue;
      reach[v] = options_.tolerance < 0
                     ? std::min(kFloatRounding * options_.diagonal, kNearPartOfEdge * reach[v])
                     : std::min(options_.tolerance, kMostPartOfEdge * reach[v]);
      most = std::max(most, reach[v]);
      points.push_back(v);
    }
    DisjointSets sets(positions_.count());
    if (!uniteNear(points, reach, most, sets)) return false;
    Array<int> joined = sets.names();
    // The function never merges two corners of a face. If a set of places would merge two corners,
    // all its places stay as they are.
    Array<uint8_t> torn(positions_.size(), 0);
    for (const Triangle& t : faces_.corners) {
      for (int k = 0; k < 3; ++k) {
        const int p = place_[t[k]];
        const int q = place_[t[(k + 1) % 3]];
        if (p != q && joined[p] == joined[q]) torn[joined[p]] = 1;
      }
    }
    for (int& place : place_) {
      if (!torn[joined[place]]) place = joined[place];
    }
    return true;
  }

  /// Unites points that lie within each other's reach; `most` is the greatest reach. Returns
  /// whether any points were united. Points in one small cube are all within each other's reach, so
  /// the function unites them without a comparison of pairs. So a large cluster does not take
  /// quadratic time.
  bool uniteNear(const Array<int>& points, const Array<double>& reach, double most,
                 DisjointSets& sets) const {
    double least = most;
    for (const int p : points) least = std::min(least, reach[p]);
    const PointGroups groups = groupsByCube(points, least);
    bool any = groups.first.count() < points.count();
    Array<int> numberOf(positions_.size(), -1);
    for (int i = 0; i < groups.first.count(); ++i) {
      numberOf[groups.first[i]] = i;
      for (const int p : groups.at(i)) sets.unite(groups.first[i], p);
    }
    const NearPoints near(positions_, groups.first, any ? most + 2 * least : most);
    for (const int p : groups.first) {
      near.forEachNear(p, [&](int q) {
        if (sets.find(p) == sets.find(q)) return;
        for (const int a : groups.at(numberOf[p])) {
          for (const int b : groups.at(numberOf[q])) {
            const double limit = std::min(reach[a], reach[b]);
            if ((positions_[a] - positions_[b]).squaredNorm() > limit * limit) continue;
            sets.unite(a, b);
            any = true;
            return;
          }
        }
      });
    }
    return any;
  }

  /// Points in groups: each group has the points in one cube.
  struct PointGroups {
    Array<int> points;  ///< the points, one group after the other
    Array<int> begin;   ///< the begin of each group, and the end of the last
    Array<int> first;   ///< the first point of each group

    std::span<const int> at(int i) const {
      return std::span(points).subspan(static_cast<size_t>(begin[i]),
                                       static_cast<size_t>(begin[i + 1] - begin[i]));
    }
  };

  /// Groups points by cubes. The cubes are so small that no two points in a cube are farther apart
  /// than `width`. If the cubes would be too many to number exactly, each point is a group.
  PointGroups groupsByCube(const Array<int>& points, double width) const {
    PointGroups groups;
    groups.points = points;
    const double side = width / 2;  // a side smaller than width / sqrt(3)
    Array<Vec3> cubes;
    double farthest = 0;
    for (const int p : points) {
      cubes.push_back((positions_[p] / side).array().floor());
      farthest = std::max(farthest, cubes.back().cwiseAbs().maxCoeff());
    }
    const bool hasCubes = side > 0 && farthest < 1 / std::numeric_limits<double>::epsilon();
    if (hasCubes) {
      const auto isBefore = [&](int i, int j) {
        const Vec3& a = cubes[i];
        const Vec3& b = cubes[j];
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
      };
      const Array<int> sorted = sortedNumbers(points.count(), isBefore);
      groups.points.clear();
      for (int k = 0; k < sorted.count(); ++k) {
        if (k == 0 || cubes[sorted[k]] != cubes[sorted[k - 1]]) groups.begin.push_back(k);
        groups.points.push_back(points[sorted[k]]);
      }
    } else {
      for (int k = 0; k < points.count(); ++k) groups.begin.push_back(k);
    }
    for (const int k : groups.begin) groups.first.push_back(groups.points[k]);
    groups.begin.push_back(points.count());
    return groups;
  }

  /// The length of the shortest edge at each place on a boundary; infinite elsewhere.
  Array<double> shortestEdges(const Array<int>& boundary) const {
    Array<uint8_t> on(positions_.size(), 0);
    for (const int h : boundary) {
      on[placeAt(h)] = 1;
      on[placeAt(h / 3 * 3 + (h + 1) % 3)] = 1;
    }
    Array<double> shortest(positions_.size(), kInfinity);
    for (const Triangle& t : faces_.corners) {
      for (int k = 0; k < 3; ++k) {
        const int p = place_[t[k]];
        const int q = place_[t[(k + 1) % 3]];
        if (!on[p] && !on[q]) continue;
        const double length = (positions_[p] - positions_[q]).norm();
        for (const int v : {p, q}) {
          if (on[v]) shortest[v] = std::min(shortest[v], length);
        }
      }
    }
    return shortest;
  }

  void weld(const Edges& edges) {
    if (!placesDiffer()) return;
    if (options_.tolerance != 0) {
      const DisjointSets before = target_;
      // Each round keeps at least one more place apart, so that the loop ends.
      do {
        target_ = before;
        repairs_.welded = 0;
        weldFacing();
        weldMirrored(edges);
      } while (keepWholeEdges());
      faces_.renumber(target_.names());
    }
    countKeptApart();
  }

  void weldExactly() {
    if (!placesDiffer()) return;
    const DisjointSets before = target_;
    const Array<Triangle> corners = faces_.corners;
    weldFacing();
    faces_.renumber(target_.names());
    bool all = true;
    forEachEdge(faces_.corners, positions_.count(), [&](int, std::span<const EdgeSide> sides) {
      all = all && isManifoldEdge(faces_.corners, sides);
    });
    if (!all) {
      target_ = before;
      faces_.corners = corners;
      repairs_.welded = 0;
    }
    countKeptApart();
  }

  /// Welds the vertices of edges whose two faces run along them in opposite directions.
  void weldFacing() {
    forEachEdgeByPlace([&](int, std::span<const EdgeSide> sides) {
      const int g = sides[0].halfedge;
      if (sides.size() != 2 || placeAt(g) == placeAt(sides[1].halfedge)) return;
      join(g, sides[1].halfedge);
    });
  }

  static int nextCorner(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  int vertexAt(int h) const { return faces_.corners[h / 3][h % 3]; }

  void unite(int v, int w) {
    if (!apart_.empty() && apart_[place_[v]]) return;
    repairs_.welded += target_.unite(v, w) ? 1 : 0;
  }

  /// Finds edges that two faces share in the file and that more faces would share after welding. A
  /// later repair might separate the two faces, so the function marks one end of the edge as
  /// unwelded. For example, a sheet and its copy of opposite orientation are welded along their
  /// rims. With the mark, they do not tear at an edge that joins two vertices of the rim. Returns
  /// whether the function marked any end.
  bool keepWholeEdges() {
    // the largest number of compared sides; the time grows with its square
    constexpr size_t kMostCompared = 64;
    Array<Triangle> joined = faces_.corners;
    for (Triangle& t : joined) t = {target_.find(t[0]), target_.find(t[1]), target_.find(t[2])};
    bool any = false;
    forEachEdge(joined, positions_.count(), [&](int, std::span<const EdgeSide> all) {
      if (all.size() < 3) return;
      const std::span<const EdgeSide> sides = all.first(std::min(all.size(), kMostCompared));
      const int first = sides[0].halfedge;
      bool isWhole = false;
      bool atTail = false;  // whether the file's vertices differ at the tail
      bool atHead = false;
      for (const EdgeSide& side : sides) {
        const int h = side.halfedge;
        const bool along = placeAt(h) == placeAt(first);
        atTail = atTail || vertexAt(along ? h : nextCorner(h)) != vertexAt(first);
        atHead = atHead || vertexAt(along ? nextCorner(h) : h) != vertexAt(nextCorner(first));
        for (const EdgeSide& other : sides) {
          isWhole = isWhole || (vertexAt(other.halfedge) == vertexAt(nextCorner(h)) &&
                                vertexAt(nextCorner(other.halfedge)) == vertexAt(h));
        }
      }
      const int tail = placeAt(first);
      const int head = placeAt(nextCorner(first));
      if (!isWhole || !(atTail || atHead)) return;
      if (apart_.empty()) apart_.assign(positions_.size(), 0);
      if ((atTail && apart_[tail]) || (atHead && apart_[head])) return;
      apart_[atTail && (!atHead || tail < head) ? tail : head] = 1;
      any = true;
    });
    return any;
  }

  /// Welds the vertices of two half-edges that lie along each other.
  void join(int g, int h) {
    const bool turned = placeAt(g) == placeAt(h);
    unite(vertexAt(g), vertexAt(turned ? h : nextCorner(h)));
    unite(vertexAt(nextCorner(g)), vertexAt(turned ? nextCorner(h) : h));
  }

  /// Welds pairs of half-edges in the same direction as long as the surface stays two-sided. Pairs
  /// whose vertices are welded already take precedence.
  void weldMirrored(const Edges& edges) {
    const auto isJoined = [&](const std::array<int, 2>& pair) {
      const auto same = [&](int v, int w) { return target_.find(v) == target_.find(w); };
      return same(vertexAt(pair[0]), vertexAt(pair[1])) &&
             same(vertexAt(nextCorner(pair[0])), vertexAt(nextCorner(pair[1])));
    };
    if (std::all_of(edges.mirrored.begin(), edges.mirrored.end(), isJoined)) return;
    OrientedSets sides(faces_.count());
    forEachEdgeByPlace([&](int, std::span<const EdgeSide> pair) {
      const int g = pair[0].halfedge;
      if (pair.size() != 2 || placeAt(g) == placeAt(pair[1].halfedge)) return;
      sides.unite(g / 3, pair[1].halfedge / 3, false);
    });
    for (const auto& pair : edges.mirrored) {
      if (isJoined(pair)) sides.unite(pair[0] / 3, pair[1] / 3, true);
    }
    for (const auto& pair : edges.mirrored) {
      if (!isJoined(pair) && sides.unite(pair[0] / 3, pair[1] / 3, true)) join(pair[0], pair[1]);
    }
  }

  void countKeptApart() {
    Array<uint8_t> vertexSeen(positions_.size(), 0);
    Array<uint8_t> placeSeen(positions_.size(), 0);
    for (const Triangle& t : faces_.corners) {
      for (const int v : t) {
        if (vertexSeen[v]) continue;
        vertexSeen[v] = 1;
        repairs_.keptApart += placeSeen[place_[v]];
        placeSeen[place_[v]] = 1;
      }
    }
  }

  const Array<Vec3>& positions_;
  const Array<int>& order_;
  WorkFaces& faces_;
  SeamOptions options_;
  DisjointSets& target_;
  Array<int> place_;  ///< the first vertex at each vertex's place
  /// whether the vertices of each place stay unwelded; empty if all are welded
  Array<uint8_t> apart_;
  SeamRepairs repairs_;
};

}  // namespace

SeamRepairs closeSeams(const Array<Vec3>& positions, const Array<int>& order, WorkFaces& faces,
                       const SeamOptions& options, DisjointSets& target) {
  return Seams(positions, order, faces, options, target).close();
}

}  // namespace karcher
