#pragma once

#include "rcm/center_of_mass.h"
#include "rcm/field_options.h"

/// The search of each method.
namespace karcher {

/// The center of mass of the blended fields, by the method's search.
CenterOfMass findCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                        Method method);

/// Whether the method's search goes on where the Hessian is not positive definite, as our walk
/// does. Newton's method, the paper's, stops there: its answer depends on where it starts.
inline bool goesOnWhereIndefinite(Method method) { return method != Method::kPaper; }

}  // namespace karcher
