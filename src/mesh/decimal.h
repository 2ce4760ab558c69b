#pragma once

#include <string_view>

namespace karcher {

/// The double nearest to a decimal number: sign? (digits (. digits?)? | . digits) (e sign? digits)?
/// with at most 9 digits of exponent, which the caller has checked. Beyond the doubles it is
/// infinite.
double nearestDouble(std::string_view decimal);

}  // namespace karcher
