#include "smooth_surface.h"

#include <stdexcept>

namespace karcher {
namespace {

/// Newton's method with difference quotients.
template <typename Function>
Vec2 zeroNear(Vec2 x, const Function& function) {
  for (int i = 0; i < 30; ++i) {
    const Vec2 value = function(x);
    if (value.norm() < 1e-13) break;
    constexpr double kDelta = 1e-6;
    const Vec2 cx = (function(x + Vec2(kDelta, 0)) - value) / kDelta;
    const Vec2 cy = (function(x + Vec2(0, kDelta)) - value) / kDelta;
    x -= Vec2(cross(value, cy), cross(cx, value)) / cross(cx, cy);
  }
  return x;
}

Vec3 sphereExp(const Vec3& p, const Vec3& v) {
  const double length = v.norm();
  if (length == 0) return p;
  return (std::cos(length) * p + std::sin(length) / length * v).normalized();
}

Vec3 sphereLog(const Vec3& p, const Vec3& q) {
  const Vec3 tangent = q - p.dot(q) * p;
  const double sine = tangent.norm();
  if (sine == 0) return Vec3::Zero();
  return std::atan2(sine, p.dot(q)) / sine * tangent;
}

/// A torus by its angles: u around the axis, v around the tube.
struct Torus {
  double major;
  double minor;

  struct State {
    double u, v, du, dv;
  };

  Vec3 at(double u, double v) const {
    const double ring = major + minor * std::cos(v);
    return {ring * std::cos(u), ring * std::sin(u), minor * std::sin(v)};
  }
  Vec3 alongU(double u) const { return {-std::sin(u), std::cos(u), 0}; }
  Vec3 alongV(double u, double v) const {
    return {-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v)};
  }
  double uOf(const Vec3& p) const { return std::atan2(p.y(), p.x()); }
  double vOf(const Vec3& p) const { return std::atan2(p.z(), std::hypot(p.x(), p.y()) - major); }

  /// The geodesic equations of ds^2 = (major + minor cos v)^2 du^2 + minor^2 dv^2.
  State derivative(const State& s) const {
    const double ring = major + minor * std::cos(s.v);
    return {s.du, s.dv, 2 * minor * std::sin(s.v) / ring * s.du * s.dv,
            -ring * std::sin(s.v) / minor * s.du * s.du};
  }

  static State add(const State& s, double h, const State& d) {
    return {s.u + h * d.u, s.v + h * d.v, s.du + h * d.du, s.dv + h * d.dv};
  }

  /// The geodesic from (u, v) with velocity x along u and y along v in space, at time 1.
  State shoot(double u, double v, double x, double y) const {
    constexpr int kSteps = 100;
    constexpr double h = 1.0 / kSteps;
    State s{u, v, x / (major + minor * std::cos(v)), y / minor};
    for (int i = 0; i < kSteps; ++i) {
      const State k1 = derivative(s);
      const State k2 = derivative(add(s, h / 2, k1));
      const State k3 = derivative(add(s, h / 2, k2));
      const State k4 = derivative(add(s, h, k3));
      s = add(add(add(add(s, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
    }
    return s;
  }

  Vec3 project(const Vec3& x) const { return at(uOf(x), vOf(x)); }

  Vec3 exp(const Vec3& p, const Vec3& tangent) const {
    const double u = uOf(p);
    const double v = vOf(p);
    const State end = shoot(u, v, tangent.dot(alongU(u)), tangent.dot(alongV(u, v)));
    return at(end.u, end.v);
  }

  Vec3 log(const Vec3& p, const Vec3& q) const {
    const double u = uOf(p);
    const double v = vOf(p);
    const double toU = u + std::remainder(uOf(q) - u, 2 * kPi);
    const double toV = v + std::remainder(vOf(q) - v, 2 * kPi);
    const double ring = major + minor * std::cos((v + toV) / 2);
    Vec2 x(ring * (toU - u), minor * (toV - v));
    const auto missed = [&](const Vec2& velocity) {
      const State end = shoot(u, v, velocity.x(), velocity.y());
      return Vec2(major * (end.u - toU), minor * (end.v - toV));
    };
    x = zeroNear(x, missed);
    return x.x() * alongU(u) + x.y() * alongV(u, v);
  }
};

/// The zero of f(x) = x' A x + b' x + c, with A diagonal.
struct Quadric {
  Vec3 a;
  Vec3 b;
  double c;

  double value(const Vec3& x) const { return x.dot(a.cwiseProduct(x)) + b.dot(x) + c; }
  Vec3 gradient(const Vec3& x) const { return 2 * a.cwiseProduct(x) + b; }

  Vec3 project(Vec3 x) const {
    for (int i = 0; i < 20; ++i) {
      const Vec3 normal = gradient(x);
      const Vec3 step = value(x) / normal.squaredNorm() * normal;
      x -= step;
      if (step.norm() < 1e-16) break;
    }
    return x;
  }

  /// The acceleration of a geodesic with velocity v: x'' = -(v' H v) / |g|^2 g, with H = 2 A.
  Vec3 bend(const Vec3& x, const Vec3& v) const {
    const Vec3 g = gradient(x);
    return -2 * v.dot(a.cwiseProduct(v)) / g.squaredNorm() * g;
  }

  Vec3 exp(const Vec3& p, const Vec3& tangent) const {
    constexpr int kSteps = 100;
    constexpr double h = 1.0 / kSteps;
    Vec3 x = p;
    Vec3 v = tangent;
    for (int i = 0; i < kSteps; ++i) {
      const Vec3 v1 = v;
      const Vec3 a1 = bend(x, v1);
      const Vec3 v2 = v + h / 2 * a1;
      const Vec3 a2 = bend(x + h / 2 * v1, v2);
      const Vec3 v3 = v + h / 2 * a2;
      const Vec3 a3 = bend(x + h / 2 * v2, v3);
      const Vec3 v4 = v + h * a3;
      const Vec3 a4 = bend(x + h * v3, v4);
      x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
      v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return project(x);
  }

  Vec3 log(const Vec3& p, const Vec3& q) const {
    const Vec3 normal = gradient(p).normalized();
    const Vec3 way = q - p;
    const Vec3 tangent = way - way.dot(normal) * normal;
    if (tangent.norm() == 0) return Vec3::Zero();
    const Vec3 e1 = tangent.normalized();
    const Vec3 e2 = normal.cross(e1);
    const auto missed = [&](const Vec2& velocity) {
      const Vec3 miss = exp(p, velocity.x() * e1 + velocity.y() * e2) - q;
      return Vec2(miss.dot(e1), miss.dot(e2));
    };
    Vec2 x(way.norm(), 0);
    x = zeroNear(x, missed);
    return x.x() * e1 + x.y() * e2;
  }

  SmoothSurface surface() const {
    const Quadric q = *this;
    return {[q](const Vec3& x) { return q.project(x); },
            [q](const Vec3& p) { return Vec3(q.gradient(p).normalized()); },
            [q](const Vec3& p, const Vec3& v) { return q.exp(p, v); },
            [q](const Vec3& p, const Vec3& to) { return q.log(p, to); }};
  }
};

}  // namespace

SmoothSurface smoothEllipsoid(const Vec3& halfAxes) {
  return Quadric{halfAxes.cwiseProduct(halfAxes).cwiseInverse(), Vec3::Zero(), -1}.surface();
}

SmoothSurface smoothSaddle(double height) {
  return Quadric{Vec3(-height, height, 0), Vec3(0, 0, 1), 0}.surface();
}

SmoothSurface smoothSphere() {
  return {[](const Vec3& x) { return Vec3(x.normalized()); }, [](const Vec3& p) { return p; },
          sphereExp, sphereLog};
}

SmoothSurface smoothTorus(double major, double minor) {
  const Torus torus{major, minor};
  return {[torus](const Vec3& x) { return torus.project(x); },
          [torus](const Vec3& p) {
            const double u = torus.uOf(p);
            const double v = torus.vOf(p);
            return Vec3(torus.alongU(u).cross(torus.alongV(u, v)));
          },
          [torus](const Vec3& p, const Vec3& v) { return torus.exp(p, v); },
          [torus](const Vec3& p, const Vec3& q) { return torus.log(p, q); }};
}

Vec3 smoothCenter(const SmoothSurface& surface, const Array<Vec3>& points,
                  const Array<double>& weights, const Vec3& start) {
  Vec3 p = surface.project(start);
  for (int i = 0; i < 200; ++i) {
    Vec3 step = Vec3::Zero();
    for (int k = 0; k < points.count(); ++k) step += weights[k] * surface.log(p, points[k]);
    p = surface.exp(p, step);
    if (step.norm() < 1e-12) return p;
  }
  throw std::runtime_error("the center of mass on the smooth surface was not found in 200 steps");
}

}  // namespace karcher
