#pragma once

#include "rcm/field_options.h"
#include "rcm/paper_method.h"
#include "rcm/walk_to_center.h"

/// The search for centers by each method.
namespace karcher {

/// The center of mass of the blended fields, by the method's search.
inline SearchEnd findCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                            Method method) {
  return method == Method::kPaper ? newtonCenter(fields, weights, start)
                                  : walkToCenter(fields, weights, start);
}

/// Whether the method's search continues at places where the Hessian is not positive definite. Our
/// walk continues there. The paper's Newton method stops, so that its result depends on its start.
inline bool goesOnWhereIndefinite(Method method) { return method != Method::kPaper; }

}  // namespace karcher
