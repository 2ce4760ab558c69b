#include "generators/delaunay.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "mesh/morton.h"

namespace karcher {
namespace {

/// The decisions in the plane. A determinant decides the side of a line, and the paraboloid z = x^2
/// + y^2 (lifted from the point d, to keep digits) the inside of a circle.
struct PlanePredicates {
  const Array<Vec2>& points;

  double orientation(int a, int b, int c) const {
    return cross(points[b] - points[a], points[c] - points[a]);
  }

  bool insideCircle(int a, int b, int c, int d) const {
    const Vec2 u = points[a] - points[d];
    const Vec2 v = points[b] - points[d];
    const Vec2 w = points[c] - points[d];
    const double terms[3] = {u.squaredNorm() * cross(v, w), v.squaredNorm() * cross(w, u),
                             w.squaredNorm() * cross(u, v)};
    return exceedsRounding(terms);
  }

  static bool exceedsRounding(const double (&terms)[3]) {
    constexpr double kRounding = 1e-14;
    return terms[0] + terms[1] + terms[2] >
           kRounding * (std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]));
  }
};

/// The decisions on the sphere. A great circle replaces the line, and a plane cuts out the circle.
struct SpherePredicates {
  const Array<Vec3>& points;

  double orientation(int a, int b, int c) const {
    return points[a].cross(points[b]).dot(points[c]);
  }

  bool insideCircle(int a, int b, int c, int d) const {
    const Vec3 u = points[a] - points[d];
    const Vec3 v = points[b] - points[d];
    const Vec3 w = points[c] - points[d];
    // Whether d lies above the plane of a, b, c.
    const Vec3 n = v.cross(w);
    const double terms[3] = {-u.x() * n.x(), -u.y() * n.y(), -u.z() * n.z()};
    return PlanePredicates::exceedsRounding(terms);
  }
};

/// The triangulation. Half-edge 3 f + k runs from corner k to corner k + 1 of face f.
template <class Predicates>
class Insertion {
 public:
  Insertion(Predicates predicates, Array<Triangle> faces, Array<int> twin)
      : predicates_(predicates), faces_(std::move(faces)), twin_(std::move(twin)) {}

  void insert(int p) {
    const int f = locate(p);
    const Triangle t = faces_[f];
    const int g = faces_.count();
    const int h = g + 1;
    const int outside[3] = {twin_[3 * f], twin_[3 * f + 1], twin_[3 * f + 2]};
    faces_[f] = {t[0], t[1], p};
    faces_.push_back({t[1], t[2], p});
    faces_.push_back({t[2], t[0], p});
    twin_.resize(twin_.size() + 6);
    const int parts[3] = {f, g, h};
    for (int k = 0; k < 3; ++k) {
      join(3 * parts[k], outside[k]);
      join(3 * parts[k] + 1, 3 * parts[(k + 1) % 3] + 2);
    }
    for (const int part : parts) pending_.push_back(3 * part);
    legalize();
  }

  const Array<Triangle>& faces() const { return faces_; }

 private:
  int tail(int h) const { return faces_[h / 3][h % 3]; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

  void join(int h, int t) {
    twin_[h] = t;
    if (t >= 0) twin_[t] = h;
  }

  /// Walks to the face of p, each time across the first edge that separates it from p. A bound ends
  /// walks that rounding sends in circles.
  int locate(int p) {
    const int limit = 4 * faces_.count() + 100;
    for (int step = 0; step < limit; ++step) {
      int across = -1;
      for (int k = 0; k < 3 && across < 0; ++k) {
        const int h = 3 * last_ + (k + step) % 3;
        if (predicates_.orientation(tail(h), tail(next(h)), p) < 0) across = h;
      }
      if (across < 0) return last_;
      if (twin_[across] < 0) throw std::runtime_error("a point lies outside the triangulation");
      last_ = twin_[across] / 3;
    }
    throw std::runtime_error("a point's face was not found");
  }

  /// Flips pending edges, each opposite to the new point, that are not locally Delaunay.
  void legalize() {
    while (!pending_.empty()) {
      const int h = pending_.back();
      pending_.pop_back();
      const int t = twin_[h];
      if (t < 0) continue;
      const int p = tail(previous(h));
      const int q = tail(previous(t));
      if (!predicates_.insideCircle(tail(h), tail(next(h)), p, q)) continue;
      flip(h, t, p, q);
    }
  }

  void flip(int h, int t, int p, int q) {
    const int a = tail(h);
    const int b = tail(t);
    const int f = h / 3;
    const int g = t / 3;
    const int bp = twin_[next(h)];
    const int pa = twin_[previous(h)];
    const int aq = twin_[next(t)];
    const int qb = twin_[previous(t)];
    faces_[f] = {a, q, p};
    faces_[g] = {q, b, p};
    join(3 * f, aq);
    join(3 * f + 1, 3 * g + 2);
    join(3 * f + 2, pa);
    join(3 * g, qb);
    join(3 * g + 1, bp);
    pending_.push_back(3 * f);
    pending_.push_back(3 * g);
  }

  Predicates predicates_;
  Array<Triangle> faces_;
  Array<int> twin_;
  Array<int> pending_;
  int last_ = 0;
};

Array<int> insertionOrder(const Array<Vec3>& points) {
  Array<int> all(points.size());
  std::iota(all.begin(), all.end(), 0);
  return mortonOrder(points, std::move(all));
}

/// The four points that reach farthest towards the corners of a regular tetrahedron.
Array<int> firstTetrahedron(const Array<Vec3>& points) {
  const Array<Vec3> directions = {Vec3(1, 1, 1), Vec3(-1, 1, -1), Vec3(-1, -1, 1), Vec3(1, -1, -1)};
  Array<int> corners(4, 0);
  for (int k = 0; k < 4; ++k) {
    for (int i = 1; i < points.count(); ++i) {
      if (points[i].dot(directions[k]) > points[corners[k]].dot(directions[k])) corners[k] = i;
    }
  }
  return corners;
}

}  // namespace

Array<Triangle> delaunay(const Array<Vec2>& points) {
  Vec2 low = points.front();
  Vec2 high = low;
  for (const Vec2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // The points lie inside a triangle so large that its circles through two hull points approximate
  // half planes.
  const int count = points.count();
  const Vec2 center = (low + high) / 2;
  const double size = 1e4 * (high - low).norm();
  Array<Vec2> all = points;
  for (const double angle : {0.1, 2.2, 4.3}) all.push_back(center + size * unitVector(angle));
  Insertion<PlanePredicates> insertion({all}, {Triangle(count, count + 1, count + 2)},
                                       {-1, -1, -1});
  Array<Vec3> lifted;
  for (const Vec2& p : points) lifted.emplace_back(p.x(), p.y(), 0);
  for (const int p : insertionOrder(lifted)) insertion.insert(p);
  Array<Triangle> result;
  for (const Triangle& t : insertion.faces()) {
    if (t.maxCoeff() < count) result.push_back(t);
  }
  return result;
}

Array<Triangle> sphereHull(const Array<Vec3>& points) {
  const Array<int> c = firstTetrahedron(points);
  const Array<Triangle> tetrahedron = {
      {c[0], c[1], c[2]}, {c[0], c[2], c[3]}, {c[0], c[3], c[1]}, {c[1], c[3], c[2]}};
  for (const Triangle& t : tetrahedron) {
    if (!(points[t[0]].cross(points[t[1]]).dot(points[t[2]]) > 0)) {
      throw std::runtime_error("the points do not surround the sphere's center");
    }
  }
  Insertion<SpherePredicates> insertion({points}, tetrahedron,
                                        {8, 11, 3, 2, 10, 6, 5, 9, 0, 7, 4, 1});
  for (const int p : insertionOrder(points)) {
    if (std::find(c.begin(), c.end(), p) == c.end()) insertion.insert(p);
  }
  return insertion.faces();
}

}  // namespace karcher
