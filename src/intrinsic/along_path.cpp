#include "intrinsic/along_path.h"

#include <algorithm>

#include "intrinsic/strip_path.h"

namespace karcher {

SurfacePoint pointBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b,
                          double s) {
  const int face = commonFace(mesh, a, b);
  if (face < 0) return s < 0.5 ? a : b;
  const Vec3 from = inFace(mesh, a, face).bary;
  return clampedPoint(face, from + s * (inFace(mesh, b, face).bary - from));
}

int pieceAt(const Array<double>& lengths, double length) {
  const auto beyond = std::upper_bound(lengths.begin(), lengths.end(), length);
  return std::clamp(static_cast<int>(beyond - lengths.begin()) - 1, 0, lengths.count() - 2);
}

SurfacePoint pointAlong(const TriangleMesh& mesh, const Array<SurfacePoint>& path,
                        const Array<double>& lengths, double length) {
  const int k = pieceAt(lengths, length);
  const double piece = lengths[k + 1] - lengths[k];
  const double s = piece > 0 ? std::clamp((length - lengths[k]) / piece, 0.0, 1.0) : 0;
  if (s == 0) return path[k];
  if (s == 1) return path[k + 1];
  return pointBetween(mesh, path[k], path[k + 1], s);
}

}  // namespace karcher
