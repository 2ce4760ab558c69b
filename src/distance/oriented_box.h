#pragma once

#include "mesh/types.h"

namespace karcher {

/// A box in space with axes of its own: where a solver is kept to.
struct OrientedBox {
  Vec3 center = Vec3::Zero();
  Vec3 axes[3] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};  ///< unit, at right angles
  Vec3 halfSize = Vec3::Zero();                                  ///< along the axes

  bool contains(const Vec3& p) const {
    const Vec3 off = p - center;
    return std::abs(axes[0].dot(off)) <= halfSize[0] && std::abs(axes[1].dot(off)) <= halfSize[1] &&
           std::abs(axes[2].dot(off)) <= halfSize[2];
  }

  bool operator==(const OrientedBox& other) const {
    return center == other.center && axes[0] == other.axes[0] && axes[1] == other.axes[1] &&
           axes[2] == other.axes[2] && halfSize == other.halfSize;
  }
};

}  // namespace karcher
