#include "regions/cut.h"

#include <map>
#include <utility>

#include "intrinsic/angles.h"
#include "mesh/disjoint_sets.h"
#include "mesh/error.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The triangles of a face, stored as the vertex opposite to each side. Vertices are numbered
/// within the face.
class FaceTriangles {
 public:
  using Side = std::pair<int, int>;

  /// The first three of `places` are the face's corners; `frame` has the same places in the face's
  /// frame.
  FaceTriangles(const Array<Vec2>& places, const Array<Vec2>& frame)
      : places_(places), frame_(frame) {
    add(0, 1, 2);
    for (int p = 3; p < places.count(); ++p) insert(p);
  }

  const std::map<Side, int>& opposite() const { return opposite_; }

  void addLine(int from, int to) {
    lines_.emplace(std::minmax(from, to), 0);
    Array<Side> crossed = sidesAcross(from, to);
    // A flip may leave a side that crosses the line, and sides of nonconvex quads return to the end
    // of the list. So the number of steps may be quadratic.
    const int64_t most = 100 + int64_t{4} * crossed.count() * crossed.count();
    for (int i = 0; i < crossed.count(); ++i) {
      if (i == most) refuse("a face could not be cut into triangles");
      const auto [a, b] = crossed[i];
      const int c = opposite_.at({a, b});
      const int d = opposite_.at({b, a});
      if (!isConvex(a, b, c, d)) {
        crossed.push_back({a, b});
        continue;
      }
      flip(a, b, c, d);
      if (c == from || c == to || d == from || d == to) continue;
      if ((left(from, to, c) > 0) != (left(from, to, d) > 0)) crossed.push_back({c, d});
    }
  }

  /// Flips sides that are not lines until the triangulation is Delaunay.
  void improve() {
    const int most = 10 + places_.count();
    for (int round = 0; round < most; ++round) {
      Array<Side> sides;
      for (const auto& [side, apex] : opposite_) {
        if (side.first < side.second && lines_.count(side) == 0) sides.push_back(side);
      }
      bool flipped = false;
      for (const auto& [a, b] : sides) {
        const auto one = opposite_.find({a, b});
        const auto other = opposite_.find({b, a});
        if (one == opposite_.end() || other == opposite_.end()) continue;
        const int c = one->second;
        const int d = other->second;
        if (!isConvex(a, b, c, d) || !isThin(a, b, c, d)) continue;
        flip(a, b, c, d);
        flipped = true;
      }
      if (!flipped) return;
    }
  }

 private:
  double left(int a, int b, int c) const { return leftOf(places_[a], places_[b], places_[c]); }

  void add(int a, int b, int c) {
    opposite_[{a, b}] = c;
    opposite_[{b, c}] = a;
    opposite_[{c, a}] = b;
  }

  void remove(int a, int b, int c) {
    for (const Side& side : {Side(a, b), Side(b, c), Side(c, a)}) opposite_.erase(side);
  }

  void insert(int p) {
    for (const auto& [side, c] : opposite_) {
      const auto [a, b] = side;
      const double toC = left(a, b, p);
      const double toA = left(b, c, p);
      const double toB = left(c, a, p);
      // The place lies on at most one side of the triangle. The loop visits each triangle from each
      // of its sides, so that one visit has this side as (a, b).
      if (toC < 0 || toA <= 0 || toB <= 0) continue;
      const int apex = c;
      if (toC > 0) {
        remove(a, b, apex);
        add(a, b, p);
        add(b, apex, p);
        add(apex, a, p);
        return;
      }
      const auto across = opposite_.find({b, a});
      const int d = across == opposite_.end() ? -1 : across->second;
      const Side cut = side;
      remove(cut.first, cut.second, apex);
      add(cut.first, p, apex);
      add(p, cut.second, apex);
      if (d < 0) return;
      remove(cut.second, cut.first, d);
      add(cut.second, p, d);
      add(p, cut.first, d);
      return;
    }
    refuse("a face could not be cut into triangles");
  }

  /// The sides that a line between two vertices crosses.
  Array<Side> sidesAcross(int from, int to) const {
    Array<Side> crossed;
    if (opposite_.count({from, to}) + opposite_.count({to, from}) > 0) return crossed;
    Side here(-1, -1);
    for (const auto& [side, apex] : opposite_) {
      if (apex == from && left(from, to, side.first) < 0 && left(from, to, side.second) > 0) {
        here = side;
      }
    }
    for (int i = 0; i < static_cast<int>(opposite_.size()) && here.first >= 0; ++i) {
      crossed.push_back(here);
      const auto [right, leftEnd] = here;
      const auto beyond = opposite_.find({leftEnd, right});
      if (beyond == opposite_.end()) break;
      const int apex = beyond->second;
      if (apex == to) return crossed;
      here = left(from, to, apex) > 0 ? Side(right, apex) : Side(apex, leftEnd);
    }
    refuse("a face could not be cut into triangles");
  }

  /// Whether the triangles on both sides of (a, b) form a convex quad.
  bool isConvex(int a, int b, int c, int d) const { return left(d, b, c) > 0 && left(c, a, d) > 0; }

  /// Whether the angles opposite to (a, b) sum to more than pi.
  bool isThin(int a, int b, int c, int d) const {
    const auto angle = [&](int apex) {
      return angleBetween(frame_[a] - frame_[apex], frame_[b] - frame_[apex]);
    };
    return angle(c) + angle(d) > kPi + kChainRounding;
  }

  void flip(int a, int b, int c, int d) {
    remove(a, b, c);
    remove(b, a, d);
    add(d, b, c);
    add(c, a, d);
  }

  const Array<Vec2>& places_;
  const Array<Vec2>& frame_;
  std::map<Side, int> opposite_;
  std::map<Side, int> lines_;
};

class Cutter {
 public:
  Cutter(const Geometry& geometry, const Arrangement& all)
      : geometry_(geometry),
        mesh_(*geometry.mesh),
        all_(all),
        corners_(all.halfedgeCount()),
        vertexOf_(static_cast<size_t>(all.halfedgeCount()), -1) {}

  CutSurface cut() {
    Array<uint8_t> isDrawn(static_cast<size_t>(all_.halfedgeCount()), 0);
    for (const PathUse& use : all_.uses) {
      isDrawn[use.halfedge] = 1;
      if (all_.twin[use.halfedge] >= 0) isDrawn[all_.twin[use.halfedge]] = 1;
    }
    // Corners at a vertex merge unless a path separates them.
    for (int h = 0; h < all_.halfedgeCount(); ++h) {
      if (isDrawn[h] == 0 && all_.twin[h] >= 0) corners_.unite(h, all_.next[all_.twin[h]]);
    }
    for (int f = 0; f < mesh_.faceCount(); ++f) cutFace(f);
    return std::move(surface_);
  }

 private:
  /// The vertex for the corner at a half-edge's tail.
  int vertexAt(int h) {
    const int corner = corners_.find(h);
    if (vertexOf_[corner] < 0) {
      vertexOf_[corner] = surface_.positions.count();
      surface_.positions.push_back(positionOf(all_.tail[h]));
    }
    return vertexOf_[corner];
  }

  Vec3 positionOf(int vertex) const {
    if (vertex < all_.meshVertices) return mesh_.positions[vertex];
    // All corners at the vertex use the same face, so that their positions are equal.
    const int f = all_.added[vertex - all_.meshVertices].face;
    return position(mesh_, vertexInFace(mesh_, all_, f, vertex));
  }

  void addTriangle(int f, int a, int b, int c) {
    surface_.triangles.push_back({vertexAt(a), vertexAt(b), vertexAt(c)});
    surface_.faceOf.push_back(f);
    surface_.cellOf.push_back(all_.cell(a));
  }

  void cutFace(int f) {
    const int first = all_.firstOfFace[f];
    const int end = all_.firstOfFace[f + 1];
    if (end - first == 3) {
      addTriangle(f, first, first + 1, first + 2);
      return;
    }
    // The face's corners have the numbers 0 to 2.
    std::map<int, int> numberOf;
    Array<Vec2> places;
    Array<Vec2> frame;
    const auto number = [&](int vertex) {
      const auto [it, isNew] = numberOf.emplace(vertex, places.count());
      if (isNew) {
        places.push_back(placeIn(mesh_, all_.added, f, vertex));
        frame.push_back(inFrame(geometry_, f, places.back()));
      }
      return it->second;
    };
    for (int k = 0; k < 3; ++k) number(mesh_.corner(f, k));
    std::map<std::pair<int, int>, int> halfedgeOf;
    for (int h = first; h < end; ++h) {
      const int tail = number(all_.tail[h]);
      halfedgeOf[{tail, number(all_.head(h))}] = h;
    }
    FaceTriangles triangles(places, frame);
    for (const auto& [side, h] : halfedgeOf) triangles.addLine(side.first, side.second);
    triangles.improve();
    for (const auto& [side, c] : triangles.opposite()) {
      const auto [a, b] = side;
      if (a > b || a > c) continue;
      const auto corner = [&](int v, int w) { return cornerOf(triangles, halfedgeOf, v, w); };
      addTriangle(f, corner(a, b), corner(b, c), corner(c, a));
    }
  }

  /// The half-edge at v whose corner contains the triangle with the side (v, w): the first one on
  /// or to the right of (v, w).
  static int cornerOf(const FaceTriangles& triangles,
                      const std::map<std::pair<int, int>, int>& halfedgeOf, int v, int w) {
    const int most = static_cast<int>(triangles.opposite().size());
    for (int i = 0; i <= most; ++i) {
      const auto halfedge = halfedgeOf.find({v, w});
      if (halfedge != halfedgeOf.end()) return halfedge->second;
      w = triangles.opposite().at({w, v});
    }
    refuse("a face could not be cut into triangles");
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const Arrangement& all_;
  DisjointSets corners_;
  Array<int> vertexOf_;
  CutSurface surface_;
};

}  // namespace

CutSurface cutApart(const Geometry& geometry, const Arrangement& arrangement) {
  return Cutter(geometry, arrangement).cut();
}

Array<CutPart> partsOf(const CutSurface& surface, int cellCount) {
  Array<CutPart> parts(static_cast<size_t>(cellCount));
  // Each vertex belongs to one cell.
  Array<int> numbers(surface.positions.size(), -1);
  for (int t = 0; t < surface.triangles.count(); ++t) {
    CutPart& part = parts[surface.cellOf[t]];
    Triangle triangle;
    for (int k = 0; k < 3; ++k) {
      const int v = surface.triangles[t][k];
      if (numbers[v] < 0) {
        numbers[v] = part.positions.count();
        part.positions.push_back(surface.positions[v]);
      }
      triangle[k] = numbers[v];
    }
    part.triangles.push_back(triangle);
    part.faceOf.push_back(surface.faceOf[t]);
  }
  return parts;
}

}  // namespace karcher
