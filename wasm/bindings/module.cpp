#include <emscripten/bind.h>

#include "bindings/curve_handle.h"
#include "bindings/graph_builder_handle.h"
#include "bindings/guard.h"
#include "bindings/mesh_handle.h"
#include "rcm/search_end.h"

// The statistics of the allocator. Emscripten's <malloc.h> does not declare them.
extern "C" {
struct mallinfo {
  size_t arena, ordblks, smblks, hblks, hblkhd, usmblks, fsmblks, uordblks, fordblks, keepcost;
};
struct mallinfo mallinfo();
}

namespace karcher::bindings {
namespace {

double allocatedBytes() { return static_cast<double>(mallinfo().uordblks); }

/// A list with the name of each status, in the order of the statuses' numbers.
val statusNames() {
  val names = val::array();
  for (int i = 0; i <= static_cast<int>(kLastSampleStatus); ++i) {
    names.set(i, std::string(statusName(static_cast<SampleStatus>(i))));
  }
  return names;
}

std::unique_ptr<CurveHandle> makeCurve(MeshHandle& mesh, const val& value) {
  return std::make_unique<CurveHandle>(mesh, value);
}

std::unique_ptr<GraphBuilderHandle> makeGraphBuilder(MeshHandle& mesh, int rings) {
  return std::make_unique<GraphBuilderHandle>(mesh, rings);
}

}  // namespace

EMSCRIPTEN_BINDINGS(karcher) {
  using emscripten::class_;
  using emscripten::function;
  function("takeFailure", &takeFailure);
  function("allocatedBytes", &allocatedBytes);
  function("statusNames", &Guarded<&statusNames>::call);
  function("meshFromObj", &Guarded<&meshFromObj>::call);
  function("meshFromArrays", &Guarded<&meshFromArrays>::call);
  function("meshFromPolygons", &Guarded<&meshFromPolygons>::call);
  function("builtInShape", &Guarded<&builtInShape>::call);
  class_<MeshHandle>("Mesh")
      .function("info", &Guarded<&MeshHandle::info>::call)
      .function("inputVertices", &Guarded<&MeshHandle::inputVertices>::call)
      .function("positions", &Guarded<&MeshHandle::positions>::call)
      .function("triangles", &Guarded<&MeshHandle::triangles>::call)
      .function("kept", &Guarded<&MeshHandle::kept>::call)
      .function("fans", &Guarded<&MeshHandle::fans>::call)
      .function("marks", &Guarded<&MeshHandle::marks>::call)
      .function("subdivided", &Guarded<&MeshHandle::subdivided>::call)
      .function("checkedPoint", &Guarded<&MeshHandle::checkedPoint>::call)
      .function("position", &Guarded<&MeshHandle::position>::call)
      .function("positionsOf", &Guarded<&MeshHandle::positionsOf>::call)
      .function("normal", &Guarded<&MeshHandle::normal>::call)
      .function("frame", &Guarded<&MeshHandle::frame>::call)
      .function("planes", &Guarded<&MeshHandle::planes>::call)
      .function("nearestPoint", &Guarded<&MeshHandle::nearestPoint>::call)
      .function("straightest", &Guarded<&MeshHandle::straightest>::call)
      .function("shortestPath", &Guarded<&MeshHandle::shortestPath>::call)
      .function("logMap", &Guarded<&MeshHandle::logMap>::call)
      .function("logMapOfVertices", &Guarded<&MeshHandle::logMapOfVertices>::call)
      .function("expMap", &Guarded<&MeshHandle::expMap>::call)
      .function("mirror", &Guarded<&MeshHandle::mirror>::call)
      .function("transport", &Guarded<&MeshHandle::transport>::call)
      .function("transportAlong", &Guarded<&MeshHandle::transportAlong>::call)
      .function("pointsAlong", &Guarded<&MeshHandle::pointsAlong>::call)
      .function("carried", &Guarded<&MeshHandle::carried>::call)
      .function("distance", &Guarded<&MeshHandle::distance>::call)
      .function("hasRingGraph", &Guarded<&MeshHandle::hasRingGraph>::call)
      .function("prepareFields", &Guarded<&MeshHandle::prepareFields>::call)
      .function("centerOfMass", &Guarded<&MeshHandle::centerOfMass>::call)
      .function("centersOfMass", &Guarded<&MeshHandle::centersOfMass>::call)
      .function("weightsOf", &Guarded<&MeshHandle::weightsOf>::call)
      .function("centerOfMassOfDistances", &Guarded<&MeshHandle::centerOfMassOfDistances>::call)
      .function("circle", &Guarded<&MeshHandle::circle>::call)
      .function("ellipse", &Guarded<&MeshHandle::ellipse>::call)
      .function("isolines", &Guarded<&MeshHandle::isolines>::call)
      .function("offset", &Guarded<&MeshHandle::offset>::call)
      .function("distanceFromPaths", &Guarded<&MeshHandle::distanceFromPaths>::call)
      .function("regions", &Guarded<&MeshHandle::regions>::call)
      .function("cut", &Guarded<&MeshHandle::cut>::call)
      .function("curve", &Guarded<&makeCurve>::call)
      .function("graphBuilder", &Guarded<&makeGraphBuilder>::call);
  class_<CurveHandle>("Curve")
      .function("set", &Guarded<&CurveHandle::set>::call)
      .function("view", &Guarded<&CurveHandle::view>::call)
      .function("value", &Guarded<&CurveHandle::value>::call)
      .function("legs", &Guarded<&CurveHandle::legs>::call)
      .function("pointCount", &Guarded<&CurveHandle::pointCount>::call)
      .function("edit", &Guarded<&CurveHandle::edit>::call)
      .function("splitAt", &Guarded<&CurveHandle::splitAt>::call)
      .function("joined", &Guarded<&CurveHandle::joined>::call)
      .function("fieldsComputed", &Guarded<&CurveHandle::fieldsComputed>::call)
      .function("deviation", &Guarded<&CurveHandle::deviation>::call)
      .function("pointAt", &Guarded<&CurveHandle::pointAt>::call)
      .function("tangentAt", &Guarded<&CurveHandle::tangentAt>::call)
      .function("nearest", &Guarded<&CurveHandle::nearest>::call)
      .function("lengthAt", &Guarded<&CurveHandle::lengthAt>::call)
      .function("pointAtLength", &Guarded<&CurveHandle::pointAtLength>::call)
      .function("equallySpaced", &Guarded<&CurveHandle::equallySpaced>::call);
  class_<GraphBuilderHandle>("GraphBuilder")
      .function("advance", &Guarded<&GraphBuilderHandle::advance>::call)
      .function("progress", &Guarded<&GraphBuilderHandle::progress>::call);
}

}  // namespace karcher::bindings
