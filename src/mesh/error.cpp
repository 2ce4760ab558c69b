#include "mesh/error.h"

#include <cstdio>
#include <cstdlib>
#include <limits>

namespace karcher {

const char* errorCodeName(ErrorCode code) {
  switch (code) {
    case ErrorCode::kBadFile:
      return "badFile";
    case ErrorCode::kBadIndex:
      return "badIndex";
    case ErrorCode::kNotFinite:
      return "notFinite";
    case ErrorCode::kDegenerateFace:
      return "degenerateFace";
    case ErrorCode::kNonManifoldEdge:
      return "nonManifoldEdge";
    case ErrorCode::kNonManifoldVertex:
      return "nonManifoldVertex";
    case ErrorCode::kNotOrientable:
      return "notOrientable";
    case ErrorCode::kBadPoint:
      return "badPoint";
    case ErrorCode::kBadWeights:
      return "badWeights";
    case ErrorCode::kTooFewPoints:
      return "tooFewPoints";
    case ErrorCode::kBadArgument:
      return "badArgument";
    case ErrorCode::kUnreachable:
      return "unreachable";
    case ErrorCode::kBoundary:
      return "boundary";
    case ErrorCode::kRadiusTooLarge:
      return "radiusTooLarge";
    case ErrorCode::kNoEmbedding:
      return "noEmbedding";
  }
  return "unknown";
}

void refuse(const std::string& sentence) { throw Error(ErrorCode::kBadArgument, sentence); }

std::string inSentence(double value, int digits) {
  // A stream would add the large code of locales.
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string inFull(double value) {
  int digits = 6;
  constexpr int enough = std::numeric_limits<double>::max_digits10;
  while (digits < enough && std::strtod(inSentence(value, digits).c_str(), nullptr) != value) {
    ++digits;
  }
  return inSentence(value, digits);
}

}  // namespace karcher
