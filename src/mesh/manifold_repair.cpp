#include "mesh/manifold_repair.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

/// The repair pairs at most this many faces at one edge, and leaves further faces unpaired. The
/// time grows with the square of this number.
constexpr int kMostPaired = 64;

class ManifoldRepair {
 public:
  ManifoldRepair(TriangleMesh& mesh, Numbering& numbering) : mesh_(mesh), numbering_(numbering) {}

  ManifoldRepairs run() {
    if (!pairHalfedges()) {
      orient();
      pairHalfedges();
      pairBranching();
    }
    splitFans();
    if (!branching_.empty()) partSharedEdges();
    return repairs_;
  }

 private:
  bool sameDirection(int g, int h) const { return mesh_.tail(g) == mesh_.tail(h); }

  void pair(int g, int h) {
    mesh_.twin[g] = h;
    mesh_.twin[h] = g;
  }

  /// Pairs the half-edges of edges with two faces. Puts edges with more faces into `branching_`,
  /// and edges whose two half-edges have the same direction into `mirrored_`. Returns true if both
  /// are empty.
  bool pairHalfedges() {
    mesh_.twin.assign(static_cast<size_t>(mesh_.halfedgeCount()), -1);
    branching_.clear();
    mirrored_.clear();
    forEachEdge(mesh_.faces, mesh_.vertexCount(), [&](int, std::span<const EdgeSide> sides) {
      if (sides.size() == 1) return;
      const int g = sides[0].halfedge;
      const int h = sides[1].halfedge;
      if (sides.size() > 2) {
        branching_.emplace_back();
        for (const EdgeSide& side : sides) branching_.back().push_back(side.halfedge);
      } else if (sameDirection(g, h)) {
        mirrored_.push_back({g, h});
      } else {
        pair(g, h);
      }
    });
    return branching_.empty() && mirrored_.empty();
  }

  /// Turns faces over until the two half-edges of each edge with two faces are opposite. Finds the
  /// sets of faces that such edges connect.
  void orient() {
    OrientedSets sets(mesh_.faceCount());
    for (int h = 0; h < mesh_.halfedgeCount(); ++h) {
      if (mesh_.twin[h] > h) sets.unite(faceOf(h), faceOf(mesh_.twin[h]), false);
    }
    for (const auto& [g, h] : mirrored_) {
      if (!sets.unite(faceOf(g), faceOf(h), true)) throwOneSided(g, h);
    }
    Array<int> faces(mesh_.faces.size(), 0);
    Array<int> turned(mesh_.faces.size(), 0);
    part_.resize(mesh_.faces.size());
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      const auto place = sets.find(f);
      part_[f] = place.set;
      ++faces[place.set];
      turned[place.set] += place.turned;
    }
    // If both orientations have the same number of faces, the caller's first face keeps its
    // orientation.
    Array<int> first(mesh_.faces.size(), -1);
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      int& face = first[part_[f]];
      if (face < 0 || numbering_.inputFace[f] < numbering_.inputFace[face]) face = f;
    }
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      const int part = part_[f];
      const int others = faces[part] - turned[part];
      const bool turnTheTurned =
          turned[part] != others ? turned[part] < others : !sets.find(first[part]).turned;
      if (sets.find(f).turned == turnTheTurned) turnOver(f);
    }
  }

  void turnOver(int f) {
    ++repairs_.turnedOver;
    std::swap(mesh_.faces[f][1], mesh_.faces[f][2]);
    const int t = numbering_.inputFace[f];
    if (numbering_.engineFace[t] == f) {
      if (numbering_.turnedOver.empty())
        numbering_.turnedOver.assign(numbering_.engineFace.size(), 0);
      numbering_.turnedOver[t] = 1;
      return;
    }
    for (FacePiece& piece : numbering_.images[-1 - numbering_.engineFace[t]].pieces) {
      if (piece.face == f) std::swap(piece.corners[1], piece.corners[2]);
    }
  }

  [[noreturn]] void throwOneSided(int g, int h) const {
    throw Error(
        ErrorCode::kNotOrientable,
        "the surface has one side only, as a Möbius strip or a Klein bottle: faces " +
            std::to_string(numbering_.inputFace[faceOf(g)]) + " and " +
            std::to_string(numbering_.inputFace[faceOf(h)]) +
            " run along their edge in the same direction, and turning faces over only moves "
            "that elsewhere");
  }

  /// The unit vector perpendicular to half-edge h that points into the face of h. `along` is the
  /// direction of h.
  Vec3 awayFromEdge(int h, const Vec3& along) const {
    const Vec3 out = mesh_.positions[mesh_.opposite(h)] - mesh_.positions[mesh_.tail(h)];
    return (out - out.dot(along) * along).normalized();
  }

  void pairBranching() {
    atBranching_.assign(mesh_.positions.size(), 0);
    repairs_.branching = branching_.count();
    for (Array<int>& sides : branching_) {
      sortByFile(sides);
      atBranching_[mesh_.tail(sides[0])] = 1;
      atBranching_[mesh_.head(sides[0])] = 1;
      pairWidest(sides);
    }
  }

  void pairWidest(const Array<int>& sides) {
    const int h = sides[0];
    const Vec3 along =
        (mesh_.positions[mesh_.head(h)] - mesh_.positions[mesh_.tail(h)]).normalized();
    Array<Vec3> away;
    for (int i = 0; i < std::min(sides.count(), kMostPaired); ++i) {
      away.push_back(awayFromEdge(sides[i], along));
    }
    while (true) {
      // Among angles that are equal up to the file's rounding, the search prefers two faces that
      // other edges connect. Among pairs that are equal up to the rounding of this computation, it
      // takes the file's first pair.
      double best = kInfinity;
      int first = -1;
      int second = -1;
      for (int i = 0; i < away.count(); ++i) {
        for (int j = i + 1; j < away.count(); ++j) {
          if (mesh_.twin[sides[i]] >= 0 || mesh_.twin[sides[j]] >= 0) continue;
          if (sameDirection(sides[i], sides[j])) continue;
          const bool connected = part_[faceOf(sides[i])] == part_[faceOf(sides[j])];
          const double cosine = away[i].dot(away[j]) - (connected ? kFloatRounding : 0);
          if (cosine >= best - kChainRounding) continue;
          best = cosine;
          first = i;
          second = j;
        }
      }
      if (first < 0) return;
      pair(sides[first], sides[second]);
    }
  }

  /// Splits vertices with several fans. The fan whose face comes first in the file keeps the
  /// vertex. The engine's face numbers must not decide, since they depend on the mesh's position in
  /// space.
  void splitFans() {
    const int before = mesh_.vertexCount();
    connectVertices(mesh_);
    Array<uint8_t> seen(static_cast<size_t>(mesh_.halfedgeCount()), 0);
    const auto seeFan = [&](int v) {
      for (const int h : outgoingHalfedges(mesh_, v)) seen[h] = 1;
    };
    for (int v = 0; v < before; ++v) seeFan(v);
    Array<uint8_t> split;
    for (int h = 0; h < mesh_.halfedgeCount(); ++h) {
      if (seen[h]) continue;
      if (split.empty()) split.assign(static_cast<size_t>(before), 0);
      split[mesh_.tail(h)] = 1;
    }
    if (!split.empty()) {
      for (const int h : halfedgesByFile(split)) {
        const int v = mesh_.tail(h);
        if (v < before && split[v]) {
          split[v] = 0;
          if (atBranching_.empty() || !atBranching_[v]) ++repairs_.bowTies;
          for (const int own : outgoingHalfedges(mesh_, v)) seen[own] = 0;
          mesh_.outgoing[v] = firstOfFan(h);
          mesh_.onBoundary[v] = mesh_.twin[mesh_.outgoing[v]] < 0 ? 1 : 0;
          seeFan(v);
        } else if (!seen[h]) {
          addVertex(firstOfFan(h), v, seen);
        }
      }
    }
    if (!atBranching_.empty()) atBranching_.resize(mesh_.positions.size(), 1);
  }

  /// The half-edges that leave the chosen vertices, in the order of the file's faces.
  Array<int> halfedgesByFile(const Array<uint8_t>& chosen) const {
    Array<int> halfedges;
    for (int h = 0; h < mesh_.halfedgeCount(); ++h) {
      if (chosen[mesh_.tail(h)]) halfedges.push_back(h);
    }
    sortByFile(halfedges);
    return halfedges;
  }

  void sortByFile(Array<int>& halfedges) const {
    const auto place = [&](int h) { return numbering_.inputFace[faceOf(h)]; };
    sortNumbers(halfedges, [&](int g, int h) { return place(g) < place(h); });
  }

  /// The half-edge at the clockwise end of h's fan around its tail; h itself if the fan has no
  /// boundary.
  int firstOfFan(int h) const {
    int first = h;
    while (mesh_.twin[first] >= 0) {
      first = next(mesh_.twin[first]);
      if (first == h) break;
    }
    return first;
  }

  /// Adds a vertex at the position of v for the fan that starts at `first`.
  void addVertex(int first, int v, Array<uint8_t>& seen) {
    const int added = mesh_.vertexCount();
    mesh_.positions.push_back(Vec3(mesh_.positions[v]));
    mesh_.outgoing.push_back(first);
    mesh_.onBoundary.push_back(mesh_.twin[first] < 0 ? 1 : 0);
    numbering_.inputVertex.push_back(int(numbering_.inputVertex[v]));
    for (const int h : outgoingHalfedges(mesh_, added)) {
      mesh_.faces[faceOf(h)][cornerOf(h)] = added;
      seen[h] = 1;
    }
  }

  /// If one fan of faces meets two edges, these edges may have the same two vertices. This function
  /// separates the faces of such edges, so that the fan splits. Then it pairs the faces that still
  /// lie along each other.
  void partSharedEdges() {
    bool changed = true;
    for (int round = 0; changed && round < kMostPaired; ++round) {
      changed = false;
      forEachEdge(mesh_.faces, mesh_.vertexCount(), [&](int, std::span<const EdgeSide> sides) {
        if (sides.size() == 1) return;
        const int g = sides[0].halfedge;
        const int h = sides[1].halfedge;
        if (sides.size() == 2 && mesh_.twin[g] == h) return;
        changed = true;
        for (const EdgeSide& side : sides) mesh_.twin[side.halfedge] = -1;
        if (sides.size() == 2 && !sameDirection(g, h)) pair(g, h);
      });
      if (changed) splitFans();
    }
  }

  TriangleMesh& mesh_;
  Numbering& numbering_;
  ManifoldRepairs repairs_;
  Array<Array<int>> branching_;
  Array<std::array<int, 2>> mirrored_;
  Array<int> part_;  ///< the set of each face; edges with two faces connect the faces of a set
  /// 1 for each vertex at the end of an edge with more than two faces, and for added vertices
  Array<uint8_t> atBranching_;
};

}  // namespace

ManifoldRepairs connectRepaired(TriangleMesh& mesh, Numbering& numbering) {
  return ManifoldRepair(mesh, numbering).run();
}

}  // namespace karcher
