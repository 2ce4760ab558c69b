#pragma once

#include <memory>
#include <optional>

#include "curves/spec/curve_layout.h"
#include "curves/trace/joined_path.h"

/// A piece of a curve. Its points are centers of mass of a few points of the refined polygon. A
/// segment has 2^levels pieces: a single one at level 0.
namespace karcher {

/// The part of a segment that a piece covers: number `index` of `count` equal parts.
struct PartOfSegment {
  int index = 0;
  int count = 1;
  bool operator==(const PartOfSegment&) const = default;
};

/// Writes to `table` the weights at a piece's samples, which are both ends of the piece and the
/// evenly spaced samples of the segment inside it, and the weights in the middles between them. The
/// rows have the piece's own t in [0, 1]. `row` is scratch memory.
void tabulatePiece(const SegmentBasis& basis, int samples, const PartOfSegment& part,
                   Array<double>& row, PieceWeights& table);

/// The rows of a table times the points' weights, each divided by its sum.
PieceWeights weighted(const PieceWeights& weights, const Array<double>& pointWeights);

/// A traced piece.
struct TracedPiece {
  Array<CurveSample> samples;  ///< the samples in t of the piece, both ends included
  /// The bridges, over the intervals in which the piece's points are no centers of mass.
  Array<Bridge> bridges;
  JoinedPath path;
};

/// A traced segment, with t of the segment.
using TracedSegment = TracedPiece;

/// Writes a segment's pieces one after the other to `whole`. `even` is the number of evenly spaced
/// samples of the segment, or 0 if a tolerance placed the samples. If they are evenly spaced, a
/// joint between pieces is a sample only if one of these samples lies there.
void mergePieces(const Array<const TracedPiece*>& pieces, int even, TracedSegment& whole);

}  // namespace karcher
