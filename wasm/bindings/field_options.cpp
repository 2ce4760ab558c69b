#include "bindings/field_options.h"

#include <string>

#include "mesh/error.h"

namespace karcher::bindings {
namespace {

template <class Value>
struct Named {
  const char* name;
  Value value;
};

constexpr Named<Method> kMethods[] = {{"karcher", Method::kKarcher}, {"paper", Method::kPaper}};
constexpr Named<Solver> kSolvers[] = {
    {"fast", Solver::kFast}, {"exact", Solver::kExact}, {"graph", Solver::kGraph}};
constexpr Named<Star> kStars[] = {{"wide", Star::kWide}, {"ring", Star::kRing}};

template <class Value, size_t count>
Value valueOf(const Named<Value> (&list)[count], const std::string& name) {
  for (const Named<Value>& named : list) {
    if (name == named.name) return named.value;
  }
  throw Error(ErrorCode::kBadArgument, "there is no method, solver or star '" + name + "'");
}

}  // namespace

FieldOptions fieldOptionsFromJs(const emscripten::val& options) {
  FieldOptions result;
  result.method = valueOf(kMethods, options["method"].as<std::string>());
  result.solver = valueOf(kSolvers, options["solver"].as<std::string>());
  result.rings = options["rings"].as<int>();
  result.star = valueOf(kStars, options["star"].as<std::string>());
  checkFieldOptions(result);
  return result;
}

const char* solverName(Solver solver) {
  for (const Named<Solver>& named : kSolvers) {
    if (named.value == solver) return named.name;
  }
  return "";
}

}  // namespace karcher::bindings
