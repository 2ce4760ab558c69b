#pragma once

#include <string>

#include "mesh/types.h"

namespace karcher {

struct Series {
  std::string name;
  Array<double> x;
  Array<double> y;
};

/// An SVG picture of the series on logarithmic axes. Values that are not positive lie at the lower
/// end.
std::string logLogPlot(const std::string& title, const std::string& xLabel,
                       const std::string& yLabel, const Array<Series>& series);

}  // namespace karcher
