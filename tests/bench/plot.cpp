#include "plot.h"

#include <algorithm>
#include <sstream>

namespace karcher {
namespace {

constexpr double kWidth = 560;
constexpr double kHeight = 380;
constexpr double kLeft = 70;
constexpr double kRight = 150;
constexpr double kTop = 40;
constexpr double kBottom = 50;
constexpr double kSmallest = 1e-17;
const char* const kColors[] = {"#c2412d", "#d98e04", "#2563eb", "#12805c",
                               "#7c3aed", "#0f766e", "#111827", "#be185d"};

struct Range {
  double low = kInfinity;
  double high = -kInfinity;
  void include(double value) {
    const double exponent = std::log10(std::max(value, kSmallest));
    low = std::min(low, exponent);
    high = std::max(high, exponent);
  }
  double part(double value) const {
    return (std::log10(std::max(value, kSmallest)) - low) / std::max(high - low, 1e-9);
  }
};

}  // namespace

std::string logLogPlot(const std::string& title, const std::string& xLabel,
                       const std::string& yLabel, const Array<Series>& series) {
  Range xs;
  Range ys;
  for (const Series& s : series) {
    for (const double x : s.x) xs.include(x);
    for (const double y : s.y) ys.include(y);
  }
  ys.low = std::floor(ys.low);
  ys.high = std::ceil(ys.high);
  const double width = kWidth - kLeft - kRight;
  const double height = kHeight - kTop - kBottom;
  const auto px = [&](double x) { return kLeft + width * xs.part(x); };
  const auto py = [&](double y) { return kTop + height * (1 - ys.part(y)); };

  std::ostringstream out;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << kWidth << " " << kHeight
      << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      << "<text x=\"" << kLeft << "\" y=\"22\" font-size=\"14\">" << title << "</text>\n";
  const int step = std::max(1, static_cast<int>((ys.high - ys.low) / 8));
  for (int e = static_cast<int>(ys.low); e <= static_cast<int>(ys.high); e += step) {
    const double y = py(std::pow(10.0, e));
    out << "<line x1=\"" << kLeft << "\" x2=\"" << kLeft + width << "\" y1=\"" << y << "\" y2=\""
        << y << "\" stroke=\"#ddd\"/>\n<text x=\"" << kLeft - 8 << "\" y=\"" << y + 4
        << "\" text-anchor=\"end\">1e" << e << "</text>\n";
  }
  if (!series.empty()) {
    for (const double x : series.front().x) {
      out << "<text x=\"" << px(x) << "\" y=\"" << kTop + height + 18
          << "\" text-anchor=\"middle\">" << x << "</text>\n";
    }
  }
  out << "<text x=\"" << kLeft + width / 2 << "\" y=\"" << kHeight - 10
      << "\" text-anchor=\"middle\">" << xLabel << "</text>\n"
      << "<text transform=\"translate(16 " << kTop + height / 2
      << ") rotate(-90)\" text-anchor=\"middle\">" << yLabel << "</text>\n";
  for (int i = 0; i < series.count(); ++i) {
    const char* color = kColors[static_cast<size_t>(i) % std::size(kColors)];
    out << "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" << color << "\" points=\"";
    for (int k = 0; k < series[i].x.count(); ++k) {
      out << px(series[i].x[k]) << "," << py(series[i].y[k]) << " ";
    }
    out << "\"/>\n";
    for (int k = 0; k < series[i].x.count(); ++k) {
      out << "<circle r=\"3\" cx=\"" << px(series[i].x[k]) << "\" cy=\"" << py(series[i].y[k])
          << "\" fill=\"" << color << "\"/>\n";
    }
    out << "<text x=\"" << kLeft + width + 14 << "\" y=\"" << kTop + 16 + 20 * i << "\" fill=\""
        << color << "\">" << series[i].name << "</text>\n";
  }
  out << "</svg>\n";
  return out.str();
}

}  // namespace karcher
