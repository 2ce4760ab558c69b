#include "curves/trace/sample_status.h"

namespace karcher {

SampleStatus sampleStatus(Status ofSearch) {
  switch (ofSearch) {
    case Status::kConverged:
      return SampleStatus::kConverged;
    case Status::kIndefinite:
      return SampleStatus::kIndefinite;
    case Status::kBoundary:
      return SampleStatus::kBoundary;
    case Status::kNoProgress:
      return SampleStatus::kNoProgress;
    case Status::kLimit:
    case Status::kLowerNearby:  // a status of means only
      break;
  }
  return SampleStatus::kLimit;
}

const char* statusName(SampleStatus status) {
  switch (status) {
    case SampleStatus::kConverged:
      return statusName(Status::kConverged);
    case SampleStatus::kIndefinite:
      return statusName(Status::kIndefinite);
    case SampleStatus::kBoundary:
      return statusName(Status::kBoundary);
    case SampleStatus::kNoProgress:
      return statusName(Status::kNoProgress);
    case SampleStatus::kLimit:
      return statusName(Status::kLimit);
    case SampleStatus::kJump:
      return "jump";
    case SampleStatus::kBridged:
      return "bridged";
    case SampleStatus::kSubdivided:
      return "subdivided";
  }
  return "unknown";
}

}  // namespace karcher
