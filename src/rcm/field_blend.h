#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "intrinsic/straightest.h"
#include "mesh/rounding.h"
#include "mesh/sparse_index.h"
#include "rcm/cells.h"
#include "rcm/control_field.h"

/// The weighted sum of control points' fields: grad K for the energy K(p) = sum_i w_i d(p, p_i)^2
/// (Mancinelli, Puppo, Eq. 1). The sum is linear in each cell. A cell is a face. If a field has
/// values at the midpoints of edges, the midpoints divide each face into four cells.
///
/// The frames of vertices, whose angles are scaled, turn a path's direction against the plane of a
/// face. So in a face with a strongly turned frame (hasTurnedFrame) a field of paths is exact
/// instead, if all corners of the face see the control point at one place in this plane, as on a
/// flat side of a solid.
namespace karcher {

/// Whether the frame of a corner of a face, whose angles are scaled to sum to 2 pi, turns paths in
/// the half plane before the corner by more than .2 radians, as at a corner of a solid.
inline bool hasTurnedFrame(const Geometry& geometry, int face) {
  constexpr double kMostTurn = 0.2;
  for (int k = 0; k < 3; ++k) {
    const double scale = geometry.angleScale[geometry.mesh->corner(face, k)];
    if (kPi / 2 * std::abs(1 - 1 / scale) > kMostTurn) return true;
  }
  return false;
}

/// Weights, one for each field. They sum to 1 up to kChainRounding.
using Weights = std::span<const double>;

/// A vector field that is linear in one triangle, given by its values at the corners in the
/// triangle's frame.
struct TriangleField {
  Vec2 corner[3];

  Vec2 at(const Vec3& bary) const {
    return bary[0] * corner[0] + bary[1] * corner[1] + bary[2] * corner[2];
  }

  /// The field's zero as barycentric weights that are not yet divided by their sum. The sum is
  /// positive if the determinant of the Jacobian is positive.
  Vec3 zeroDirection() const {
    return {cross(corner[1], corner[2]), cross(corner[2], corner[0]), cross(corner[0], corner[1])};
  }
};

/// The symmetric part of the Jacobian of a triangle's field: the Hessian of K.
struct Hessian {
  double xx = 0, xy = 0, yy = 0;

  bool positiveDefinite() const { return xx > 0 && xx * yy > xy * xy; }
};

Hessian hessian(const Geometry& geometry, int face, const TriangleField& field);

/// A field's values at the ends of an edge, or of half an edge. They are in the edge's frame, whose
/// x axis is the edge's direction.
struct EdgeValues {
  Vec2 tail = Vec2::Zero();
  Vec2 head = Vec2::Zero();
};

/// Fields along an edge or half an edge, linear between their values at the ends.
struct EdgeField {
  Array<EdgeValues> fields;

  EdgeValues at(Weights weights) const {
    EdgeValues sum;
    for (int i = 0; i < fields.count(); ++i) add(weights.data()[i], fields[i], sum);
    return sum;
  }

  static void add(double weight, const EdgeValues& values, EdgeValues& sum) {
    sum.tail += weight * values.tail;
    sum.head += weight * values.head;
  }
};

/// The zero of a cell's blended field, as barycentric weights, with the field in the cell's frame.
struct CellZero {
  TriangleField field;
  Vec3 bary;
  /// The product of two determinants: of the field's Jacobian, and of the map from weights to the
  /// cell.
  double determinant;
  /// A bound on the difference of an angle in two adjacent faces: the angle between the values at
  /// the ends of their common edge. The angle differs since the frames of vertices rescale corner
  /// angles. The bound uses that the corner angles at both ends sum to less than pi.
  double holonomy;

  /// The depth of the zero inside the cell: its smallest weight.
  double depth() const { return std::min(bary[0], std::min(bary[1], bary[2])); }
};

class FieldBlend {
 public:
  /// The geometry and the fields must outlive the blend; there must be at least one field.
  FieldBlend(const Geometry& geometry, Array<ControlField*> fields);

  /// Replaces the fields and keeps the memory.
  void setFields(const Array<ControlField*>& fields);

  const Geometry& geometry() const { return geometry_; }
  const Cells& cells() const { return cells_; }

  /// Scratch memory of a search: the geodesic along which it takes a step.
  StraightestPath& step() { return step_; }

  /// The weighted sum of the fields in a cell, in its frame.
  TriangleField blend(int cell, Weights weights);

  /// The weighted sum of the fields at a point, in the frame of its face.
  Vec2 at(const SurfacePoint& point, Weights weights);

  /// Finds the zero of `blend`. Returns false if its Hessian is not positive definite. At most
  /// samples a search needs only this single call.
  [[gnu::always_inline]] bool findZero(int cell, Weights weights, CellZero& zero);

  /// The weighted sum of the fields at a vertex, in its frame.
  Vec2 atVertex(int vertex, Weights weights);

  /// K at a point: the blend of the squared distances at the corners, each extrapolated to the
  /// point by its own gradient. It is exact where squared distances are quadratic.
  double energy(const SurfacePoint& point, Weights weights);

  /// The parameter s in [0, 1] along half-edge h of a cell at which the field's component along the
  /// edge vanishes. The function uses the field in the edge's own frame. The cells on both sides
  /// share this frame, so that both give the same point.
  double zeroAlongEdge(int h, Weights weights);

  /// Writes to `result` the fields along half-edge h of a face. If faces are cut, it writes the
  /// fields along one half: `half` is 0 for the half at the tail, 1 for the half at the head.
  void alongEdge(int h, int half, EdgeField& result);
  /// The weighted sum of the fields that `alongEdge` writes, in one pass.
  EdgeValues blendAlongEdge(int h, int half, Weights weights);

  /// The rate of change of a blend along the axes of its cell.
  struct CellJacobian {
    Vec2 alongX;
    Vec2 alongY;
  };
  CellJacobian jacobian(int cell, const TriangleField& field) const;

  /// The unit direction of the cell's first edge in the frame of its face. A rotation by this
  /// direction turns vectors in the cell's frame into vectors in the face's frame.
  Vec2 axisInFace(int cell) const;

 private:
  /// The shape of a cell. `findZero` reads it together with the fields' vectors.
  struct CellShape {
    double edge = 0;  ///< the length of the cell's first half-edge
    double apexX = 0;
    double apexY = 0;
    double holonomy = 0;  ///< see CellZero
  };

  /// The slot of a cell. The first use fills it.
  int slotOf(int cell) { return cell == lastCell_ ? lastSlot_ : findSlot(cell); }
  int findSlot(int cell);
  void fillSlot(int slot, int cell);
  CellShape shapeOf(int cell) const;
  /// The values of field i along half-edge h of a face, or along one half.
  EdgeValues valuesAlongEdge(int i, int h, int half);
  void fillCut(double* out, int cell);
  /// The transported vectors of all fields in a slot's cell: six numbers for each field, x and y at
  /// each corner.
  const double* vectorsOf(int slot) const {
    return vectors_.data() + static_cast<ptrdiff_t>(slot) * width_;
  }
  const Geometry& geometry_;
  Array<ControlField*> fields_;
  Cells cells_;
  StraightestPath step_;
  int width_;              ///< the number of values of a slot in vectors_
  Array<double> vectors_;  ///< the vectors by slot, with memory for some more slots
  Array<char> straight_;   ///< by slot: for each field whether it is straight in the cell
  Array<CellShape> shapes_;
  SparseIndex slots_;  ///< the slot of each cell in use
  int lastCell_ = -1;
  int lastSlot_ = 0;
};

// The definition is here so that the compiler inlines it into the searches.
inline bool FieldBlend::findZero(int cell, Weights weights, CellZero& zero) {
  const int slot = slotOf(cell);
  const double* v = vectorsOf(slot);
  // The six components of a field lie side by side, so that the sums vectorise.
  double sum[6] = {};
  for (const double w : weights) {
    for (int c = 0; c < 6; ++c) sum[c] += w * v[c];
    v += 6;
  }
  const double x0 = sum[0], y0 = sum[1], x1 = sum[2], y1 = sum[3], x2 = sum[4], y2 = sum[5];
  // This is hessian(...).positiveDefinite() without its divisions.
  const CellShape& shape = shapes_[slot];
  const double xx = shape.apexY * (x1 - x0);
  const double yy = shape.edge * (y2 - y0) - shape.apexX * (y1 - y0);
  const double xy =
      (shape.apexY * (y1 - y0) + shape.edge * (x2 - x0) - shape.apexX * (x1 - x0)) / 2;
  if (!(xx > 0 && xx * yy > xy * xy)) return false;
  const double b0 = x1 * y2 - y1 * x2;
  const double b1 = x2 * y0 - y2 * x0;
  const double b2 = x0 * y1 - y0 * x1;
  zero.determinant = b0 + b1 + b2;
  zero.holonomy = shape.holonomy;
  const double scale = 1 / zero.determinant;
  zero.bary[0] = b0 * scale;
  zero.bary[1] = b1 * scale;
  zero.bary[2] = b2 * scale;
  zero.field.corner[0] = Vec2(x0, y0);
  zero.field.corner[1] = Vec2(x1, y1);
  zero.field.corner[2] = Vec2(x2, y2);
  return true;
}

}  // namespace karcher
