#pragma once

#include "rcm/point_field.h"

namespace karcher {

/// A field of log vectors and all vertices within a radius of its point, for benchmarks in native
/// code and in WebAssembly.
class TimedField {
 public:
  /// The surface must outlive the field.
  TimedField(Surface& surface, const FieldOptions& options, const SurfacePoint& point,
             double radius);

  int vertexCount() const { return within_.count(); }

  /// Computes the field again and reads it at the vertices within the radius, as a curve does.
  void read();

 private:
  PointField field_;
  SurfacePoint point_;
  Array<int> within_;
};

}  // namespace karcher
