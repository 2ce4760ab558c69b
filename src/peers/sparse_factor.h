#pragma once

#include <Eigen/SparseCholesky>
#include <complex>
#include <string>

#include "mesh/error.h"
#include "mesh/types.h"

/// A sparse Hermitian matrix with one factorisation for many solves. The factor L D L* is Eigen's
/// (simplicial, approximate minimum degree ordering, no pivoting). The triangular solves here
/// handle several right-hand sides in one pass over L. This pass takes most of the time, since L
/// does not fit into the cache.
namespace karcher {

/// Right-hand sides, or solutions; the values of one row are adjacent.
template <class Scalar, int kColumns>
using Columns = Eigen::Matrix<Scalar, Eigen::Dynamic, kColumns,
                              kColumns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

template <class Scalar>
class SparseFactor {
 public:
  using Matrix = Eigen::SparseMatrix<Scalar>;

  /// Reads the lower triangle. `name` names the matrix in errors. Throws Error kDegenerateFace if a
  /// pivot vanishes.
  SparseFactor(const Matrix& matrix, const std::string& name) : factor_(matrix) {
    if (factor_.info() != Eigen::Success) {
      throw Error(ErrorCode::kDegenerateFace,
                  name + " cannot be factorised: the mesh has faces with almost no area");
    }
    inversePivots_.resize(static_cast<size_t>(matrix.rows()));
    for (int i = 0; i < inversePivots_.count(); ++i) {
      inversePivots_[i] = 1 / std::real(factor_.vectorD()[i]);
    }
  }

  int rows() const { return inversePivots_.count(); }

  /// The solutions of columns of right-hand sides, as columns.
  template <int kColumns>
  Columns<Scalar, kColumns> solve(const Columns<Scalar, kColumns>& right) const {
    Columns<Scalar, kColumns> x = factor_.permutationP() * right;
    solveInOrder(x);
    return factor_.permutationPinv() * x;
  }

  /// Solves L D L* y = x by the triangular solves alone, with rows in the order of the factor.
  /// Replaces x by y.
  template <int kColumns>
  void solveInOrder(Columns<Scalar, kColumns>& x) const {
    const int* const first = lower().outerIndexPtr();
    const int* const row = lower().innerIndexPtr();
    const Scalar* const value = lower().valuePtr();
    for (int j = 0; j < rows(); ++j) {
      const Row<kColumns> pivot = rowOf(x, j);
      if (pivot.isZero(0)) continue;  // a few sources affect few columns of L
      for (int k = first[j]; k < first[j + 1]; ++k) subtractProduct(x, row[k], value[k], pivot);
    }
    for (int j = rows() - 1; j >= 0; --j) {
      Row<kColumns> sum = rowOf(x, j) * inversePivots_[j];
      for (int k = first[j]; k < first[j + 1]; ++k) {
        subtractConjugateProduct(sum, value[k], rowOf(x, row[k]));
      }
      for (int c = 0; c < kColumns; ++c) x(j, c) = sum[c];
    }
  }

 private:
  template <int kColumns>
  using Row = Eigen::Array<Scalar, kColumns, 1>;

  const Matrix& lower() const { return factor_.matrixL().nestedExpression(); }

  template <int kColumns>
  static Row<kColumns> rowOf(const Columns<Scalar, kColumns>& x, int i) {
    return Eigen::Map<const Row<kColumns>>(x.data() + static_cast<ptrdiff_t>(i) * kColumns);
  }

  // Complex products are written out, since the language's own products check for infinities, which
  // takes time.
  template <int kColumns>
  static void subtractProduct(Columns<Scalar, kColumns>& x, int i, const Scalar& a,
                              const Row<kColumns>& b) {
    Scalar* const target = x.data() + static_cast<ptrdiff_t>(i) * kColumns;
    for (int c = 0; c < kColumns; ++c) {
      if constexpr (Eigen::NumTraits<Scalar>::IsComplex) {
        target[c] = {target[c].real() - (a.real() * b[c].real() - a.imag() * b[c].imag()),
                     target[c].imag() - (a.real() * b[c].imag() + a.imag() * b[c].real())};
      } else {
        target[c] -= a * b[c];
      }
    }
  }

  template <int kColumns>
  static void subtractConjugateProduct(Row<kColumns>& sum, const Scalar& a,
                                       const Row<kColumns>& b) {
    for (int c = 0; c < kColumns; ++c) {
      if constexpr (Eigen::NumTraits<Scalar>::IsComplex) {
        sum[c] = {sum[c].real() - (a.real() * b[c].real() + a.imag() * b[c].imag()),
                  sum[c].imag() - (a.real() * b[c].imag() - a.imag() * b[c].real())};
      } else {
        sum[c] -= a * b[c];
      }
    }
  }

  Eigen::SimplicialLDLT<Matrix> factor_;
  Array<double> inversePivots_;
};

}  // namespace karcher
