#include <emscripten/bind.h>

#include "bindings/guard.h"
#include "peers/bindings/compared_curve_handle.h"

namespace karcher::bindings {

/// What this module has beyond those of the engine's own bindings, which are linked with it: meshes
/// of the one class serve both.
EMSCRIPTEN_BINDINGS(karcher_peers) {
  using emscripten::class_;
  using emscripten::function;
  function("prepareMethod", &Guarded<&prepareMethod>::call);
  function("comparedCurve", &Guarded<&comparedCurve>::call);
  function("basisWeights", &Guarded<&basisWeights>::call);
  class_<PreparedMethodHandle>("PreparedMethod");
  class_<ComparedCurveHandle>("ComparedCurve")
      .function("movePoint", &Guarded<&ComparedCurveHandle::movePoint>::call)
      .function("startAt", &Guarded<&ComparedCurveHandle::startAt>::call)
      .function("advance", &Guarded<&ComparedCurveHandle::advance>::call)
      .function("samplesLeft", &Guarded<&ComparedCurveHandle::samplesLeft>::call)
      .function("samples", &Guarded<&ComparedCurveHandle::samples>::call)
      .function("path", &Guarded<&ComparedCurveHandle::path>::call);
}

}  // namespace karcher::bindings
