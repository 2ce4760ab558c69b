#pragma once

#include "mesh/types.h"

namespace karcher {

/// The barycentric weights of the point of the triangle a, b, c that is nearest to q.
Vec3 nearestInTriangle(const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace karcher
