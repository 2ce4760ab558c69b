#pragma once

#include <memory>
#include <optional>

#include "curves/spec/curve_layout.h"
#include "curves/trace/joined_path.h"

/// A piece of a curve: one center of mass of a few points. A curve of level 0 has one a segment,
/// others have 2^levels.
namespace karcher {

/// Which part of a segment a piece is: number `index` of `count` equal parts.
struct PartOfSegment {
  int index = 0;
  int count = 1;
  bool operator==(const PartOfSegment&) const = default;
};

/// The piece's parameters for evenly spaced samples of the segment: those that lie in the piece,
/// and both its ends. Table rows are at t in [0, 1] of the piece.
/// Written to `table`, whose memory is used again; `row` is scratch.
void tabulatePiece(const SegmentBasis& basis, int samples, const PartOfSegment& part,
                   Array<double>& row, PieceWeights& table);

/// The rows of a table times the points' weights, each divided by its sum.
PieceWeights weighted(const PieceWeights& weights, const Array<double>& pointWeights);

/// What tracing makes of a piece.
struct TracedPiece {
  Array<CurveSample> samples;  ///< in t of the piece, both ends included
  /// The intervals where it is no center of mass.
  Array<Bridge> bridges;
  JoinedPath path;
};

/// The same of a whole segment, in its t.
using TracedSegment = TracedPiece;

/// Writes a segment's pieces one after the other to `whole`, whose memory is used again. `even`:
/// how many evenly spaced samples the segment has, or 0 where a tolerance placed them; of even
/// samples the joints between pieces are only those that fall on them.
void mergePieces(const Array<const TracedPiece*>& pieces, int even, TracedSegment& whole);

}  // namespace karcher
