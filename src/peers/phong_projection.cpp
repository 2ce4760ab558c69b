#include "peers/phong_projection.h"

#include <Eigen/LU>
#include <algorithm>
#include <unordered_set>

namespace karcher {
namespace {

Complex inPlane(const TangentPlane& plane, const EmbeddedPoint& x) {
  const Vec2 coordinates = plane * x;
  return {coordinates.x(), coordinates.y()};
}

/// The plane with its coordinates turned by the angle of z and scaled by |z|.
TangentPlane turned(const Complex& z, const TangentPlane& plane) {
  TangentPlane result;
  result.row(0) = z.real() * plane.row(0) - z.imag() * plane.row(1);
  result.row(1) = z.imag() * plane.row(0) + z.real() * plane.row(1);
  return result;
}

TangentPlane orthonormal(TangentPlane plane) {
  plane.row(0).normalize();
  plane.row(1) -= plane.row(1).dot(plane.row(0)) * plane.row(0);
  plane.row(1).normalize();
  return plane;
}

/// The complex unit number that turns the coordinates of plane `from` as nearly as possible into
/// those of `to`.
Complex turnBetween(const TangentPlane& from, const TangentPlane& to) {
  const Eigen::Matrix2d products = to * from.transpose();
  const Complex turn(products(0, 0) + products(1, 1), products(1, 0) - products(0, 1));
  const double size = std::abs(turn);
  return size > 0 ? turn / size : Complex(1);
}

/// The weights of the planes at the corners. Along each edge, the planes at its ends blend
/// linearly; the products of the ends' barycentric weights blend the results of the three edges.
/// first[k] is the weight of corner k in the blend along the edge from k to k + 1, second[k] its
/// weight along the edge from k - 1 to k. The six weights sum to 1.
struct BlendWeights {
  Vec3 first;
  Vec3 second;
};

double sumOfProducts(const Vec3& b) { return b[0] * b[1] + b[1] * b[2] + b[2] * b[0]; }

BlendWeights blendWeights(const Vec3& b) {
  const double sum = sumOfProducts(b);
  const double half = b[0] * b[1] * b[2] / 2;
  BlendWeights weights;
  for (int k = 0; k < 3; ++k) {
    const double after = b[(k + 1) % 3];
    const double before = b[(k + 2) % 3];
    weights.first[k] = (b[k] * b[k] * after + half) / sum;
    weights.second[k] = (b[k] * b[k] * before + half) / sum;
  }
  return weights;
}

/// The derivatives of blendWeights(b) with respect to b[m].
BlendWeights blendDerivatives(const Vec3& b, const BlendWeights& weights, int m) {
  const double sum = sumOfProducts(b);
  const double sumChange = b[(m + 1) % 3] + b[(m + 2) % 3];
  const double halfChange = b[(m + 1) % 3] * b[(m + 2) % 3] / 2;
  BlendWeights change;
  for (int k = 0; k < 3; ++k) {
    const int after = (k + 1) % 3;
    const int before = (k + 2) % 3;
    const double first = m == k ? 2 * b[k] * b[after] : m == after ? b[k] * b[k] : 0;
    const double second = m == k ? 2 * b[k] * b[before] : m == before ? b[k] * b[k] : 0;
    change.first[k] = (first + halfChange - weights.first[k] * sumChange) / sum;
    change.second[k] = (second + halfChange - weights.second[k] * sumChange) / sum;
  }
  return change;
}

constexpr double kPhongTolerance = 1e-9;

}  // namespace

Array<TangentPlane> tangentPlanes(const Geometry& geometry, const Array<EmbeddedPoint>& positions) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<TangentPlane> planes;
  planes.reserve(positions.size());
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    TangentPlane sum = TangentPlane::Zero();
    const auto addEdge = [&](double direction, double length, int other) {
      const Vec2 along = length * unitVector(geometry.angleScale[v] * direction);
      normal += along * along.transpose();
      sum += along * (positions[other] - positions[v]).transpose();
    };
    for (const int h : outgoingHalfedges(mesh, v)) {
      addEdge(geometry.cumulatedAngle[h], geometry.edgeLength[h], mesh.head(h));
      const int last = previous(h);
      if (mesh.twin[last] >= 0) continue;
      addEdge(geometry.totalAngle[v], geometry.edgeLength[last], mesh.tail(last));
    }
    planes.push_back(orthonormal(normal.inverse() * sum));
  }
  return planes;
}

bool isFolded(const TriangleMesh& mesh, const Array<EmbeddedPoint>& positions,
              const Array<TangentPlane>& planes, int f) {
  const EmbeddedPoint& origin = positions[mesh.corner(f, 0)];
  const EmbeddedPoint u = positions[mesh.corner(f, 1)] - origin;
  const EmbeddedPoint v = positions[mesh.corner(f, 2)] - origin;
  for (int k = 0; k < 3; ++k) {
    const TangentPlane& plane = planes[mesh.corner(f, k)];
    if (!(cross(plane * u, plane * v) > 0)) return true;
  }
  return false;
}

PhongSurface::PhongSurface(const TriangleMesh& mesh, Array<EmbeddedPoint> positions,
                           Array<TangentPlane> planes)
    : mesh_(mesh), positions_(std::move(positions)), planes_(std::move(planes)) {}

EmbeddedPoint PhongSurface::position(const SurfacePoint& point) const {
  EmbeddedPoint x = EmbeddedPoint::Zero();
  for (int k = 0; k < 3; ++k) x += point.bary[k] * positions_[mesh_.corner(point.face, k)];
  return x;
}

TangentPlane PhongSurface::planeAt(const SurfacePoint& point) const {
  for (int k = 0; k < 3; ++k) {
    if (point.bary[k] == 1) return planes_[mesh_.corner(point.face, k)];
  }
  const Patch patch = patchOf(point.face);
  const BlendWeights weights = blendWeights(point.bary);
  TangentPlane sum = TangentPlane::Zero();
  for (int k = 0; k < 3; ++k) {
    const Complex turn =
        weights.first[k] * patch.turnFirst[k] + weights.second[k] * patch.turnSecond[k];
    sum += turned(turn, planes_[mesh_.corner(point.face, k)]);
  }
  return orthonormal(sum);
}

PhongSurface::Patch PhongSurface::patchOf(int f) const {
  Patch patch;
  Complex around = 1;
  Complex turn[3];  // the turn from the plane of corner k to that of corner k + 1
  for (int k = 0; k < 3; ++k) {
    turn[k] = turnBetween(planes_[mesh_.corner(f, k)], planes_[mesh_.corner(f, (k + 1) % 3)]);
    around *= turn[k];
  }
  // The product of the three rotations is not quite 1. Each corner, where the blends of two edges
  // meet, takes a third of the remaining angle.
  const Complex share = std::polar(1.0, -std::arg(around) / 3);
  Complex edgeTurn[3];
  edgeTurn[0] = 1;
  edgeTurn[1] = edgeTurn[0] / (turn[1] * share);
  edgeTurn[2] = edgeTurn[1] / (turn[2] * share);
  for (int k = 0; k < 3; ++k) {
    patch.turnFirst[k] = turn[k] * edgeTurn[k];
    patch.turnSecond[k] = edgeTurn[(k + 2) % 3];
    const TangentPlane& plane = planes_[mesh_.corner(f, k)];
    for (int c = 0; c < 3; ++c) {
      patch.corners[k][c] =
          inPlane(plane, positions_[mesh_.corner(f, c)] - positions_[mesh_.corner(f, 0)]);
    }
  }
  return patch;
}

PhongSurface::FaceProjection PhongSurface::projectInFace(int f, const EmbeddedPoint& p) const {
  Patch patch = patchOf(f);
  double size = 0;
  for (int k = 0; k < 3; ++k) {
    patch.target[k] = inPlane(planes_[mesh_.corner(f, k)], p - positions_[mesh_.corner(f, 0)]);
    size = std::max(size, std::abs(patch.corners[k][k] - patch.corners[k][(k + 1) % 3]));
  }
  Vec3 b = Vec3::Constant(1.0 / 3);
  constexpr int kMostSteps = 20;
  for (int step = 0; step < kMostSteps; ++step) {
    const BlendWeights weights = blendWeights(b);
    // the vector from the point of the face to the target, in the plane of corner k
    Complex offset[3];
    Complex turn[3];
    Complex residual = 0;
    for (int k = 0; k < 3; ++k) {
      offset[k] = patch.target[k];
      for (int c = 0; c < 3; ++c) offset[k] -= b[c] * patch.corners[k][c];
      turn[k] = weights.first[k] * patch.turnFirst[k] + weights.second[k] * patch.turnSecond[k];
      residual += turn[k] * offset[k];
    }
    if (std::abs(residual) <= 1e-11 * size) {
      return {b, b.minCoeff() >= -kPhongTolerance};
    }
    Complex slope[3];
    for (int m = 0; m < 3; ++m) {
      const BlendWeights change = blendDerivatives(b, weights, m);
      for (int k = 0; k < 3; ++k) {
        slope[m] +=
            (change.first[k] * patch.turnFirst[k] + change.second[k] * patch.turnSecond[k]) *
                offset[k] -
            turn[k] * patch.corners[k][m];
      }
    }
    const Vec2 right(residual.real(), residual.imag());
    const Vec2 first((slope[1] - slope[0]).real(), (slope[1] - slope[0]).imag());
    const Vec2 second((slope[2] - slope[0]).real(), (slope[2] - slope[0]).imag());
    const double determinant = cross(first, second);
    const Vec2 move = Vec2(-cross(right, second), -cross(first, right)) / determinant;
    if (!move.allFinite()) break;
    b += Vec3(-move.x() - move.y(), move.x(), move.y());
    if (b.minCoeff() < -0.5) break;
  }
  return {b, false};
}

std::optional<SurfacePoint> PhongSurface::project(const EmbeddedPoint& p,
                                                  const SurfacePoint& start) const {
  const FaceProjection projection = projectInFace(start.face, p);
  if (projection.found) return clampedPoint(start.face, projection.bary);
  const int vertex = nearestVertex(p, mesh_.corner(start.face, 0));
  if (std::optional<SurfacePoint> point = walk(p, faceOf(mesh_.outgoing[vertex]))) {
    return point;
  }
  return searchAround(p, vertex);
}

std::optional<SurfacePoint> PhongSurface::walk(const EmbeddedPoint& p, int face) const {
  constexpr int kMostFaces = 1000;
  int before = -1;
  for (int i = 0; i < kMostFaces; ++i) {
    const FaceProjection projection = projectInFace(face, p);
    if (projection.found) return clampedPoint(face, projection.bary);
    int corner = 0;
    projection.bary.minCoeff(&corner);
    const int twin = mesh_.twin[3 * face + (corner + 1) % 3];
    if (twin < 0 || faceOf(twin) == before) return std::nullopt;
    before = face;
    face = faceOf(twin);
  }
  return std::nullopt;
}

int PhongSurface::nearestVertex(const EmbeddedPoint& p, int vertex) const {
  double least = (positions_[vertex] - p).squaredNorm();
  for (int step = 0; step < mesh_.vertexCount(); ++step) {
    int best = vertex;
    for (const int h : outgoingHalfedges(mesh_, vertex)) {
      for (const int neighbour : {mesh_.head(h), mesh_.opposite(h)}) {
        const double distance = (positions_[neighbour] - p).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = neighbour;
      }
    }
    if (best == vertex) break;
    vertex = best;
  }
  return vertex;
}

std::optional<SurfacePoint> PhongSurface::searchAround(const EmbeddedPoint& p, int vertex) const {
  constexpr int kMostFaces = 200;
  Array<int> queue{faceOf(mesh_.outgoing[vertex])};
  std::unordered_set<int> seen(queue.begin(), queue.end());
  for (int i = 0; i < queue.count() && i < kMostFaces; ++i) {
    const FaceProjection projection = projectInFace(queue[i], p);
    if (projection.found) return clampedPoint(queue[i], projection.bary);
    for (int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
      const int twin = mesh_.twin[h];
      if (twin >= 0 && seen.insert(faceOf(twin)).second) queue.push_back(faceOf(twin));
    }
  }
  return std::nullopt;
}

}  // namespace karcher
