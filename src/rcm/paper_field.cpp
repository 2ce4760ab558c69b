#include <memory>
#include <string>
#include <utility>

#include "mesh/error.h"
#include "rcm/paper_method.h"

namespace karcher {
namespace {

/// The largest distance that a caller may give, so that doubles can hold products of several
/// squared distances, even on the smallest faces.
constexpr double kLargestDistance = 1e60;

}  // namespace

ControlField fieldOfSquares(Surface& surface, Star star, Array<double> squaredDistances) {
  const auto squares = std::make_shared<const Array<double>>(std::move(squaredDistances));
  const auto gradients =
      std::make_shared<const Array<Vec2>>(applyGradient(surface.gradientOperator(star), *squares));
  ControlField field;
  field.reset([squares, gradients](int v) { return FieldValue{(*gradients)[v], (*squares)[v]}; });
  return field;
}

ControlField fieldFromDistances(Surface& surface, const Array<double>& distances) {
  const int vertexCount = surface.mesh().vertexCount();
  if (distances.count() != vertexCount) {
    throw Error(ErrorCode::kBadArgument,
                "a field takes one distance a vertex: " + std::to_string(vertexCount) + ", not " +
                    std::to_string(distances.size()));
  }
  Array<double> squares = distances;
  for (int v = 0; v < vertexCount; ++v) {
    if (!std::isfinite(distances[v]) || distances[v] < 0) {
      throw Error(ErrorCode::kNotFinite, "the distance at vertex " + std::to_string(v) +
                                             " must be a finite number of at least 0, not " +
                                             inSentence(distances[v]));
    }
    if (distances[v] > kLargestDistance) {
      throw Error(ErrorCode::kBadArgument, "the distance at vertex " + std::to_string(v) + " is " +
                                               inSentence(distances[v]) + "; at most " +
                                               inSentence(kLargestDistance) + " is allowed");
    }
    squares[v] *= distances[v];
  }
  return fieldOfSquares(surface, Star::kWide, std::move(squares));
}

}  // namespace karcher
