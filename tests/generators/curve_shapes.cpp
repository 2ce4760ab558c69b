#include "generators/curve_shapes.h"

namespace karcher {

Array<CurveShape> everyShape(int points) {
  Array<CurveShape> all;
  for (const bool closed : {false, true}) {
    for (const CurveKind kind : kCurveKinds) {
      if (kind == CurveKind::kOwn) continue;
      all.push_back({kind, closed});
      Array<double> values;
      for (int i = 0; i < points; ++i) values.push_back(0.5 + i % 3);
      if (takesWeights(kind)) all.back().weights = values;
      if (takesBetas(kind)) all.back().betas = values;
    }
    all.push_back({CurveKind::kBSpline, closed});
    all.push_back({CurveKind::kBSpline, closed, 2});
    all.push_back({CurveKind::kBSpline, closed, 5});
  }
  all.push_back({CurveKind::kBSpline, false, 3, KnotRule::kClamped});
  return all;
}

CurveOptions ofLevelZero(const CurveShape& shape, int samples, const FieldOptions& field,
                         double tolerance) {
  CurveOptions options{shape, samples, field, tolerance};
  options.levels = 0;
  return options;
}

std::string describe(const CurveShape& shape) {
  return std::string(curveKindName(shape.kind)) + (shape.closed ? " closed" : "") + " degree " +
         std::to_string(shape.degree) + " rule " + std::to_string(static_cast<int>(shape.knotRule));
}

}  // namespace karcher
