#pragma once

#include <cmath>

namespace karcher {

/// The place between `from` and `to` at which a function changes its sign, up to `rounding`. The
/// search uses regula falsi, and halves the value at an end that stays twice in a row (the Illinois
/// rule). It becomes bisection if a value is not finite, or after many steps. If the values at both
/// ends have the same sign, the first counts as negative.
template <class Function>
double signChange(double from, double to, double atFrom, double atTo, double rounding,
                  const Function& valueAt) {
  if (atFrom == 0) return from;
  if (atTo == 0) return to;
  // The second half of these steps is bisection only: enough steps for the precision of doubles.
  constexpr int kMostSteps = 100;
  const bool falls = atFrom > 0 && atTo < 0;
  double at = from;
  double* stayed = nullptr;  // the value of the end that stayed in the last step
  for (int step = 0; step < kMostSteps && to - from > rounding; ++step) {
    at = (from + to) / 2;
    if (std::isfinite(atFrom) && std::isfinite(atTo) && (atFrom < 0) != (atTo < 0) &&
        step < kMostSteps / 2) {
      const double secant = from - atFrom * (to - from) / (atTo - atFrom);
      if (secant > from && secant < to) at = secant;
    }
    const double value = valueAt(at);
    if (value == 0) break;
    const bool isBefore = (value < 0) != falls;
    (isBefore ? from : to) = at;
    (isBefore ? atFrom : atTo) = value;
    double* const stays = isBefore ? &atTo : &atFrom;
    if (stays == stayed) *stays /= 2;
    stayed = stays;
  }
  return at;
}

}  // namespace karcher
