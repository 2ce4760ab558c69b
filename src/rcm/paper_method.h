#pragma once

#include <array>

#include "rcm/center_of_mass.h"
#include "rcm/surface.h"

/// The method of C. Mancinelli, E. Puppo, "Computing the Riemannian Center of Mass on Meshes"
/// (`method: 'paper'`): fields are gradients of squared distances, which the exact solver finds, or
/// the k-ring graph (ring_graph.h); Newton's method searches them.
namespace karcher {

/// The field of squared distances, one a vertex (Eq. 3): their gradient over either star
/// (gradient_operator.h).
ControlField fieldOfSquares(Surface& surface, Star star, Array<double> squaredDistances);

/// A field of a caller's own distances, one a vertex. Throws Error kBadArgument (not one a vertex,
/// or beyond 1e60) or kNotFinite (NaN or negative).
ControlField fieldFromDistances(Surface& surface, const Array<double>& distances);

/// Newton's method along geodesics (Algorithm 1) from `start`. A zero that two neighbouring faces
/// each place in the other is taken on their edge (FieldBlend::zeroAlongEdge).
CenterOfMass newtonCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start);

/// What a search did, for studies of what the paper says of it.
struct NewtonSteps {
  int traced = 0;       ///< geodesics along steps of Newton's method
  int shortened = 0;    ///< of these, taken to a joint before their end
  int needed = 0;       ///< of those, whose end has no smaller gradient than their start
  int stuck = 0;        ///< on which no joint has a smaller gradient than their start
  bool inside = false;  ///< whether a zero inside a triangle ended the search
  /// The gradients' lengths where the last three iterations began, the last one first; 0 for none.
  std::array<double, 3> gradients{};
};

/// The same search, and what it did.
CenterOfMass newtonCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                          NewtonSteps& steps);

}  // namespace karcher
