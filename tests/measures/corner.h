#pragma once

#include "curves/curve.h"

/// How smooth a curve is at its joints.
namespace karcher {

/// The angle between the directions of a curve just before and just behind a parameter, degrees.
/// Not a number where these lie in faces that share no edge.
double cornerAt(Curve& curve, double parameter);

}  // namespace karcher
