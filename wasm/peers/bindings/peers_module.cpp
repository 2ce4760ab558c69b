#include <emscripten/bind.h>

#include "bindings/guard.h"
#include "peers/bindings/benchmark_handle.h"
#include "peers/bindings/compared_curve_handle.h"
#include "peers/bindings/newton_steps.h"

namespace karcher::bindings {

/// The bindings of the peers. The linker adds the engine's own bindings, so that both share one
/// class of meshes.
EMSCRIPTEN_BINDINGS(karcher_peers) {
  using emscripten::class_;
  using emscripten::function;
  function("prepareMethod", &Guarded<&prepareMethod>::call);
  function("comparedCurve", &Guarded<&comparedCurve>::call);
  function("basisWeights", &Guarded<&basisWeights>::call);
  function("newtonSteps", &Guarded<&newtonSteps>::call);
  function("benchmark", &Guarded<&makeBenchmark>::call);
  class_<PreparedMethodHandle>("PreparedMethod");
  class_<ComparedCurveHandle>("ComparedCurve")
      .function("movePoint", &Guarded<&ComparedCurveHandle::movePoint>::call)
      .function("startAt", &Guarded<&ComparedCurveHandle::startAt>::call)
      .function("advance", &Guarded<&ComparedCurveHandle::advance>::call)
      .function("samplesLeft", &Guarded<&ComparedCurveHandle::samplesLeft>::call)
      .function("lostByOwnRule", &Guarded<&ComparedCurveHandle::lostByOwnRule>::call)
      .function("logMaps", &Guarded<&ComparedCurveHandle::logMaps>::call)
      .function("samples", &Guarded<&ComparedCurveHandle::samples>::call)
      .function("joined", &Guarded<&ComparedCurveHandle::joined>::call);
  class_<BenchmarkHandle>("Benchmark")
      .function("prepare", &Guarded<&BenchmarkHandle::prepare>::call)
      .function("edgeDijkstra", &Guarded<&BenchmarkHandle::edgeDijkstra>::call)
      .function("ringGraph", &Guarded<&BenchmarkHandle::ringGraph>::call)
      .function("gradientOperator", &Guarded<&BenchmarkHandle::gradientOperator>::call)
      .function("field", &Guarded<&BenchmarkHandle::field>::call)
      .function("chooseField", &Guarded<&BenchmarkHandle::chooseField>::call)
      .function("readField", &Guarded<&BenchmarkHandle::readField>::call)
      .function("gradient", &Guarded<&BenchmarkHandle::gradient>::call);
}

}  // namespace karcher::bindings
