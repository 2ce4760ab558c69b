#include "mesh/decimal.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

namespace karcher {
namespace {

/// The number is sign * mantissa * 10^exponent where its digits fit the mantissa.
struct Digits {
  uint64_t mantissa = 0;
  int count = 0;  ///< of digits from the first that is not 0
  int64_t exponent = 0;
  bool negative = false;
};

Digits readDigits(std::string_view decimal) {
  constexpr int kMostDigits = 19;
  Digits digits;
  size_t i = decimal[0] == '-' || decimal[0] == '+' ? 1 : 0;
  digits.negative = decimal[0] == '-';
  bool fraction = false;
  for (; i < decimal.size() && decimal[i] != 'e' && decimal[i] != 'E'; ++i) {
    if (decimal[i] == '.') {
      fraction = true;
      continue;
    }
    if (digits.count > 0 || decimal[i] != '0') ++digits.count;
    if (digits.count <= kMostDigits) {
      digits.mantissa = 10 * digits.mantissa + static_cast<uint64_t>(decimal[i] - '0');
    }
    if (fraction) --digits.exponent;
  }
  if (i == decimal.size()) return digits;
  const bool negative = decimal[++i] == '-';
  if (negative || decimal[i] == '+') ++i;
  int64_t exponent = 0;
  for (; i < decimal.size(); ++i) exponent = 10 * exponent + (decimal[i] - '0');
  digits.exponent += negative ? -exponent : exponent;
  return digits;
}

/// The nearest double of a number that the fast way cannot tell: one of many digits, or far from 1.
double nearestOfAny(std::string_view decimal, const Digits& digits) {
#ifdef __cpp_lib_to_chars
  if (decimal[0] == '+') decimal.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
  if (error != std::errc::result_out_of_range) return value;
  const double beyond =
      digits.count + digits.exponent > 0 ? std::numeric_limits<double>::infinity() : 0;
  return digits.negative ? -beyond : beyond;
#else
  // Emscripten's library has no from_chars of doubles; its strtod knows no locale.
  static_cast<void>(digits);
  return std::strtod(std::string(decimal).c_str(), nullptr);
#endif
}

}  // namespace

/// W. Clinger, "How to Read Floating Point Numbers Accurately" (1990): a product or quotient of two
/// numbers that are doubles exactly is rounded once.
double nearestDouble(std::string_view decimal) {
  constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                           1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                           1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr int kMostExactDigits = 15;
  constexpr int64_t kMostExactPower = 22;
  const Digits digits = readDigits(decimal);
  if (digits.count > kMostExactDigits || digits.exponent > kMostExactPower ||
      digits.exponent < -kMostExactPower) {
    return nearestOfAny(decimal, digits);
  }
  const auto mantissa =
      static_cast<double>(digits.negative ? -static_cast<int64_t>(digits.mantissa)
                                          : static_cast<int64_t>(digits.mantissa));
  const double power = kPowers[static_cast<size_t>(std::abs(digits.exponent))];
  const double value = digits.exponent < 0 ? mantissa / power : mantissa * power;
  return digits.mantissa == 0 && digits.negative ? -0.0 : value;
}

}  // namespace karcher
