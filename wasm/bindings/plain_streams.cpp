#include <clocale>
#include <cstdlib>
#include <ctime>

/// Streams, by which tinyobjloader reads OBJ, can print dates and ask for the user's language,
/// which they never do here: Emscripten would add 2 KB of JavaScript for that to the module.
extern "C" {

size_t strftime_l(char* /*text*/, size_t /*size*/, const char* /*format*/,
                  const struct tm* /*time*/, locale_t /*locale*/) {
  return 0;
}

char* getenv(const char* /*name*/) { return nullptr; }
}
