#include <emscripten/bind.h>

#include "bindings/guard.h"
#include "bindings/mesh_handle.h"

// The allocator's own count; Emscripten's <malloc.h> does not declare it.
extern "C" {
struct mallinfo {
  size_t arena, ordblks, smblks, hblks, hblkhd, usmblks, fsmblks, uordblks, fordblks, keepcost;
};
struct mallinfo mallinfo();
}

namespace karcher::bindings {
namespace {

double allocatedBytes() { return static_cast<double>(mallinfo().uordblks); }

}  // namespace

EMSCRIPTEN_BINDINGS(karcher) {
  using emscripten::class_;
  using emscripten::function;
  function("takeFailure", &takeFailure);
  function("allocatedBytes", &allocatedBytes);
  function("meshFromObj", &Guarded<&meshFromObj>::call);
  function("meshFromArrays", &Guarded<&meshFromArrays>::call);
  function("builtInShape", &Guarded<&builtInShape>::call);
  class_<MeshHandle>("Mesh")
      .function("info", &Guarded<&MeshHandle::info>::call)
      .function("positions", &Guarded<&MeshHandle::positions>::call)
      .function("triangles", &Guarded<&MeshHandle::triangles>::call)
      .function("subdivided", &Guarded<&MeshHandle::subdivided>::call)
      .function("checkedPoint", &Guarded<&MeshHandle::checkedPoint>::call)
      .function("vertexPoint", &Guarded<&MeshHandle::vertexPoint>::call)
      .function("position", &Guarded<&MeshHandle::position>::call)
      .function("straightest", &Guarded<&MeshHandle::straightest>::call);
}

}  // namespace karcher::bindings
