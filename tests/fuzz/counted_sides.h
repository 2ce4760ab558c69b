#pragma once

#include <optional>
#include <span>

#include "generators/random.h"
#include "intrinsic/geometry.h"
#include "intrinsic/surface_path.h"

/// Sides of paths by crossings that are counted one by one, face by face.
namespace karcher {

/// A point in each face, and ways from it over each side of the face to the neighbor's. Per path
/// the crossings on these ways tell how often more a point lies left of it than another one; where
/// two ways between the same faces disagree, the path does not bound.
class CountedSides {
 public:
  /// Throws std::runtime_error where no place is far enough from the paths to count.
  CountedSides(const Geometry& geometry, std::span<const SurfacePath> paths, Random& random);

  /// Whether paths (a range of them) bound together, where they end nowhere; by parity, or counted.
  bool bound(int first, int count, bool byParity) const;

  /// Per path how much more the point lies left of it than the first face's; none where a path
  /// is too near to tell.
  std::optional<Array<int>> labels(const SurfacePoint& point) const;

 private:
  struct Piece {
    int path;
    Vec2 from;
    Vec2 to;
  };
  /// Along an edge, from and to being parts of it.
  struct Run {
    int path;
    double from;
    double to;
  };

  void addPiece(int f, int path, const SurfacePoint& a, const SurfacePoint& b);
  bool count(int f, const Vec2& from, const Vec2& to, Array<int>& counts) const;
  bool isFree(int f, const Vec2& place) const;
  void placeMiddles(Random& random);
  /// What changes from a face's point to its neighbor's over the half-edge.
  Array<int> change(int h, Random& random) const;

  const TriangleMesh& mesh_;
  int paths_;
  Array<Array<Piece>> pieces_;  ///< per face
  Array<Array<Run>> runs_;      ///< per half-edge, of an edge's two the smaller one
  Array<Vec2> middle_;          ///< per face
  Array<Array<int>> labels_;    ///< per face
  Array<Array<int>> defects_;   ///< of the ways that labels were not taken by, where not all are 0
};

}  // namespace karcher
