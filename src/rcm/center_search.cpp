#include "rcm/center_search.h"

#include "rcm/paper_method.h"

namespace karcher {

CenterOfMass findCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                        Method method) {
  return method == Method::kPaper ? newtonCenter(fields, weights, start)
                                  : walkToCenter(fields, weights, start);
}

}  // namespace karcher
