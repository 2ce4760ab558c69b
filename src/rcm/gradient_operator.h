#pragma once

#include <Eigen/SparseCore>

#include "intrinsic/geometry.h"

/// The gradient of a function given at the vertices: C. Mancinelli, E. Puppo, "Computing the
/// Riemannian Center of Mass on Meshes", Eq. 3.
namespace karcher {

/// A gradient operator. Rows 2 v and 2 v + 1 hold the two components at vertex v, in its frame;
/// each column belongs to a vertex.
using GradientOperator = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The faces whose gradients the operator averages at a vertex.
enum class Star {
  /// The faces around the vertex, and the faces across the outer edges of its ring, as in the
  /// program of the paper's authors. With this star our curves equal the curves of that program to
  /// 1e-4 of an edge; with kRing they differ by 0.03 to 0.11 edges (tests/bench/authors_study).
  kWide,
  kRing,  ///< the faces around the vertex: Eq. 3 as the paper prints it
};

/// The operator that gives, at each vertex, the area-weighted mean of the constant gradients in the
/// faces of its star. It turns each gradient into the vertex's frame. For a face beyond the ring,
/// it first turns the gradient into the adjacent face of the ring. Apply the operator to squared
/// distances, which are smooth at the source.
GradientOperator buildGradientOperator(const Geometry& geometry, Star star = Star::kWide);

/// The gradient at each vertex, in its frame. `values` has one entry for each vertex.
Array<Vec2> applyGradient(const GradientOperator& gradient, const Array<double>& values);

}  // namespace karcher
