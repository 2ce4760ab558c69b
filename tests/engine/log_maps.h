#pragma once

#include "peers/vector_heat.h"

namespace karcher {

/// The log map from any point, in the frame of its face: the log maps from the face's corners,
/// turned by cornerRotation and interpolated by the point's barycentric weights, as in the authors'
/// library; the paper does not treat such sources.
inline LogMap logMapFromPoint(const Geometry& geometry, const LogMapFromVertex& fromVertex,
                              const SurfacePoint& source) {
  LogMap logs(geometry.mesh->positions.size(), Vec2::Zero());
  for (int k = 0; k < 3; ++k) {
    if (source.bary[k] == 0) continue;
    const Vec2 rotation = source.bary[k] * cornerRotation(geometry, source, k);
    const LogMap fromCorner = fromVertex(geometry.mesh->corner(source.face, k));
    for (int v = 0; v < logs.count(); ++v) {
      if (!fromCorner[v].allFinite() || !logs[v].allFinite()) {
        logs[v] = noLogarithm();
      } else {
        logs[v] += rotate(rotation, fromCorner[v]);
      }
    }
  }
  return logs;
}

}  // namespace karcher
