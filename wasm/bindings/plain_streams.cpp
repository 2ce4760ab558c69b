#include <clocale>
#include <cstdlib>
#include <ctime>

/// Replacements for functions of dates and locales, which the streams of tinyobjloader link but
/// never call here. Emscripten would add 2 KB of JavaScript for them to the module.
extern "C" {

size_t strftime_l(char* /*text*/, size_t /*size*/, const char* /*format*/,
                  const struct tm* /*time*/, locale_t /*locale*/) {
  return 0;
}

char* getenv(const char* /*name*/) { return nullptr; }
}
