#pragma once

#include "rcm/center_of_mass.h"
#include "rcm/field_options.h"

/// The search for centers by each method.
namespace karcher {

/// The center of mass of the blended fields, by the method's search.
CenterOfMass findCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                        Method method);

/// Whether the method's search continues at places where the Hessian is not positive definite. Our
/// walk continues there. The paper's Newton method stops, so that its result depends on its start.
inline bool goesOnWhereIndefinite(Method method) { return method != Method::kPaper; }

}  // namespace karcher
