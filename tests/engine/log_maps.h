#pragma once

#include "peers/vector_heat.h"

namespace karcher {

/// The log map from any point, in the frame of the point's face. As in the authors' library, it
/// interpolates the log maps from the face's corners, turned by cornerRotation, with the point's
/// barycentric weights. The paper does not treat sources other than vertices.
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
