#pragma once

#include "mesh/types.h"

namespace karcher {

/// The point of triangle a, b, c nearest to q, as barycentric weights.
Vec3 nearestInTriangle(const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace karcher
