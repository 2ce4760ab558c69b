#include "intrinsic/straightest.h"

#include <algorithm>
#include <optional>

#include "mesh/error.h"

namespace karcher {
namespace {

/// The state of a walk: a point in a face and the unit direction of travel in that face.
struct Walker {
  SurfacePoint point;
  Vec2 direction;
};

Vec2 unitAtAngle(const Geometry& geometry, int h, double angle) {
  return rotate(unitVector(angle), halfedgeInFace(geometry, h)) / geometry.edgeLength[h];
}

/// The walker that leaves `vertex` in an unscaled direction; empty if the direction points off the
/// surface.
std::optional<Walker> leaveVertex(const Geometry& geometry, int vertex, double direction) {
  const CornerDirection corner = cornerOfDirection(geometry, vertex, direction);
  if (corner.halfedge < 0) return std::nullopt;
  return Walker{edgePoint(corner.halfedge, 0),
                unitAtAngle(geometry, corner.halfedge, corner.angle)};
}

/// The walker that continues after it arrives at the tail of h along `direction` in h's face.
std::optional<Walker> passVertex(const Geometry& geometry, int h, const Vec2& direction) {
  const int vertex = geometry.mesh->tail(h);
  const double back = directionAtTail(geometry, h, -direction);
  if (!geometry.mesh->onBoundary[vertex]) {
    return leaveVertex(geometry, vertex, back + geometry.totalAngle[vertex] / 2);
  }
  // Along a straight boundary, or past a reentrant corner, the surface continues straight ahead.
  return leaveVertex(geometry, vertex, back + kPi);
}

/// The rates of change of the barycentric weights along a direction in face f.
Vec3 barycentricRates(const Geometry& geometry, int f, const Vec2& direction) {
  const Vec2& apex = geometry.apex[f];
  const double r2 = direction.y() / apex.y();
  const double r1 = (direction.x() - r2 * apex.x()) / geometry.edgeLength[3 * f];
  return {-r1 - r2, r1, r2};
}

/// Moves a walker on an edge or at a vertex into the face to which its direction points. The result
/// is empty if the direction points off the surface.
std::optional<Walker> enterFace(const Geometry& geometry, const Walker& walker) {
  const PointLocation location = locate(*geometry.mesh, walker.point);
  if (location.simplex == Simplex::kVertex) {
    int h = 3 * location.face;
    while (walker.point.bary[cornerOf(h)] == 0) ++h;
    return leaveVertex(geometry, location.vertex, directionAtTail(geometry, h, walker.direction));
  }
  if (location.simplex == Simplex::kEdge) {
    const int h = location.halfedge;
    const Vec2 along = halfedgeInFace(geometry, h);
    if (cross(along, walker.direction) < -kLocalRounding * geometry.edgeLength[h]) {
      const int t = geometry.mesh->twin[h];
      if (t < 0) return std::nullopt;
      return Walker{edgePoint(t, walker.point.bary[cornerOf(h)]),
                    acrossEdge(geometry, h, walker.direction)};
    }
  }
  return walker;
}

struct FaceExit {
  double length = kInfinity;
  int corner = -1;  ///< the corner whose weight becomes 0
};

FaceExit exitOfFace(const Vec3& bary, const Vec3& rates) {
  FaceExit exit;
  // The threshold keeps a walk along an edge in the face: its rate of leaving is rounding noise.
  const double threshold = -1e-13 * rates.cwiseAbs().maxCoeff();
  for (int k = 0; k < 3; ++k) {
    // A walk does not leave by the edge on which it starts. Otherwise it could circle a vertex
    // forever on slivers, where the noise exceeds the threshold.
    if (bary[k] == 0 || rates[k] >= threshold) continue;
    const double length = bary[k] / -rates[k];
    if (length < exit.length) exit = {length, k};
  }
  return exit;
}

class Walk {
 public:
  /// A walk that writes to `path`.
  Walk(const Geometry& geometry, const StraightestOptions& options, double length,
       StraightestPath& path)
      : geometry_(geometry), crossingsLeft_(options.maxCrossings), path_(path) {
    path_.path.points.clear();
    path_.path.lengths.clear();
    path_.remaining = length;
    path_.stop = TraceStop::kComplete;
    path_.direction = Vec2(1, 0);
  }

  void run(const SurfacePoint& start, std::optional<Walker> walker) {
    append(start);
    while (walker && path_.remaining > 0 && crossingsLeft_-- > 0) {
      if (walker->point.face != path_.path.end().face) append(walker->point);
      path_.direction = walker->direction;
      walker = step(*walker);
    }
    if (path_.remaining > 0) path_.stop = walker ? TraceStop::kLimit : TraceStop::kBoundary;
    if (path_.path.points.count() < 2) append(start);
  }

 private:
  void append(const SurfacePoint& point) {
    path_.path.points.push_back(point);
    path_.path.lengths.push_back(walked_);
  }

  /// Walks through one face. Returns the walker in the next face, or nothing if the walk ends here
  /// or meets the boundary.
  std::optional<Walker> step(const Walker& walker) {
    const int f = walker.point.face;
    Vec3 bary = walker.point.bary;
    const Vec3 rates = barycentricRates(geometry_, f, walker.direction);
    const FaceExit exit = exitOfFace(bary, rates);
    // Beyond an edge or a vertex, a rest that weights do not show is rounding. It has no direction,
    // so that the walk ends on the edge or at the vertex.
    const bool isRounding =
        walked_ > 0 && path_.remaining * rates.cwiseAbs().maxCoeff() < kLocalRounding;
    if (isRounding) {
      path_.remaining = 0;
      return std::nullopt;
    }
    if (path_.remaining < exit.length) {
      bary = (bary + path_.remaining * rates).cwiseMax(0.0);
      walked_ += path_.remaining;
      append(clampedPoint(f, bary));
      path_.remaining = 0;
      return std::nullopt;
    }
    walked_ += exit.length;
    path_.remaining -= exit.length;
    bary += exit.length * rates;
    bary[exit.corner] = 0;
    const int h = 3 * f + (exit.corner + 1) % 3;
    const double s = std::clamp(bary[cornerOf(next(h))], 0.0, 1.0);
    if (s <= kLocalRounding || s >= 1 - kLocalRounding) {
      const int corner = s < 0.5 ? h : next(h);
      append(edgePoint(corner, 0));
      return passVertex(geometry_, corner, walker.direction);
    }
    append(edgePoint(h, s));
    const int t = geometry_.mesh->twin[h];
    if (t < 0) return std::nullopt;
    return Walker{edgePoint(t, 1 - s), acrossEdge(geometry_, h, walker.direction)};
  }

  const Geometry& geometry_;
  int crossingsLeft_;
  double walked_ = 0;
  StraightestPath& path_;
};

}  // namespace

const char* traceStopName(TraceStop stop) {
  switch (stop) {
    case TraceStop::kComplete:
      return "complete";
    case TraceStop::kBoundary:
      return "boundary";
    case TraceStop::kLimit:
      return "limit";
  }
  return "unknown";
}

int mostCrossingsOfSearch(const TriangleMesh& mesh) {
  return static_cast<int>(16'000 + 256 * std::sqrt(mesh.faceCount()));
}

void traceStraightest(const Geometry& geometry, const SurfacePoint& start, const Vec2& vector,
                      StraightestPath& path, const StraightestOptions& options) {
  if (!vector.allFinite()) {
    throw Error(ErrorCode::kNotFinite, "the direction of a geodesic must be finite");
  }
  const double length = vector.stableNorm();
  Walk walk(geometry, options, length, path);
  if (length == 0) return walk.run(start, std::nullopt);
  walk.run(start, enterFace(geometry, {start, vector / length}));
}

StraightestPath traceStraightest(const Geometry& geometry, const SurfacePoint& start,
                                 const Vec2& vector, const StraightestOptions& options) {
  StraightestPath path;
  traceStraightest(geometry, start, vector, path, options);
  return path;
}

void traceFromVertex(const Geometry& geometry, int vertex, double direction, double length,
                     StraightestPath& path, const StraightestOptions& options) {
  if (!std::isfinite(direction) || !std::isfinite(length)) {
    throw Error(ErrorCode::kNotFinite, "the direction and length of a geodesic must be finite");
  }
  Walk(geometry, options, length, path)
      .run(vertexPoint(*geometry.mesh, vertex), leaveVertex(geometry, vertex, direction));
}

StraightestPath traceFromVertex(const Geometry& geometry, int vertex, double direction,
                                double length, const StraightestOptions& options) {
  StraightestPath path;
  traceFromVertex(geometry, vertex, direction, length, path, options);
  return path;
}

}  // namespace karcher
