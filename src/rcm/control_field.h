#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <unordered_map>
#include <utility>

#include "distance/paged_array.h"

namespace karcher {

/// The value of a control point p's field at a vertex v.
struct FieldValue {
  Vec2 gradient = Vec2::Zero();  ///< of d(., p)^2, in the frame of v: -2 log_v(p)
  double squaredDistance = 0;    ///< d(v, p)^2
};

/// The field of one control point. The value at a vertex is computed when it is first asked for,
/// and kept: a field takes memory and time for its neighbourhood, not for the mesh.
class ControlField {
 public:
  /// Computes the value at a vertex. It must depend on the vertex alone, not on earlier calls.
  using Evaluate = std::function<FieldValue(int vertex)>;

  /// Computes what a field has at the midpoint of a half-edge beyond the mean of its ends, in the
  /// half-edge's frame: its direction is the x axis.
  using EvaluateMidpoint = std::function<Vec2(int halfedge)>;

  /// The pool is where its memory comes from, which other fields may share.
  explicit ControlField(int vertexCount, std::shared_ptr<PagePool> pages = newPagePool())
      : entries_(vertexCount, std::move(pages)) {}

  /// Forgets all values; from now on `evaluate` computes them. Costs what was touched.
  /// With `evaluateMidpoint` the field has values at the midpoints of edges as well.
  void reset(Evaluate evaluate, EvaluateMidpoint evaluateMidpoint = {}) {
    entries_.clear();
    corrections_.clear();
    evaluate_ = std::move(evaluate);
    evaluateMidpoint_ = std::move(evaluateMidpoint);
  }

  const FieldValue& at(int vertex) {
    FieldValue& value = entries_.touch(vertex).value;
    if (std::isnan(value.squaredDistance)) value = evaluate_(vertex);
    return value;
  }

  bool hasMidpoints() const { return static_cast<bool>(evaluateMidpoint_); }

  /// What the field has at the midpoint of a half-edge beyond the mean of its ends. A caller asks
  /// for the same half-edge of an edge each time.
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

  /// The same without keeping it, for a caller who reads each once.
  Vec2 midpointCorrectionUnkept(int halfedge) const { return evaluateMidpoint_(halfedge); }

 private:
  /// A value that is not known yet is not a number, which takes no memory of its own.
  struct Entry {
    FieldValue value{Vec2::Zero(), kUnknown};
  };
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  Evaluate evaluate_;
  EvaluateMidpoint evaluateMidpoint_;
  PagedArray<Entry, 4> entries_;
  std::unordered_map<int, Vec2> corrections_;
};

}  // namespace karcher
