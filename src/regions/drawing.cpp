#include "regions/drawing.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

struct PlacedVertex {
  Vec2 place;
  int vertex;
};

/// A line in a face, which all pieces on it share.
struct Line {
  int a;
  int b;
  Vec2 from;
  Vec2 to;
  double left;   ///< the smallest x
  double right;  ///< the largest x
};

/// A cut of a line at a vertex.
struct LineCut {
  int line;
  double along;
  int vertex;
};

class Drawer {
 public:
  explicit Drawer(const TriangleMesh& mesh) : mesh_(mesh) {
    drawing_.meshVertices = mesh.vertexCount();
    drawing_.edgeOf.assign(static_cast<size_t>(mesh.halfedgeCount()), -1);
    drawing_.faceOf.assign(static_cast<size_t>(mesh.faceCount()), -1);
  }

  void add(const SurfacePath& path) {
    const int number = drawing_.paths++;
    const bool closed = isClosed(path);
    int first = -1;
    int last = -1;
    for (int i = 0; i < path.points.count(); ++i) {
      const SurfacePoint& point = path.points[i];
      const int face = i > 0 ? commonFace(mesh_, path.points[i - 1], point) : point.face;
      if (face < 0) {
        refuse("the points " + std::to_string(i - 1) + " and " + std::to_string(i) + " of path " +
               std::to_string(number) + " have no face in common");
      }
      const bool closes = closed && i == path.points.count() - 1 && isIn(face, first);
      const int here = closes ? first : vertexAt(point.face, point.bary);
      if (i == 0) first = here;
      if (i > 0 && here != last) addPiece(face, {last, here, number, static_cast<double>(i - 1)});
      last = here;
    }
  }

  Drawing finish() {
    // The largest number of rounds. A new vertex on an edge puts the faces at the edge back in the
    // queue. Vertices stay apart, so that their number is bounded and the rounds end; the limit is
    // far beyond all observed numbers.
    constexpr int kMostRounds = 1000;
    for (int round = 0; !waiting_.empty(); ++round) {
      if (round == kMostRounds) refuse("the paths have too many crossings that lie together");
      Array<int> now;
      now.swap(waiting_);
      for (const int face : now) waits_[face] = 0;
      for (const int face : now) cutFace(face);
    }
    for (DrawnEdge& edge : drawing_.edges) cutEdge(edge);
    return std::move(drawing_);
  }

 private:
  /// Whether a path ends where it starts, up to a difference of kTogether.
  bool isClosed(const SurfacePath& path) const {
    if (path.points.count() < 2) return false;
    const int face = commonFace(mesh_, path.points.front(), path.points.back());
    if (face < 0) return false;
    const Vec3 apart = inFace(mesh_, path.points.front(), face).bary -
                       inFace(mesh_, path.points.back(), face).bary;
    return apart.cwiseAbs().maxCoeff() <= kTogether;
  }

  /// Whether a face, its sides included, contains a vertex.
  bool isIn(int f, int vertex) const {
    if (vertex < drawing_.meshVertices) return (mesh_.faces[f].array() == vertex).any();
    const DrawnVertex& it = drawing_.added[vertex - drawing_.meshVertices];
    const int twin = it.halfedge < 0 ? -1 : mesh_.twin[it.halfedge];
    return it.face == f || (twin >= 0 && karcher::faceOf(twin) == f);
  }

  DrawnEdge& edgeAt(int h) {
    int& number = drawing_.edgeOf[h];
    if (number < 0) {
      number = drawing_.edges.count();
      drawing_.edges.push_back({h, {}, {}});
    }
    return drawing_.edges[number];
  }

  int faceAt(int f) {
    int& number = drawing_.faceOf[f];
    if (number < 0) {
      number = drawing_.faces.count();
      drawing_.faces.push_back({f, {}, {}});
      waits_.push_back(0);
    }
    return number;
  }

  void wait(int number) {
    if (std::exchange(waits_[number], 1) == 0) waiting_.push_back(number);
  }

  double alongEdge(int halfedge, int vertex) const {
    if (vertex >= drawing_.meshVertices) return drawing_.added[vertex - drawing_.meshVertices].t;
    return vertex == mesh_.tail(halfedge) ? 0 : 1;
  }

  int addVertex(const DrawnVertex& vertex) {
    drawing_.added.push_back(vertex);
    return drawing_.meshVertices + drawing_.added.count() - 1;
  }

  int vertexOnEdge(int side, double part) {
    const int h = drawnHalfedge(mesh_, side);
    const double t = onGrid(h == side ? part : 1 - part);
    if (t <= kTogether) return mesh_.tail(h);
    if (t >= 1 - kTogether) return mesh_.head(h);
    Array<int>& vertices = edgeAt(h).vertices;
    const auto after =
        std::lower_bound(vertices.begin(), vertices.end(), t,
                         [&](int vertex, double value) { return alongEdge(h, vertex) < value; });
    const double up = after == vertices.end() ? kInfinity : alongEdge(h, *after) - t;
    const double down = after == vertices.begin() ? kInfinity : t - alongEdge(h, *(after - 1));
    // If both neighbours are near, the older one takes the point. It would have done so before the
    // newer one existed.
    if (std::max(up, down) <= kTogether) return std::min(*after, *(after - 1));
    if (std::min(up, down) <= kTogether) return up < down ? *after : *(after - 1);
    const int vertex = addVertex({karcher::faceOf(h), h, t, placeOnSide(cornerOf(h), t)});
    vertices.insert(after, vertex);
    for (const int mine : {h, mesh_.twin[h]}) {
      if (mine < 0) continue;
      const int number = drawing_.faceOf[karcher::faceOf(mine)];
      if (number >= 0) wait(number);
    }
    return vertex;
  }

  /// The vertex that takes a point: an existing one or a new one.
  int vertexAt(int f, const Vec3& bary) {
    int k = 0;
    if (bary.maxCoeff(&k) >= 1 - kTogether) return mesh_.corner(f, k);
    if (bary.minCoeff(&k) <= kTogether) {
      return vertexOnEdge(3 * f + (k + 1) % 3, bary[(k + 2) % 3] + bary[k] / 2);
    }
    const int number = faceAt(f);
    const Vec2 place(onGrid(bary[1]), onGrid(bary[2]));
    for (const int vertex : drawing_.faces[number].vertices) {
      const Vec2 apart = drawing_.added[vertex - drawing_.meshVertices].place - place;
      if (apart.squaredNorm() <= kTogether * kTogether) return vertex;
    }
    const int vertex = addVertex({f, -1, 0, place});
    drawing_.faces[number].vertices.push_back(vertex);
    wait(number);
    return vertex;
  }

  bool onSide(int side, int vertex) const {
    if (vertex < drawing_.meshVertices) {
      return vertex == mesh_.tail(side) || vertex == mesh_.head(side);
    }
    return drawing_.added[vertex - drawing_.meshVertices].halfedge == drawnHalfedge(mesh_, side);
  }

  /// Adds a piece to the edge on which it lies, or else to its face.
  void addPiece(int f, const DrawnPiece& piece) {
    for (int side = 3 * f; side < 3 * f + 3; ++side) {
      if (!onSide(side, piece.from) || !onSide(side, piece.to)) continue;
      edgeAt(drawnHalfedge(mesh_, side)).pieces.push_back(piece);
      return;
    }
    const int number = faceAt(f);
    drawing_.faces[number].pieces.push_back(piece);
    wait(number);
  }

  void listVertices(int number, Array<PlacedVertex>& all) const {
    const int f = drawing_.faces[number].face;
    all.clear();
    const auto add = [&](int vertex) {
      all.push_back({placeIn(mesh_, drawing_.added, f, vertex), vertex});
    };
    for (int k = 0; k < 3; ++k) {
      add(mesh_.corner(f, k));
      const int edge = drawing_.edgeOf[drawnHalfedge(mesh_, 3 * f + k)];
      if (edge < 0) continue;
      for (const int vertex : drawing_.edges[edge].vertices) add(vertex);
    }
    for (const int vertex : drawing_.faces[number].vertices) add(vertex);
    sortItems(all, [](const PlacedVertex& a, const PlacedVertex& b) {
      return std::pair(a.place.x(), a.vertex) < std::pair(b.place.x(), b.vertex);
    });
  }

  void listLines(int number, Array<Line>& lines) {
    const DrawnFace& face = drawing_.faces[number];
    Array<std::pair<int, int>>& ends = ends_;
    ends.clear();
    for (const DrawnPiece& piece : face.pieces) ends.push_back(std::minmax(piece.from, piece.to));
    sortItems(ends, std::less<>());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    lines.clear();
    for (const auto& [a, b] : ends) {
      const Vec2 from = placeIn(mesh_, drawing_.added, face.face, a);
      const Vec2 to = placeIn(mesh_, drawing_.added, face.face, b);
      lines.push_back({a, b, from, to, std::min(from.x(), to.x()), std::max(from.x(), to.x())});
    }
  }

  /// Cuts lines at the vertices that they pass.
  static void cutAtVertices(const Array<Line>& lines, const Array<PlacedVertex>& vertices,
                            Array<LineCut>& cuts) {
    constexpr double near = kTogether / 2;
    for (int i = 0; i < lines.count(); ++i) {
      const Line& line = lines[i];
      const double low = std::min(line.from.y(), line.to.y()) - near;
      const double high = std::max(line.from.y(), line.to.y()) + near;
      const Vec2 way = line.to - line.from;
      const double squared = way.squaredNorm();
      auto it = std::lower_bound(vertices.begin(), vertices.end(), line.left - near,
                                 [](const PlacedVertex& v, double x) { return v.place.x() < x; });
      for (; it != vertices.end() && it->place.x() <= line.right + near; ++it) {
        if (it->place.y() < low || it->place.y() > high) continue;
        if (it->vertex == line.a || it->vertex == line.b) continue;
        const Vec2 there = it->place - line.from;
        const double along = there.dot(way);
        if (along <= 0 || along >= squared) continue;
        const double across = exactCross(way, there);
        if (across * across <= near * near * squared) {
          cuts.push_back({i, along / squared, it->vertex});
        }
      }
    }
  }

  /// The vertex that takes a crossing; `vertices` are those of the face.
  int vertexAtCrossing(int number, const Vec2& place, Array<PlacedVertex>& vertices) {
    // The nearest vertex takes the crossing, if it is near. Both lines are then cut into shorter
    // ones, so that the cuts end.
    double nearest = 4 * kTogether * kTogether;
    int vertex = -1;
    for (const PlacedVertex& other : vertices) {
      const double squared = (other.place - place).squaredNorm();
      if (squared > nearest) continue;
      nearest = squared;
      vertex = other.vertex;
    }
    if (vertex >= 0) return vertex;
    const int f = drawing_.faces[number].face;
    vertex = vertexAt(f, Vec3(1 - place.x() - place.y(), place.x(), place.y()));
    vertices.push_back({placeIn(mesh_, drawing_.added, f, vertex), vertex});
    return vertex;
  }

  void cutAtCrossings(int number, const Array<Line>& lines, Array<PlacedVertex>& vertices,
                      Array<LineCut>& cuts) {
    if (lines.count() < 2) return;
    // The loop skips bent lines, since the next round examines them again in any case.
    Array<uint8_t> bent(lines.size(), 0);
    for (const LineCut& cut : cuts) bent[cut.line] = 1;
    const Array<int> order =
        sortedNumbers(lines.count(), [&](int i, int j) { return lines[i].left < lines[j].left; });
    for (int i = 0; i < order.count(); ++i) {
      const Line& one = lines[order[i]];
      if (bent[order[i]] != 0) continue;
      const auto [low, high] = std::minmax(one.from.y(), one.to.y());
      for (int j = i + 1; j < order.count() && lines[order[j]].left <= one.right; ++j) {
        const Line& other = lines[order[j]];
        if (bent[order[j]] != 0) continue;
        if (std::max(other.from.y(), other.to.y()) < low) continue;
        if (std::min(other.from.y(), other.to.y()) > high) continue;
        if (one.a == other.a || one.a == other.b || one.b == other.a || one.b == other.b) continue;
        const double start = leftOf(other.from, other.to, one.from);
        const double end = leftOf(other.from, other.to, one.to);
        if (!((start < 0 && end > 0) || (start > 0 && end < 0))) continue;
        const double first = leftOf(one.from, one.to, other.from);
        const double second = leftOf(one.from, one.to, other.to);
        if (!((first < 0 && second > 0) || (first > 0 && second < 0))) continue;
        const double t = start / (start - end);
        const int vertex = vertexAtCrossing(number, one.from + t * (one.to - one.from), vertices);
        if (vertex != one.a && vertex != one.b) cuts.push_back({order[i], t, vertex});
        if (vertex != other.a && vertex != other.b) {
          cuts.push_back({order[j], first / (first - second), vertex});
        }
      }
    }
  }

  /// Does one round for a face. The face returns to the queue until a round finds no change.
  void cutFace(int number) {
    if (drawing_.faces[number].pieces.empty()) return;
    const Array<Line>& lines = lines_;
    Array<LineCut>& cuts = cuts_;
    listLines(number, lines_);
    listVertices(number, vertices_);
    cuts.clear();
    cutAtVertices(lines, vertices_, cuts);
    cutAtCrossings(number, lines, vertices_, cuts);
    if (cuts.empty()) return;
    sortItems(cuts, [](const LineCut& a, const LineCut& b) {
      return std::tuple(a.line, a.along, a.vertex) < std::tuple(b.line, b.along, b.vertex);
    });
    Array<DrawnPiece> whole;
    whole.swap(drawing_.faces[number].pieces);
    const int f = drawing_.faces[number].face;
    Array<int> through;
    for (const DrawnPiece& piece : whole) {
      const std::pair<int, int> ends = std::minmax(piece.from, piece.to);
      const auto line = std::lower_bound(
          lines.begin(), lines.end(), ends,
          [](const Line& l, const std::pair<int, int>& e) { return std::pair(l.a, l.b) < e; });
      const int name = static_cast<int>(line - lines.begin());
      auto cut = std::lower_bound(cuts.begin(), cuts.end(), name,
                                  [](const LineCut& c, int l) { return c.line < l; });
      through = {ends.first};
      for (; cut != cuts.end() && cut->line == name; ++cut) {
        if (std::find(through.begin(), through.end(), cut->vertex) == through.end()) {
          through.push_back(cut->vertex);
        }
      }
      through.push_back(ends.second);
      if (piece.from != ends.first) std::reverse(through.begin(), through.end());
      const double span = piece.span / (through.count() - 1);
      for (int i = 1; i < through.count(); ++i) {
        addPiece(f, {through[i - 1], through[i], piece.path, piece.order + (i - 1) * span, span});
      }
    }
    wait(number);
  }

  void cutEdge(DrawnEdge& edge) const {
    Array<DrawnPiece> whole;
    whole.swap(edge.pieces);
    for (const DrawnPiece& piece : whole) {
      const double from = alongEdge(edge.halfedge, piece.from);
      const double to = alongEdge(edge.halfedge, piece.to);
      Array<int> through;
      for (const int vertex : edge.vertices) {
        const double t = alongEdge(edge.halfedge, vertex);
        if (t > std::min(from, to) && t < std::max(from, to)) through.push_back(vertex);
      }
      if (from > to) std::reverse(through.begin(), through.end());
      through.push_back(piece.to);
      const double span = piece.span / through.count();
      double order = piece.order;
      int last = piece.from;
      for (const int vertex : through) {
        edge.pieces.push_back({last, vertex, piece.path, order, span});
        last = vertex;
        order += span;
      }
    }
  }

  const TriangleMesh& mesh_;
  Drawing drawing_;
  Array<uint8_t> waits_;  ///< whether each face of the drawing is in `waiting_`
  Array<int> waiting_;
  // The state of the current face.
  Array<std::pair<int, int>> ends_;
  Array<Line> lines_;
  Array<PlacedVertex> vertices_;
  Array<LineCut> cuts_;
};

}  // namespace

Vec2 placeIn(const TriangleMesh& mesh, const Array<DrawnVertex>& added, int face, int vertex) {
  if (vertex < mesh.vertexCount()) {
    const int k = mesh.corner(face, 0) == vertex ? 0 : mesh.corner(face, 1) == vertex ? 1 : 2;
    return placeOnSide(k, 0);
  }
  const DrawnVertex& it = added[vertex - mesh.vertexCount()];
  if (it.halfedge < 0 || karcher::faceOf(it.halfedge) == face) return it.place;
  return placeOnSide(cornerOf(mesh.twin[it.halfedge]), 1 - it.t);
}

Drawing drawPaths(const TriangleMesh& mesh, std::span<const SurfacePath> paths) {
  Drawer drawer(mesh);
  for (const SurfacePath& path : paths) drawer.add(path);
  return drawer.finish();
}

}  // namespace karcher
