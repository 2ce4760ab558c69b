#include "curves/trace/piece.h"

namespace karcher {
namespace {

/// The sign of i / (samples - 1) - k / count. It tells on which side of the start of part k the
/// evenly spaced sample i lies.
int sideOf(int i, int samples, int k, int count) {
  const int64_t sample = static_cast<int64_t>(i) * count;
  const int64_t joint = static_cast<int64_t>(k) * (samples - 1);
  return sample < joint ? -1 : sample > joint ? 1 : 0;
}

/// The index of the first evenly spaced sample after the start of part k.
int firstBehind(int samples, int k, int count) {
  return static_cast<int>(static_cast<int64_t>(k) * (samples - 1) / count) + 1;
}

void scale(WeightTable& table, const Array<double>& pointWeights) {
  for (int row = 0; row < table.t.count(); ++row) {
    double* weights = table.weights.data() + static_cast<ptrdiff_t>(row) * table.points;
    double sum = 0;
    for (int k = 0; k < table.points; ++k) sum += weights[k] *= pointWeights[k];
    for (int k = 0; k < table.points; ++k) weights[k] /= sum;
  }
}

}  // namespace

void tabulatePiece(const SegmentBasis& basis, int samples, const PartOfSegment& part,
                   Array<double>& row, PieceWeights& table) {
  for (WeightTable* rows : {&table.samples, &table.middles}) {
    rows->t.clear();
    rows->weights.clear();
  }
  const auto appendTo = [&](WeightTable& rows, double t) {
    weightsAt(basis, {}, t, row);
    append(rows, t, row);
  };
  if (part.count == 1) {
    for (int i = 0; i < samples; ++i) {
      appendTo(table.samples, static_cast<double>(i) / (samples - 1));
      if (i + 1 < samples) appendTo(table.middles, (i + 0.5) / (samples - 1));
    }
    return;
  }
  appendTo(table.samples, 0);
  for (int i = firstBehind(samples, part.index, part.count);
       i < samples && sideOf(i, samples, part.index + 1, part.count) < 0; ++i) {
    appendTo(table.samples, (static_cast<double>(i) * part.count -
                             static_cast<double>(part.index) * (samples - 1)) /
                                (samples - 1));
  }
  appendTo(table.samples, 1);
  const Array<double>& t = table.samples.t;
  for (int i = 0; i + 1 < t.count(); ++i) appendTo(table.middles, (t[i] + t[i + 1]) / 2);
}

PieceWeights weighted(const PieceWeights& weights, const Array<double>& pointWeights) {
  PieceWeights result = weights;
  scale(result.samples, pointWeights);
  scale(result.middles, pointWeights);
  return result;
}

void mergePieces(const Array<const TracedPiece*>& pieces, int even, TracedSegment& whole) {
  const int count = pieces.count();
  whole.samples.clear();
  whole.bridges.clear();
  SurfacePath& line = whole.path.line;
  line.points.clear();
  line.lengths.clear();
  Array<int>& ofPoints = whole.path.sample;
  ofPoints.clear();
  whole.path.unconverged.clear();
  for (int k = 0; k < count; ++k) {
    const TracedPiece& piece = *pieces[k];
    const auto inSegment = [&](double t) { return (k + t) / count; };
    for (const Bridge& bridge : piece.bridges) {
      const bool goesOn = bridge.reason == SampleStatus::kSubdivided && bridge.t0 == 0 &&
                          !whole.bridges.empty() &&
                          whole.bridges.back().reason == SampleStatus::kSubdivided &&
                          whole.bridges.back().t1 == inSegment(0);
      if (!goesOn) {
        Bridge& begun = whole.bridges.emplace_back();
        begun.t0 = inSegment(bridge.t0);
        begun.reason = bridge.reason;
      }
      Bridge& moved = whole.bridges.back();
      moved.t1 = inSegment(bridge.t1);
      // If one subdivided piece follows another, its first point already exists.
      const double before = goesOn ? moved.line.path.length() : 0;
      for (int i = goesOn ? 1 : 0; i < bridge.line.t.count(); ++i) {
        moved.line.t.push_back(inSegment(bridge.line.t[i]));
        moved.line.path.points.push_back(bridge.line.path.points[i]);
        moved.line.path.lengths.push_back(before + bridge.line.path.lengths[i]);
      }
    }
    // The start of a piece equals the end of the previous one.
    const int last = piece.samples.count() - 1;
    int next = even > 0 ? firstBehind(even, k, count) : 0;
    if (k == 0) whole.samples.push_back(piece.samples[0]);
    // If a joint is no sample, the points before it lead to the next sample.
    const int first = whole.samples.count();
    const auto inWhole = [&](int sample) { return sample == 0 ? 0 : first + sample - 1; };
    for (int i = 1; i <= last; ++i) {
      const bool atEnd = i == last && k + 1 == count;
      if (even > 0 && i == last && !atEnd && sideOf(next, even, k + 1, count) != 0) continue;
      CurveSample& sample = whole.samples.emplace_back(piece.samples[i]);
      sample.t = atEnd      ? 1
                 : even > 0 ? static_cast<double>(next++) / (even - 1)
                            : inSegment(sample.t);
    }
    const double before = k == 0 ? 0 : line.length();
    for (int i = k == 0 ? 0 : 1; i < piece.path.sample.count(); ++i) {
      line.points.push_back(piece.path.line.points[i]);
      line.lengths.push_back(before + piece.path.line.lengths[i]);
      ofPoints.push_back(inWhole(piece.path.sample[i]));
      whole.path.unconverged.push_back(piece.path.unconverged[i]);
    }
  }
}

}  // namespace karcher
