#pragma once

#include "curves/curve.h"

/// The smoothness of a curve at its joints.
namespace karcher {

/// The angle between the directions of a curve just before and after a parameter, in degrees. Not a
/// number if these lie in faces without a common edge.
double cornerAt(Curve& curve, double parameter);

}  // namespace karcher
