#include "distance/tangent_maps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "intrinsic/surface_path.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "mesh/sign_change.h"

namespace karcher {
namespace {

/// The search for the nearest point begins at the ends of this number of equal parts of the line.
constexpr int kParts = 12;

/// A point of a line, and the path to it from the mirrored point.
struct LinePoint {
  double length = 0;  ///< the length from the line's start
  SurfacePath path;
  Vec2 along = Vec2::Zero();  ///< the line's unit tangent, at the end of the path
  double slope = 0;           ///< the derivative of the path's length along the line
};

LinePoint linePointAt(const Geometry& geometry, const SurfacePath& line, double length,
                      const SurfacePoint& point, FindPathWorkspace& workspace) {
  const TriangleMesh& mesh = *geometry.mesh;
  LinePoint result;
  result.length = length;
  const SurfacePoint at = pointAlong(mesh, line, length);
  result.path = pathBetween(geometry, point, at, workspace);
  SurfacePath rest;
  const bool isOnward = length < line.length() / 2;
  appendPart(mesh, line, length, isOnward ? line.length() : 0, rest);
  rest.points.front() = result.path.end();
  measure(mesh, rest);
  result.along = logAlong(geometry, rest).normalized() * (isOnward ? 1 : -1);
  const Vec2 back = logBack(geometry, result.path);
  result.slope = back.norm() > 0 ? -back.normalized().dot(result.along) : 0;
  return result;
}

[[noreturn]] void throwNoFoot() {
  throw Error(
      ErrorCode::kBadArgument,
      "no perpendicular leads from a point to the line: the nearest point of the line is its "
      "end");
}

/// The point of a line nearest to a point. The search compares the ends of kParts equal parts of
/// the line, and continues between the nearest of them and a neighbour. An end of the line from
/// which the line leads away has no perpendicular to the point. Another part of the line may.
LinePoint footOn(const Geometry& geometry, const SurfacePath& line, const SurfacePoint& point,
                 FindPathWorkspace& workspace) {
  const double whole = line.length();
  const auto at = [&](double length) {
    return linePointAt(geometry, line, length, point, workspace);
  };
  const auto atPart = [&](int i) { return at(i == kParts ? whole : whole * i / kParts); };
  const auto leadsAway = [&](const LinePoint& end) {
    return end.length == whole ? end.slope < 0 : end.length == 0 && end.slope >= 0;
  };
  // If a point lies on the perpendicular at an end of the line, rounding may put its foot beyond
  // the end.
  const auto isFoot = [&](const LinePoint& end) {
    const double far = end.path.length();
    return std::abs(end.slope) * far <= kLocalRounding * (whole + far);
  };
  LinePoint best;
  int nearest = -1;
  double fromEnd = kInfinity;
  for (int i = 0; i <= kParts; ++i) {
    LinePoint candidate = atPart(i);
    const double far = candidate.path.length();
    if (leadsAway(candidate) && !isFoot(candidate)) {
      fromEnd = std::min(fromEnd, far);
    } else if (nearest < 0 || far < best.path.length()) {
      best = std::move(candidate);
      nearest = i;
    }
  }
  if (nearest < 0) throwNoFoot();
  if (!leadsAway(best)) {
    // The slope changes its sign between the best point and its neighbour, unless the neighbour is
    // an end of the line and the foot lies beyond it.
    const bool isAhead = best.slope < 0;
    LinePoint other = atPart(isAhead ? nearest + 1 : nearest - 1);
    if (leadsAway(other)) {
      if (!isFoot(other)) throwNoFoot();
      return other;
    }
    const LinePoint& low = isAhead ? best : other;
    const LinePoint& high = isAhead ? other : best;
    const double rounding = kStepRounding * whole;
    signChange(low.length, high.length, low.slope, high.slope, rounding, [&](double length) {
      LinePoint candidate = at(length);
      const double slope = candidate.slope;
      // Near the foot, lengths differ only by rounding, so that the slope decides.
      const bool isNearer = candidate.path.length() < (1 - kLocalRounding) * best.path.length();
      if (isNearer || std::abs(slope) < std::abs(best.slope)) best = std::move(candidate);
      return slope;
    });
  }
  if (fromEnd < (1 - kLocalRounding) * best.path.length()) throwNoFoot();
  return best;
}

}  // namespace

SurfacePath pathBetween(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                        FindPathWorkspace& workspace) {
  SurfacePath path;
  if (findPath(geometry, from, to, workspace, path)) return path;
  throw Error(ErrorCode::kUnreachable,
              "no path joins two of the points: they lie on different components of the mesh");
}

LogMapped logMap(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& point,
                 const Vec2& direction, FindPathWorkspace& workspace) {
  const SurfacePath path = pathBetween(geometry, from, point, workspace);
  return {logAlong(geometry, path), transportAlong(geometry, reversed(path), direction)};
}

ExpMapped expMap(const Geometry& geometry, const SurfacePoint& from, const Vec2& vector,
                 const Vec2& direction) {
  const SurfacePath path = expAlong(geometry, from, vector);
  const double remaining = std::max(0.0, vector.stableNorm() - path.length());
  return {path.end(), transportAlong(geometry, path, direction), remaining};
}

ExpMapped mirrored(const Geometry& geometry, const SurfacePath& line, const SurfacePoint& point,
                   const Vec2& direction, FindPathWorkspace& workspace) {
  if (!(line.length() > 0)) {
    throw Error(ErrorCode::kBadArgument, "a line to mirror in must have a length");
  }
  const LinePoint foot = footOn(geometry, line, point, workspace);
  const Vec2 back = logBack(geometry, foot.path);
  const auto reflected = [&](const Vec2& vector) -> Vec2 {
    return 2 * vector.dot(foot.along) * foot.along - vector;
  };
  const Vec2 carried = transportAlong(geometry, foot.path, direction);
  return expMap(geometry, foot.path.end(), reflected(back), reflected(carried));
}

}  // namespace karcher
