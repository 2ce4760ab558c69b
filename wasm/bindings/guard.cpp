#include "bindings/guard.h"

#include <optional>
#include <stdexcept>

namespace karcher::bindings {
namespace {

struct Failure {
  std::string code;
  std::string sentence;
};

std::optional<Failure> keptFailure;

}  // namespace

void keepFailure(const char* code, const char* sentence) { keptFailure = {code, sentence}; }

emscripten::val takeFailure() {
  if (!keptFailure) return emscripten::val::undefined();
  emscripten::val result = emscripten::val::object();
  result.set("code", keptFailure->code);
  result.set("message", keptFailure->sentence);
  keptFailure.reset();
  return result;
}

void keepCurrentException() {
  try {
    throw;
  } catch (const Error& error) {
    keepFailure(errorCodeName(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    keepFailure("outOfMemory", "the engine's memory is used up");
  } catch (const std::length_error&) {
    keepFailure("outOfMemory", "an array is longer than the engine's memory");
  } catch (const std::exception& error) {
    keepFailure("internal", error.what());
  } catch (...) {
    keepFailure("internal", "the engine failed for an unknown reason");
  }
}

}  // namespace karcher::bindings
