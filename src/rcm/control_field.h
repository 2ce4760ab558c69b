#pragma once

#include <functional>
#include <unordered_map>
#include <utility>

#include "intrinsic/geometry.h"
#include "mesh/sparse_index.h"

namespace karcher {

/// The value of a control point p's field at a vertex v.
struct FieldValue {
  Vec2 gradient = Vec2::Zero();  ///< the gradient of d(., p)^2 in the frame of v: -2 log_v(p)
  double squaredDistance = 0;    ///< d(v, p)^2
};

/// The field of one control point. The field computes the value at a vertex on first use and keeps
/// the value. So its memory and time depend on the part of the mesh where callers read the field.
class ControlField {
 public:
  /// A function that computes the value at a vertex. The value must depend on the vertex alone, not
  /// on earlier calls.
  using Evaluate = std::function<FieldValue(int vertex)>;

  /// A function that computes the midpoint correction of a half-edge: the field at its midpoint
  /// minus the mean of the values at its ends. The result is in the half-edge's frame, whose x axis
  /// is the half-edge's direction.
  using EvaluateMidpoint = std::function<Vec2(int halfedge)>;

  /// Removes all values, in time linear in their number; `evaluate` computes new ones. With
  /// `evaluateMidpoint` the field also has values at the midpoints of edges. `isOfPaths` says that
  /// each value is that of a path to the control point, not an estimate from several vertices.
  void reset(Evaluate evaluate, EvaluateMidpoint evaluateMidpoint = {}, bool isOfPaths = false) {
    isOfPaths_ = isOfPaths;
    numberOf_.clear();
    values_.clear();
    corrections_.clear();
    evaluate_ = std::move(evaluate);
    evaluateMidpoint_ = std::move(evaluateMidpoint);
  }

  /// The value at a vertex. The reference is valid until the next call.
  const FieldValue& at(int vertex) {
    const int number = numberOf_.find(vertex);
    if (number >= 0) return values_[number];
    // The evaluation and the memory's growth may throw, so the entry is added after them.
    const FieldValue value = evaluate_(vertex);
    const int added = numberOf_.count();
    values_.resize(static_cast<size_t>(added) + 1);
    numberOf_.add(vertex);
    return values_[added] = value;
  }

  bool isOfPaths() const { return isOfPaths_; }
  bool hasMidpoints() const { return static_cast<bool>(evaluateMidpoint_); }

  /// The field at the midpoint of a half-edge minus the mean of the values at its ends. For each
  /// edge, callers must always use the same half-edge.
  const Vec2& midpointCorrection(int halfedge) {
    const auto [entry, isNew] = corrections_.try_emplace(halfedge);
    if (isNew) {
      try {
        entry->second = evaluateMidpoint_(halfedge);
      } catch (...) {
        corrections_.erase(entry);
        throw;
      }
    }
    return entry->second;
  }

  /// Computes `midpointCorrection` without keeping it, for callers that read each value only once.
  Vec2 midpointCorrectionUnkept(int halfedge) const { return evaluateMidpoint_(halfedge); }

 private:
  /// Memory that suffices for the values of most near fields.
  static Array<FieldValue> roomForNearField() {
    Array<FieldValue> values;
    values.reserve(64);
    return values;
  }

  Evaluate evaluate_;
  EvaluateMidpoint evaluateMidpoint_;
  bool isOfPaths_ = false;
  SparseIndex numberOf_;
  Array<FieldValue> values_ = roomForNearField();
  std::unordered_map<int, Vec2> corrections_;
};

}  // namespace karcher
