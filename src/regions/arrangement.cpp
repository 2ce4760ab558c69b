#include "regions/arrangement.h"

#include <algorithm>
#include <utility>

#include "mesh/disjoint_sets.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

/// A half-edge that leaves a vertex, in a face.
struct Leaving {
  int vertex;
  int rank;  ///< -1 on a side of the face, else 0 or 1 for the half-plane of the direction
  Vec2 direction;
  int halfedge;
};

bool isBefore(const Leaving& a, const Leaving& b) {
  if (a.vertex != b.vertex) return a.vertex < b.vertex;
  if (a.rank != b.rank) return a.rank < b.rank;
  const double turn = exactCross(a.direction, b.direction);
  return turn != 0 ? turn > 0 : a.halfedge < b.halfedge;
}

/// A loop of half-edges in a face.
struct Loop {
  int first;
  double area;     ///< twice the loop's area in the face's own coordinates
  bool isOutside;  ///< whether the loop runs around isolated lines
};

class Builder {
 public:
  Builder(const Geometry& geometry, Drawing drawing)
      : geometry_(geometry), mesh_(*geometry.mesh), drawing_(std::move(drawing)) {
    all_.meshVertices = drawing_.meshVertices;
    all_.paths = drawing_.paths;
    all_.added = std::move(drawing_.added);
    sideStart_.resize(static_cast<size_t>(mesh_.halfedgeCount()));
  }

  Arrangement build() {
    // Most faces have no lines, so that they have three half-edges and one piece.
    const size_t faces = static_cast<size_t>(mesh_.faceCount());
    const size_t halfedges = 3 * faces + 4 * all_.added.size();
    for (Array<int>* array : {&all_.tail, &all_.next, &all_.twin, &all_.piece}) {
      array->reserve(halfedges);
    }
    all_.firstOfFace.reserve(faces + 1);
    all_.faceOfPiece.reserve(faces + all_.added.size());
    all_.pieceArea.reserve(faces + all_.added.size());
    for (int f = 0; f < mesh_.faceCount(); ++f) addFace(f);
    all_.firstOfFace.push_back(all_.tail.count());
    for (int h = 0; h < mesh_.halfedgeCount(); ++h) joinSides(h);
    for (const DrawnEdge& edge : drawing_.edges) addUses(edge);
    joinCells();
    return std::move(all_);
  }

 private:
  const DrawnEdge* edgeOf(int side) const {
    const int number = drawing_.edgeOf[drawnHalfedge(mesh_, side)];
    return number < 0 ? nullptr : &drawing_.edges[number];
  }

  /// The position of a half-edge's tail in the current face.
  const Vec2& placeOf(int h) const { return places_[h - first_]; }

  int addHalfedge(int tail, int twin) {
    all_.tail.push_back(tail);
    all_.next.push_back(all_.tail.count());
    all_.twin.push_back(twin);
    all_.piece.push_back(-1);
    return all_.tail.count() - 1;
  }

  int addPiece(int f, double area) {
    all_.faceOfPiece.push_back(f);
    all_.pieceArea.push_back(area);
    return all_.pieceCount() - 1;
  }

  void addFace(int f) {
    const int first = all_.tail.count();
    all_.firstOfFace.push_back(first);
    for (int side = 3 * f; side < 3 * f + 3; ++side) {
      sideStart_[side] = addHalfedge(mesh_.tail(side), -1);
      const DrawnEdge* edge = edgeOf(side);
      if (edge == nullptr) continue;
      const int count = edge->vertices.count();
      for (int i = 0; i < count; ++i) {
        addHalfedge(edge->vertices[edge->halfedge == side ? i : count - 1 - i], -1);
      }
    }
    const int end = all_.tail.count();
    all_.next[end - 1] = first;
    const int number = drawing_.faceOf[f];
    if (number >= 0 && !drawing_.faces[number].pieces.empty()) {
      addLines(drawing_.faces[number]);
      first_ = first;
      places_.clear();
      for (int h = first; h < all_.tail.count(); ++h) {
        places_.push_back(placeIn(mesh_, all_.added, f, all_.tail[h]));
      }
      linkFace(first, end);
      cutIntoPieces(f, first);
      return;
    }
    const int piece = addPiece(f, doubleArea(geometry_, f) / 2);
    for (int h = first; h < end; ++h) all_.piece[h] = piece;
  }

  /// Adds two half-edges for each line. All pieces of paths on the line share them.
  void addLines(const DrawnFace& face) {
    Array<DrawnPiece>& pieces = pieces_;
    pieces = face.pieces;
    const auto ends = [](const DrawnPiece& piece) { return std::minmax(piece.from, piece.to); };
    sortItems(pieces, [&](const DrawnPiece& a, const DrawnPiece& b) {
      return std::pair<int, int>(ends(a)) < std::pair<int, int>(ends(b));
    });
    std::pair<int, int> last(-1, -1);
    int line = -1;
    for (const DrawnPiece& piece : pieces) {
      const std::pair<int, int> here(ends(piece));
      if (here != last) {
        line = addHalfedge(here.first, all_.tail.count() + 1);
        addHalfedge(here.second, line);
        last = here;
      }
      all_.uses.push_back({line, piece.path, piece.order, piece.from == here.first ? 1 : -1});
    }
  }

  /// Links each half-edge to the next one of its loop: at its head, the first half-edge clockwise
  /// from its reverse.
  void linkFace(int first, int end) {
    Array<Leaving>& leaving = leaving_;
    leaving.clear();
    for (int h = first; h < all_.tail.count(); ++h) {
      // Half-edges on the sides come first at their vertices, since all others lie left of them.
      const bool isSide = h < end;
      const Vec2 from = placeOf(h);
      const Vec2 way = isSide ? Vec2::Zero().eval() : (placeOf(all_.twin[h]) - from).eval();
      const bool onSide = from.x() == 0 || from.y() == 0 || from.x() + from.y() == 1;
      const bool isUpper = way.y() > 0 || (way.y() == 0 && way.x() > 0);
      leaving.push_back({all_.tail[h], isSide ? -1 : onSide || isUpper ? 0 : 1, way, h});
    }
    sortItems(leaving, isBefore);
    for (int i = 0; i < leaving.count();) {
      int last = i;
      while (last + 1 < leaving.count() && leaving[last + 1].vertex == leaving[i].vertex) ++last;
      const bool isSide = leaving[i].rank < 0;
      // The other half-edges lie to the left of the arriving side.
      if (isSide) all_.next[previousSide(first, end, leaving[i].halfedge)] = leaving[last].halfedge;
      for (int j = isSide ? i + 1 : i; j <= last; ++j) {
        all_.next[all_.twin[leaving[j].halfedge]] = leaving[j > i ? j - 1 : last].halfedge;
      }
      i = last + 1;
    }
  }

  static int previousSide(int first, int end, int h) { return h == first ? end - 1 : h - 1; }

  Loop walk(int start, int name, Array<int>& loopOf) const {
    Loop loop{start, 0, false};
    const Vec2 origin = placeOf(start);
    Vec2 lowest = origin;
    int h = start;
    do {
      loopOf[h - first_] = name;
      const Vec2 a = placeOf(h);
      const Vec2 b = placeOf(all_.next[h]);
      loop.area += cross(a - origin, b - origin);
      if (std::pair(a.x(), a.y()) < std::pair(lowest.x(), lowest.y())) lowest = a;
      h = all_.next[h];
    } while (h != start);
    // A loop runs around isolated lines if, at its leftmost vertex, one of its corners contains the
    // direction to the left.
    do {
      const int after = all_.next[h];
      const Vec2 corner = placeOf(after);
      if (corner == lowest) {
        const Vec2 back = placeOf(h) - corner;
        const Vec2 way = placeOf(all_.next[after]) - corner;
        if (!(exactCross(way, back) > 0)) loop.isOutside = true;
      }
      h = after;
    } while (h != start);
    return loop;
  }

  /// Whether a place lies within a loop, by the number of the loop's lines to the left of the
  /// place. The leftmost vertex of a loop is never within it.
  bool holds(const Loop& loop, const Vec2& place) const {
    bool inside = false;
    int h = loop.first;
    do {
      const Vec2 a = placeOf(h);
      const Vec2 b = placeOf(all_.next[h]);
      if ((a.y() <= place.y()) != (b.y() <= place.y())) {
        const double left = leftOf(a, b, place);
        if (a.y() < b.y() ? left < 0 : left > 0) inside = !inside;
      }
      h = all_.next[h];
    } while (h != loop.first);
    return inside;
  }

  void cutIntoPieces(int f, int first) {
    Array<int>& loopOf = loopOf_;
    Array<Loop>& loops = loops_;
    loopOf.assign(static_cast<size_t>(all_.tail.count() - first), -1);
    loops.clear();
    for (int h = first; h < all_.tail.count(); ++h) {
      if (loopOf[h - first] < 0) loops.push_back(walk(h, loops.count(), loopOf));
    }
    const double scale = doubleArea(geometry_, f) / 2;
    Array<int>& pieceOfLoop = pieceOfLoop_;
    pieceOfLoop.assign(loops.size(), -1);
    for (int i = 0; i < loops.count(); ++i) {
      if (!loops[i].isOutside) pieceOfLoop[i] = addPiece(f, scale * loops[i].area);
    }
    for (int i = 0; i < loops.count(); ++i) {
      if (!loops[i].isOutside) continue;
      // The smallest loop around the leftmost vertex of loop i gives the piece.
      const Vec2 place = leftmost(loops[i]);
      int around = -1;
      for (int j = 0; j < loops.count(); ++j) {
        if (loops[j].isOutside || (around >= 0 && loops[j].area >= loops[around].area)) continue;
        if (holds(loops[j], place)) around = j;
      }
      pieceOfLoop[i] = pieceOfLoop[around];
      all_.pieceArea[pieceOfLoop[i]] += scale * loops[i].area;
    }
    for (int h = first; h < all_.tail.count(); ++h) all_.piece[h] = pieceOfLoop[loopOf[h - first]];
  }

  Vec2 leftmost(const Loop& loop) const {
    Vec2 place = placeOf(loop.first);
    int h = loop.first;
    do {
      const Vec2 here = placeOf(h);
      if (std::pair(here.x(), here.y()) < std::pair(place.x(), place.y())) place = here;
      h = all_.next[h];
    } while (h != loop.first);
    return place;
  }

  int sideCount(int side) const {
    const DrawnEdge* edge = edgeOf(side);
    return edge == nullptr ? 1 : edge->vertices.count() + 1;
  }

  void joinSides(int side) {
    const int other = mesh_.twin[side];
    if (other < 0) return;
    const int count = sideCount(side);
    for (int i = 0; i < count; ++i) {
      all_.twin[sideStart_[side] + i] = sideStart_[other] + count - 1 - i;
    }
  }

  void addUses(const DrawnEdge& edge) {
    for (const DrawnPiece& piece : edge.pieces) {
      const auto indexOf = [&](int vertex) {
        if (vertex == mesh_.tail(edge.halfedge)) return 0;
        const auto it = std::find(edge.vertices.begin(), edge.vertices.end(), vertex);
        return static_cast<int>(it - edge.vertices.begin()) + 1;
      };
      const int from = indexOf(piece.from);
      const int to = indexOf(piece.to);
      const int h = sideStart_[edge.halfedge] + std::min(from, to);
      const int twin = all_.twin[h];
      const bool isSmaller = twin < 0 || h < twin;
      const int sign = from < to ? 1 : -1;
      all_.uses.push_back(
          {isSmaller ? h : twin, piece.path, piece.order, isSmaller ? sign : -sign});
    }
  }

  void joinCells() {
    sortItems(all_.uses,
              [](const PathUse& a, const PathUse& b) { return a.halfedge < b.halfedge; });
    Array<uint8_t> isDrawn(static_cast<size_t>(all_.halfedgeCount()), 0);
    for (const PathUse& use : all_.uses) isDrawn[use.halfedge] = 1;
    DisjointSets sets(all_.pieceCount());
    for (int h = 0; h < all_.halfedgeCount(); ++h) {
      const int twin = all_.twin[h];
      if (h < twin && isDrawn[h] == 0) sets.unite(all_.piece[h], all_.piece[twin]);
    }
    const Array<int> names = sets.names();
    Array<int>& cells = all_.cellOfPiece;
    cells.resize(names.size());
    for (int p = 0; p < names.count(); ++p) {
      // The name of a set is its smallest piece, which already has its cell.
      if (names[p] == p) all_.cellArea.push_back(0);
      cells[p] = names[p] == p ? all_.cellCount() - 1 : cells[names[p]];
      all_.cellArea[cells[p]] += all_.pieceArea[p];
    }
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  Drawing drawing_;
  Arrangement all_;
  Array<int> sideStart_;  ///< for each half-edge of the mesh, the first half-edge on it
  // The state of the current face.
  int first_ = 0;
  Array<Vec2> places_;
  Array<DrawnPiece> pieces_;
  Array<Leaving> leaving_;
  Array<Loop> loops_;
  Array<int> loopOf_;
  Array<int> pieceOfLoop_;
};

}  // namespace

Arrangement arrange(const Geometry& geometry, std::span<const SurfacePath> paths) {
  return Builder(geometry, drawPaths(*geometry.mesh, paths)).build();
}

SurfacePoint vertexInFace(const TriangleMesh& mesh, const Arrangement& arrangement, int face,
                          int vertex) {
  const Vec2 place = placeIn(mesh, arrangement.added, face, vertex);
  return {face, Vec3(1 - place.x() - place.y(), place.x(), place.y())};
}

double lengthOf(const Geometry& geometry, const Arrangement& arrangement, int h) {
  const TriangleMesh& mesh = *geometry.mesh;
  const int f = arrangement.face(h);
  const Vec2 way = placeIn(mesh, arrangement.added, f, arrangement.head(h)) -
                   placeIn(mesh, arrangement.added, f, arrangement.tail[h]);
  return inFrame(geometry, f, way).norm();
}

Array<SurfacePoint> pointsInside(const Geometry& geometry, const Arrangement& all) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<int> largest(static_cast<size_t>(all.cellCount()), -1);
  for (int p = 0; p < all.pieceCount(); ++p) {
    int& best = largest[all.cellOfPiece[p]];
    if (best < 0 || all.pieceArea[p] > all.pieceArea[best]) best = p;
  }
  Array<SurfacePoint> points;
  for (const int piece : largest) {
    const int f = all.faceOfPiece[piece];
    const auto place = [&](int vertex) {
      return inFrame(geometry, f, placeIn(mesh, all.added, f, vertex));
    };
    int longest = -1;
    for (int h = all.firstOfFace[f]; h < all.firstOfFace[f + 1]; ++h) {
      if (all.piece[h] != piece) continue;
      if (longest < 0 || lengthOf(geometry, all, h) > lengthOf(geometry, all, longest)) longest = h;
    }
    // The point lies halfway from the middle of the longest side to the next line.
    const Vec2 from = place(all.tail[longest]);
    const Vec2 way = place(all.head(longest)) - from;
    const Vec2 middle = from + way / 2;
    const Vec2 inwards(-way.y(), way.x());
    double least = kInfinity;
    for (int h = all.firstOfFace[f]; h < all.firstOfFace[f + 1]; ++h) {
      if (all.piece[h] != piece || h == longest || h == all.twin[longest]) continue;
      const Vec2 a = place(all.tail[h]) - middle;
      const Vec2 side = place(all.head(h)) - middle - a;
      const double across = cross(inwards, side);
      const double t = cross(a, inwards) / across;
      const double s = cross(a, side) / across;
      if (across != 0 && t >= 0 && t <= 1 && s > 0) least = std::min(least, s);
    }
    const Vec2 inside = middle + (least < kInfinity ? least / 2 : 0) * inwards;
    points.push_back(clampedPoint(f, barycentric(geometry, f, inside)));
  }
  return points;
}

int pieceHolding(const TriangleMesh& mesh, const Arrangement& arrangement,
                 const SurfacePoint& point) {
  const int f = point.face;
  const int first = arrangement.firstOfFace[f];
  const int end = arrangement.firstOfFace[f + 1];
  // Points on the sides of the face move inwards.
  constexpr double inwards = kTogether / 4;
  const Vec3 bary = (1 - inwards) * point.bary + Vec3::Constant(inwards / 3);
  const Vec2 place(onGrid(bary[1]), onGrid(bary[2]));
  Array<int> crossed;
  for (int h = first; h < end; ++h) {
    const Vec2 a = placeIn(mesh, arrangement.added, f, arrangement.tail[h]);
    const Vec2 b = placeIn(mesh, arrangement.added, f, arrangement.head(h));
    if ((a.y() <= place.y()) == (b.y() <= place.y())) continue;
    const double left = leftOf(a, b, place);
    if (a.y() < b.y() ? left <= 0 : left >= 0) continue;
    crossed.push_back(arrangement.piece[h]);
  }
  // A piece holds the point if its loops cross the ray to the left an odd number of times.
  std::sort(crossed.begin(), crossed.end());
  for (int i = 0; i < crossed.count();) {
    int last = i;
    while (last < crossed.count() && crossed[last] == crossed[i]) ++last;
    if ((last - i) % 2 == 1) return crossed[i];
    i = last;
  }
  return arrangement.piece[first];
}

}  // namespace karcher
