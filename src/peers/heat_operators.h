#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "peers/intrinsic_triangulation.h"
#include "peers/sparse_factor.h"

/// Short-time heat flow of scalars and of tangent vectors on a mesh, by one step of backward Euler,
/// and the Poisson equation. The vector heat method and the affine heat method share these
/// operators.
///
/// N. Sharp, Y. Soliman, K. Crane, "The Vector Heat Method" (2019): cotangent and connection
/// Laplacian (section 5), lumped mass, time t = (mean edge length)^2 (section 7.4).
namespace karcher {

struct HeatOptions {
  double timeFactor = 1;  ///< the factor in the time t = timeFactor * (mean edge length)^2
  bool delaunay = false;  ///< whether to use the intrinsic Delaunay triangulation of the surface
};

/// An edge of the triangulation, with the values that determine its entries in the operators.
struct HeatEdge {
  int tail = 0;
  int head = 0;
  double weight = 0;  ///< half the sum of the cotangents of the angles opposite to the edge
  Complex atTail;     ///< the edge as a vector from its tail, in the frame of the tail
  Complex atHead;     ///< the reversed edge from its head, in the frame of the head
};

class HeatOperators {
 public:
  /// The geometry must outlive the operators. Throws Error kBadArgument if timeFactor is not
  /// positive and finite.
  explicit HeatOperators(const Geometry& geometry, const HeatOptions& options = {});

  const Geometry& geometry() const { return *triangulation_.geometry; }
  const IntrinsicTriangulation& triangulation() const { return triangulation_; }
  int vertexCount() const { return triangulation_.vertexCount(); }
  const Array<HeatEdge>& edges() const { return edges_; }
  double time() const { return time_; }
  /// For each vertex, a third of the area of the faces around it.
  const Array<double>& mass() const { return mass_; }
  /// The lower triangle of the cotangent Laplacian, positive semidefinite.
  Eigen::SparseMatrix<double> laplacian() const { return scalarMatrix(0, 1); }

  /// The half-edges that leave a vertex in the triangulation, one for each corner.
  std::span<const int> halfedgesFrom(int vertex) const;

  /// The factors of Mass + t Laplacian for functions, computed on first use. These and the
  /// following factors throw Error kDegenerateFace if the matrix is singular.
  const SparseFactor<double>& scalarHeat() const;
  /// The factors of Mass + t connection Laplacian, for vectors in the vertices' frames.
  const SparseFactor<Complex>& vectorHeat() const;
  /// The factors of the Laplacian for solutions that are 0 at the first vertex of each component.
  /// Right-hand sides must be 0 there.
  const SparseFactor<double>& poisson() const;
  const Array<int>& heldVertices() const { return heldVertices_; }

 private:
  void collectEdges();
  void sumMass();
  void groupHalfedges();
  void chooseHeldVertices();
  Eigen::SparseMatrix<double> scalarMatrix(double massFactor, double laplacianFactor) const;

  IntrinsicTriangulation triangulation_;
  Array<HeatEdge> edges_;
  Array<double> mass_;
  Array<int> firstHalfedge_;
  Array<int> halfedges_;
  Array<int> heldVertices_;
  double time_ = 0;
  mutable std::optional<SparseFactor<double>> scalarHeat_;
  mutable std::optional<SparseFactor<Complex>> vectorHeat_;
  mutable std::optional<SparseFactor<double>> poisson_;
};

/// The least heat that underflow does not distort. A vertex with less heat is too far away to have
/// a direction.
inline constexpr double kLeastHeat = 1e-290;

inline Vec2 toVec2(const Complex& z) { return {z.real(), z.imag()}; }

/// The unit vector in the direction of a heat vector; zero where the heat has underflowed.
inline Vec2 heatDirection(const Complex& heat) {
  // Squares of the heat would underflow long before the heat itself.
  const double largest = std::max(std::abs(heat.real()), std::abs(heat.imag()));
  if (largest < kLeastHeat) return Vec2::Zero();
  const Vec2 scaled = toVec2(heat) * (1 / largest);
  return scaled * (1 / scaled.norm());
}

}  // namespace karcher
