#include "generators/torus.h"

#include "generators/delaunay.h"
#include "generators/random.h"

namespace karcher {
namespace {

/// The plane of `conformalTorus` with x divided by the stretch; with its opposite sides identified
/// it is the torus. The map is conformal, so that Delaunay triangulations of the plane are Delaunay
/// on the surface.
struct Rectangle {
  double width;
  double height = kTorusPeriod;
  double stretch;

  explicit Rectangle(double s) : width(2 * kPi / s), stretch(s) {}

  Vec2 wrapped(const Vec2& p) const {
    return {p.x() - width * std::floor(p.x() / width), p.y() - height * std::floor(p.y() / height)};
  }

  Vec3 onTorus(const Vec2& p) const { return conformalTorus(Vec2(stretch * p.x(), p.y())); }
};

/// Points of the plane that represent points of the torus: the whole rectangle and a margin.
struct Unrolled {
  Array<Vec2> points;  ///< the points of the rectangle itself come first
  Array<int> original;
};

Unrolled unroll(const Rectangle& rectangle, const Array<Vec2>& points) {
  const double spacing =
      std::sqrt(rectangle.width * rectangle.height / static_cast<double>(points.size()));
  const double margin = 8 * spacing;
  Unrolled result{points, {}};
  for (int i = 0; i < points.count(); ++i) result.original.push_back(i);
  for (int i = 0; i < points.count(); ++i) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        if (dx == 0 && dy == 0) continue;
        const Vec2 p = points[i] + Vec2(dx * rectangle.width, dy * rectangle.height);
        if (p.x() < -margin || p.x() > rectangle.width + margin || p.y() < -margin ||
            p.y() > rectangle.height + margin) {
          continue;
        }
        result.points.push_back(p);
        result.original.push_back(i);
      }
    }
  }
  return result;
}

/// The copy of each triangle whose corner with the smallest index lies in the rectangle itself.
/// Corners have their indices in `unrolled`.
Array<Triangle> periodicDelaunay(const Unrolled& unrolled, int count) {
  Array<Triangle> result;
  for (const Triangle& t : delaunay(unrolled.points)) {
    int smallest = 0;
    for (int k = 1; k < 3; ++k) {
      if (unrolled.original[t[k]] < unrolled.original[t[smallest]]) smallest = k;
    }
    if (t[smallest] < count) result.push_back(t);
  }
  return result;
}

/// The ratio of lengths on the torus to lengths in the plane: the distance from the axis.
double scaleAt(double y) { return conformalTorus({0, y}).x(); }

/// Moves each point to the mean of its triangles' centroids, weighted by area on the surface.
void moveApart(const Rectangle& rectangle, const Unrolled& unrolled,
               const Array<Triangle>& triangles, Array<Vec2>& points) {
  Array<Vec2> sum(points.size(), Vec2::Zero());
  Array<double> area(points.size(), 0);
  for (const Triangle& t : triangles) {
    const Vec2& a = unrolled.points[t[0]];
    const Vec2& b = unrolled.points[t[1]];
    const Vec2& c = unrolled.points[t[2]];
    const Vec2 centroid = (a + b + c) / 3;
    const double scale = scaleAt(centroid.y());
    const double weight = cross(b - a, c - a) * scale * scale;
    for (const int corner : t) {
      const int v = unrolled.original[corner];
      sum[v] += weight * (centroid - unrolled.points[corner]);
      area[v] += weight;
    }
  }
  for (int v = 0; v < points.count(); ++v) {
    points[v] = rectangle.wrapped(points[v] + sum[v] / area[v]);
  }
}

}  // namespace

TriangleSoup irregularTorus(int triangles, double stretch, uint64_t seed) {
  Random random(seed);
  const Rectangle rectangle(stretch);
  const int count = triangles / 2;
  Array<Vec2> points;
  while (points.count() < count) {
    const Vec2 p(random.uniform(0, rectangle.width), random.uniform(0, rectangle.height));
    // A point is kept with a probability proportional to the area that it represents.
    const double density = scaleAt(p.y()) / (kTorusMajor + kTorusMinor);
    if (random.uniform() < density * density) points.push_back(p);
  }
  constexpr int kSteps = 8;
  TriangleSoup soup;
  for (int step = 0; step <= kSteps; ++step) {
    const Unrolled unrolled = unroll(rectangle, points);
    const Array<Triangle> copies = periodicDelaunay(unrolled, count);
    if (step < kSteps) {
      moveApart(rectangle, unrolled, copies, points);
      continue;
    }
    for (const Triangle& t : copies) {
      soup.triangles.emplace_back(unrolled.original[t[0]], unrolled.original[t[1]],
                                  unrolled.original[t[2]]);
    }
  }
  for (const Vec2& p : points) soup.positions.push_back(rectangle.onTorus(p));
  return soup;
}

Vec3 closestOnTorus(const Vec3& p) {
  const Vec2 axis = kTorusMajor * Vec2(p.x(), p.y()).normalized();
  const Vec3 center(axis.x(), axis.y(), 0);
  return center + kTorusMinor * (p - center).normalized();
}

}  // namespace karcher
