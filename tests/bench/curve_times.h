#pragma once

#include "bench_support.h"
#include "curves/curve.h"

/// Times of a B-spline's steps for the benchmarks: medians of several runs.
namespace karcher {

constexpr int kRuns = 5;
/// The number of runs for steps of at most a few milliseconds.
constexpr int kQuickRuns = 50;

template <class Work>
double medianTime(const Work& work, int runs = kRuns) {
  Array<double> times;
  for (int i = 0; i < runs; ++i) times.push_back(timed(work));
  return median(times);
}

struct CurveTimes {
  double sampleUs = 0;  ///< the time of a sample with all fields known
  double dragMs = 0;    ///< a drag of the middle point by an edge: its field and segments
  double bridgeMs = 0;  // the search for jumps between the samples
  double joinMs = 0;    ///< the joining paths of all segments
  double weightMs = 0;  ///< another weight of the middle point: its segments, without joining paths
  int samples = 0;
  int lost = 0;
};

CurveTimes timeCurve(Surface& surface, const Array<SurfacePoint>& points, int samples,
                     const FieldOptions& field);

struct SteadyTimes {
  int levels = 0;     // the levels that 'auto' takes
  double dragMs = 0;  // a whole step of a drag of the middle point by an edge
};

/// Times of the default curve at its automatic levels, which a drag keeps.
SteadyTimes timeSteadyDrag(Surface& surface, const Array<SurfacePoint>& points, int samples);

/// The largest memory that the program has used so far.
double peakMemoryMB();

}  // namespace karcher
