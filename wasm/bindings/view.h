#pragma once

#include "bindings/mesh_handle.h"
#include "curves/trace/joined_path.h"
#include "intrinsic/surface_path.h"

namespace karcher::bindings {

/// A traced curve, segment by segment. `paths` is empty if paths are not requested.
struct TracedLine {
  bool closed = false;
  int levels = 0;
  Array<const Array<CurveSample>*> samples;
  Array<const Array<Bridge>*> bridges;
  Array<const JoinedPath*> paths;
  /// The legs of the control polygon.
  Array<const SurfacePath*> legs;
  Array<double> knots;
  /// The durations of the last edit's stages, in milliseconds.
  Array<double> times;
};

struct ViewOptions {
  bool inDouble = false;    ///< whether the path's positions are 64-bit numbers
  bool withPoints = false;  ///< whether to include the path's faces and weights
};

/// The options from {inDouble, withPoints}.
ViewOptions viewOptionsFromJs(const val& options);

/// The whole view as one Uint8Array, which wasm/view.ts reads: first the 64-bit numbers, then the
/// 32-bit numbers, then the 8-bit numbers.
val viewToJs(const MeshHandle& mesh, const TracedLine& line, const ViewOptions& options);

}  // namespace karcher::bindings
