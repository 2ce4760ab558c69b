#include "mesh/error.h"

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

}  // namespace karcher
