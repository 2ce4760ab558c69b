#pragma once

#include <emscripten/val.h>

#include <exception>
#include <new>
#include <string>
#include <type_traits>

#include "mesh/error.h"

/// How failures reach JavaScript. An exception that leaves the WebAssembly module loses its
/// sentence. So each binding runs under a guard, which keeps the failure's code and sentence and
/// returns an empty result. The TypeScript facade takes the failure after each call.
namespace karcher::bindings {

/// Keeps a failure until `takeFailure`.
void keepFailure(const char* code, const char* sentence);

/// Returns the kept failure as {code, message} and forgets it. Returns undefined without a failure.
emscripten::val takeFailure();

/// Keeps the current exception.
void keepCurrentException();

/// Returns the result of `work`. If `work` failed, returns undefined or an empty value.
template <class Work>
auto guarded(const Work& work) -> decltype(work()) {
  using Result = decltype(work());
  try {
    return work();
  } catch (...) {
    keepCurrentException();
  }
  if constexpr (std::is_same_v<Result, emscripten::val>) {
    return emscripten::val::undefined();
  } else {
    return Result();
  }
}

/// Runs the function or member function `Work` under the guard. Bindings use Guarded<&Work>::call.
template <auto Work>
struct Guarded;

template <class Result, class... Arguments, Result (*Work)(Arguments...)>
struct Guarded<Work> {
  static Result call(Arguments... arguments) {
    return guarded([&] { return Work(arguments...); });
  }
};

template <class Owner, class Result, class... Arguments, Result (Owner::*Work)(Arguments...)>
struct Guarded<Work> {
  static Result call(Owner& owner, Arguments... arguments) {
    return guarded([&] { return (owner.*Work)(arguments...); });
  }
};

template <class Owner, class Result, class... Arguments, Result (Owner::*Work)(Arguments...) const>
struct Guarded<Work> {
  static Result call(const Owner& owner, Arguments... arguments) {
    return guarded([&] { return (owner.*Work)(arguments...); });
  }
};

}  // namespace karcher::bindings
