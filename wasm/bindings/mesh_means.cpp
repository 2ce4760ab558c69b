#include <cmath>
#include <string>

#include "bindings/field_options.h"
#include "bindings/mesh_handle.h"
#include "mesh/error.h"
#include "rcm/certificate.h"
#include "rcm/mean.h"
#include "rcm/mean_weights.h"

namespace karcher::bindings {

void MeshHandle::prepareFields(const val& field) {
  karcher::prepareFields(surface_, fieldOptionsFromJs(field));
}

val MeshHandle::centerOfMass(const val& points, const val& weights, const val& start,
                             bool normalize, bool looksForOthers, bool certifies,
                             const val& field) {
  MeanOptions options = meanOptions(start, normalize);
  options.looksForOthers = looksForOthers;
  options.smooth = smooth_;
  options.field = fieldOptionsFromJs(field);
  const Array<SurfacePoint> places = pointsFromJs(numbering_, mesh(), points);
  const Array<double> masses = fromJs<double>(weights);
  const Mean mean = karcher::centerOfMass(*fieldSets_, places, masses, options, fields_);
  val result = meanToJs(mean);
  if (certifies) {
    const Certificate measured =
        certificateOf(surface_.geometry(), places, masses, normalize, mean.point);
    val certificate = val::object();
    certificate.set("energy", measured.energy);
    certificate.set("residual", measured.residual);
    result.set("certificate", certificate);
  }
  return result;
}

val MeshHandle::weightsOf(const val& point, const val& points, const val& given, bool nonNegative,
                          const val& field) {
  fields_ = fieldSets_->of(fieldOptionsFromJs(field));
  const MeanWeights weights = karcher::weightsOf(*fields_, pointFromJs(numbering_, mesh(), point),
                                                 pointsFromJs(numbering_, mesh(), points),
                                                 {fromJs<double>(given), nonNegative});
  val result = val::object();
  result.set("weights", toJs(weights.weights));
  result.set("isMinimum", weights.isMinimum);
  return result;
}

val MeshHandle::centerOfMassOfDistances(const val& distances, const val& weights, const val& start,
                                        bool normalize) {
  const Array<double> numbers = fromJs<double>(distances);
  const size_t count = numbers.size() / numbering_.engineVertex.size();
  Array<Array<double>> fields;
  for (size_t i = 0; i < count; ++i) fields.push_back(engineDistances(numbers, i));
  return meanToJs(karcher::centerOfMassOfDistances(surface_, fields, fromJs<double>(weights),
                                                   meanOptions(start, normalize)));
}

val MeshHandle::centersOfMass(const val& points, const val& rows, const val& start, bool normalize,
                              bool isChecked, const val& field) {
  MeanOptions options = meanOptions(start, normalize);
  options.isChecked = isChecked;
  options.field = fieldOptionsFromJs(field);
  const Array<Mean> means =
      karcher::centersOfMass(*fieldSets_, pointsFromJs(numbering_, mesh(), points),
                             fromJs<double>(rows), options, fields_);
  Array<SurfacePoint> centers;
  Array<double> positions;
  Array<double> energies;
  val statuses = val::array();
  for (const Mean& mean : means) {
    centers.push_back(mean.point);
    append(positions, karcher::position(mesh(), mean.point));
    energies.push_back(mean.energy);
    statuses.call<void>("push", std::string(statusName(mean.status)));
  }
  val result = val::object();
  result.set("point", toJs(numbering_, centers));
  result.set("position", toJs(positions));
  result.set("energy", toJs(energies));
  result.set("status", statuses);
  return result;
}

MeanOptions MeshHandle::meanOptions(const val& start, bool normalize) const {
  MeanOptions options;
  options.normalize = normalize;
  const Array<SurfacePoint> starts = pointsFromJs(numbering_, mesh(), start);
  if (!starts.empty()) options.start = starts[0];
  return options;
}

val MeshHandle::meanToJs(const Mean& mean) const {
  val result = val::object();
  result.set("point", toJs(numbering_, mean.point));
  result.set("position", toJs(karcher::position(mesh(), mean.point)));
  result.set("status", std::string(statusName(mean.status)));
  result.set("iterations", mean.iterations);
  result.set("energy", mean.energy);
  result.set("uniqueness", std::string(uniquenessName(mean.uniqueness)));
  val others = val::array();
  for (int i = 0; i < mean.otherMinima.count(); ++i) {
    const Minimum& minimum = mean.otherMinima[i];
    val other = val::object();
    other.set("point", toJs(numbering_, minimum.point));
    other.set("position", toJs(karcher::position(mesh(), minimum.point)));
    other.set("energy", minimum.energy);
    others.set(i, other);
  }
  result.set("otherMinima", others);
  return result;
}

/// The field with the number `field` in a caller's distances, in the engine's order. Errors name
/// the caller's vertex.
Array<double> MeshHandle::engineDistances(const Array<double>& distances, size_t field) const {
  const double* own = distances.data() + field * numbering_.engineVertex.size();
  Array<double> result;
  result.reserve(numbering_.inputVertex.size());
  for (const int v : numbering_.inputVertex) {
    if (!std::isfinite(own[v]) || own[v] < 0) {
      throw Error(ErrorCode::kNotFinite, "the distance at vertex " + std::to_string(v) +
                                             " of array " + std::to_string(field) +
                                             " must be a finite number of at least 0");
    }
    result.push_back(own[v]);
  }
  return result;
}

}  // namespace karcher::bindings
