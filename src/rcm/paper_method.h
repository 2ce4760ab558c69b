#pragma once

#include <array>

#include "rcm/field_blend.h"
#include "rcm/search_end.h"
#include "rcm/surface.h"

/// The method of C. Mancinelli, E. Puppo, "Computing the Riemannian Center of Mass on Meshes"
/// (`method: 'paper'`). Fields are gradients of squared distances, from the exact solver or the
/// k-ring graph (ring_graph.h). Newton's method finds their zeros.
namespace karcher {

/// The field of given squared distances, with one distance for each vertex. The field's values are
/// the gradients over the given star (Eq. 3, gradient_operator.h).
ControlField fieldOfSquares(Surface& surface, Star star, Array<double> squaredDistances);

/// A field of a caller's own distances, one for each vertex. Throws Error: kBadArgument if there is
/// not one distance for each vertex or if a distance exceeds 1e60; kNotFinite if a distance is
/// negative or not finite.
ControlField fieldFromDistances(Surface& surface, const Array<double>& distances);

/// Newton's method along geodesics (Algorithm 1) from `start`. If each of two neighbouring faces
/// has its zero in the other, the center is the zero on their edge (FieldBlend::zeroAlongEdge).
SearchEnd newtonCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start);

/// Counts of a search's steps, for studies of the paper's claims.
struct NewtonSteps {
  int traced = 0;     ///< the number of geodesics along steps of Newton's method
  int shortened = 0;  ///< the number of geodesics that the search cut at a joint
  /// the number of shortened geodesics whose original end has no smaller gradient than their start
  int needed = 0;
  /// the number of geodesics whose joints and end have no smaller gradient than their start
  int stuck = 0;
  bool inside = false;  ///< whether a zero inside a triangle ended the search
  /// The norms of the gradients at the starts of the last three iterations, the last one first; 0
  /// for an iteration that did not take place.
  std::array<double, 3> gradients{};
};

/// The same search, which also counts its steps.
SearchEnd newtonCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                       NewtonSteps& steps);

}  // namespace karcher
