#pragma once

#include <emscripten/val.h>

#include "rcm/field_options.h"

namespace karcher::bindings {

/// Reads {method, solver, rings, star}, with names of the JavaScript API. Throws Error kBadArgument
/// for other names, and what `checkFieldOptions` throws.
FieldOptions fieldOptionsFromJs(const emscripten::val& options);

/// The name of a solver in the JavaScript API.
const char* solverName(Solver solver);

}  // namespace karcher::bindings
