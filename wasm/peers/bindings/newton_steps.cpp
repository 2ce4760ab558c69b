#include "peers/bindings/newton_steps.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <string>

#include "bindings/field_options.h"
#include "mesh/error.h"
#include "rcm/paper_method.h"
#include "rcm/point_field.h"

namespace karcher::bindings {

val newtonSteps(MeshHandle& mesh, const val& points, const val& weights, const val& options,
                bool warm) {
  const Array<SurfacePoint> places = pointsFromJs(mesh.numbering(), mesh.mesh(), points);
  const FieldOptions fieldOptions = fieldOptionsFromJs(options);
  const Array<double> all = fromJs<double>(weights);
  const int count = places.count();
  if (count == 0 || all.count() % count != 0) {
    throw Error(ErrorCode::kBadWeights, std::to_string(all.count()) + " weights are no rows for " +
                                            std::to_string(count) + " points");
  }
  std::deque<PointField> fields;
  Array<ControlField*> pointers;
  for (const SurfacePoint& place : places) {
    fields.emplace_back(mesh.surface(), fieldOptions).setPoint(place);
    pointers.push_back(&fields.back().field());
  }
  FieldBlend blend(mesh.surface().geometry(), pointers);
  Array<double> numbers;
  std::optional<SurfacePoint> last;
  for (auto row = all.begin(); row != all.end(); row += count) {
    const Array<double> ofRow(row, row + count);
    const auto largest = std::max_element(ofRow.begin(), ofRow.end()) - ofRow.begin();
    NewtonSteps steps;
    const SearchEnd center =
        newtonCenter(blend, ofRow, warm && last ? *last : places[largest], steps);
    const bool converged = center.status == Status::kConverged;
    if (converged) {
      last = center.point;
    } else {
      last.reset();
    }
    const auto& [here, before, first] = steps.gradients;
    for (const double number : {double(converged), double(center.iterations), double(steps.traced),
                                double(steps.shortened), double(steps.needed), double(steps.stuck),
                                double(steps.inside), here, before, first}) {
      numbers.push_back(number);
    }
  }
  return toJs(numbers);
}

}  // namespace karcher::bindings
