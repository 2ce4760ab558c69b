#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "distance/paged_array.h"

namespace karcher {

/// What a control point p leaves at a vertex v.
struct FieldValue {
  Vec2 gradient = Vec2::Zero();  ///< of d(., p)^2, in the frame of v: -2 log_v(p)
  double squaredDistance = 0;    ///< d(v, p)^2
};

/// The field of one control point: a value at each vertex that is asked for, kept once it is known.
/// A field takes memory and time for its neighbourhood and not for the mesh.
class ControlField {
 public:
  /// Computes the value at a vertex. It must depend on the vertex alone, not on earlier calls.
  using Evaluate = std::function<FieldValue(int vertex)>;

  explicit ControlField(int vertexCount) : entries_(vertexCount) {}

  /// Forgets all values; from now on `evaluate` computes them. Costs what was touched.
  void reset(Evaluate evaluate) {
    entries_.clear();
    knownCount_ = 0;
    evaluate_ = std::move(evaluate);
  }

  const FieldValue& at(int vertex) {
    FieldValue& value = entries_.touch(vertex).value;
    if (std::isnan(value.squaredDistance)) {
      value = evaluate_(vertex);
      ++knownCount_;
    }
    return value;
  }

  /// How many vertices were asked for since the last reset.
  int knownCount() const { return knownCount_; }

 private:
  /// Not a number where the value is not known yet: as little memory as may be.
  struct Entry {
    FieldValue value{Vec2::Zero(), kUnknown};
  };
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  Evaluate evaluate_;
  PagedArray<Entry, 6> entries_;
  int knownCount_ = 0;
};

}  // namespace karcher
