#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "mesh/types.h"

namespace karcher {

/// What a control point p leaves at a vertex v.
struct FieldValue {
  Vec2 gradient = Vec2::Zero();  ///< of d(., p)^2, in the frame of v: -2 log_v(p)
  double squaredDistance = 0;    ///< d(v, p)^2
};

/// The field of one control point: a value at each vertex that is asked for, kept once it is known.
/// Values live in pages that are made as they are first touched, so that a field takes memory and
/// time for its neighbourhood and not for the mesh.
class ControlField {
 public:
  /// Computes the value at a vertex. It must depend on the vertex alone, not on earlier calls.
  using Evaluate = std::function<FieldValue(int vertex)>;

  explicit ControlField(int vertexCount)
      : pages_(static_cast<size_t>(vertexCount / kPageSize) + 1) {}

  /// Forgets all values; from now on `evaluate` computes them. Costs what was touched.
  void reset(Evaluate evaluate);

  const FieldValue& at(int vertex) {
    const std::unique_ptr<Page>& page = pages_[vertex / kPageSize];
    const int slot = vertex % kPageSize;
    if (page && page->known[slot]) return page->values[slot];
    return compute(vertex);
  }

  /// How many vertices were asked for since the last reset.
  int knownCount() const { return knownCount_; }

 private:
  static constexpr int kPageSize = 64;
  struct Page {
    FieldValue values[kPageSize];
    bool known[kPageSize] = {};
  };

  const FieldValue& compute(int vertex);

  Evaluate evaluate_;
  Array<std::unique_ptr<Page>> pages_;
  Array<int> touchedPages_;
  int knownCount_ = 0;
};

}  // namespace karcher
