#pragma once

#include <optional>
#include <span>

#include "generators/random.h"
#include "intrinsic/geometry.h"
#include "intrinsic/surface_path.h"

/// The sides of paths, by the count of single crossings face by face.
namespace karcher {

/// A point in each face, and lines from it across each side of the face to the neighbor's point.
/// For each path the crossings along these lines give the winding of one point relative to another;
/// if two lines between the same faces disagree, the path does not bound a region.
class CountedSides {
 public:
  /// Throws std::runtime_error if every place is too near to the paths.
  CountedSides(const Geometry& geometry, std::span<const SurfacePath> paths, Random& random);

  /// Whether paths (a range of them) bound a region together; by parity, or with multiplicity.
  bool bound(int first, int count, bool byParity) const;

  /// For each path the winding of the point relative to the first face's point; empty if a path is
  /// too near.
  std::optional<Array<int>> labels(const SurfacePoint& point) const;

 private:
  struct Piece {
    int path;
    Vec2 from;
    Vec2 to;
  };
  /// A run along an edge, between two fractions of it.
  struct Run {
    int path;
    double from;
    double to;
  };

  void addPiece(int f, int path, const SurfacePoint& a, const SurfacePoint& b);
  bool count(int f, const Vec2& from, const Vec2& to, Array<int>& counts) const;
  bool isFree(int f, const Vec2& place) const;
  void placeMiddles(Random& random);
  /// The change from a face's point to its neighbor's, across the half-edge.
  Array<int> change(int h, Random& random) const;

  const TriangleMesh& mesh_;
  int paths_;
  Array<Array<Piece>> pieces_;  // the pieces by face
  Array<Array<Run>> runs_;      // the runs by half-edge: the smaller one of the edge's two
  Array<Vec2> middle_;          // the points by face
  Array<Array<int>> labels_;    // the labels by face
  Array<Array<int>> defects_;   // changes along lines without labels, if not all are 0
};

}  // namespace karcher
