#pragma once

#include <memory>
#include <optional>

#include "curves/spec/curve_layout.h"
#include "curves/trace/joined_path.h"

/// A piece of a curve: one center of mass of a few points. A segment at level 0 has one piece,
/// otherwise 2^levels.
namespace karcher {

/// The part of a segment that a piece covers: number `index` of `count` equal parts.
struct PartOfSegment {
  int index = 0;
  int count = 1;
  bool operator==(const PartOfSegment&) const = default;
};

/// Writes to `table` the weights at the evenly spaced samples of the segment that lie in the piece,
/// at both ends of the piece, and in the middles between these. The rows have the piece's own t in
/// [0, 1]. `row` is scratch memory.
void tabulatePiece(const SegmentBasis& basis, int samples, const PartOfSegment& part,
                   Array<double>& row, PieceWeights& table);

/// The rows of a table times the points' weights, each divided by its sum.
PieceWeights weighted(const PieceWeights& weights, const Array<double>& pointWeights);

/// A traced piece.
struct TracedPiece {
  Array<CurveSample> samples;  ///< the samples in t of the piece, both ends included
  /// The intervals in which the piece is no center of mass.
  Array<Bridge> bridges;
  JoinedPath path;
};

/// A traced segment, with t of the segment.
using TracedSegment = TracedPiece;

/// Writes a segment's pieces one after the other to `whole`. `even` is the number of evenly spaced
/// samples of the segment, or 0 if a tolerance placed them; with evenly spaced samples, a joint
/// between pieces is a sample only if it coincides with one of them.
void mergePieces(const Array<const TracedPiece*>& pieces, int even, TracedSegment& whole);

}  // namespace karcher
