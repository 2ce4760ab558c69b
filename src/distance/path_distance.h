#pragma once

#include <queue>
#include <span>

#include "distance/window.h"
#include "intrinsic/geometry.h"
#include "intrinsic/point_fan.h"
#include "intrinsic/surface_path.h"

/// Exact geodesic distances from paths, up to a limit. A path may have a width at each place, which
/// is the radius of a disk around the place. Distances are then those from the disks, plus the
/// greatest radius.
///
/// A shortest connection meets a straight piece of a path at a right angle, or it meets a point
/// where the path turns or ends. In the second case, it lies in the wedge between the right angles
/// at that point. So each straight piece of a path sends out a front to each side, and each turn or
/// end sends out a fan. Fronts and fans travel from face to face as windows (D. Bommes, L. Kobbelt,
/// "Accurate computation of geodesic distance fields for polygonal curves on triangle meshes",
/// 2007). As in window_distance.h, vertices with shorter paths trim or end windows, and vertices of
/// negative curvature send out fans behind them. Every face keeps the images of the paths that it
/// sees, from which the distance of any point follows.
///
/// Where the width changes along a piece, the piece's fronts are tilted: the cosine of the angle
/// between a front's direction and the piece is the rate at which the width decreases. If the width
/// changes along a piece by the piece's length or more, the piece lies in the disk of one of its
/// ends. The fan of that end then replaces the piece's fronts.
namespace karcher {

/// The side of a path from which a shortest connection arrives; kEnd if it arrives around an end.
enum class SideOfPath : int8_t { kLeft = 1, kRight = -1, kEnd = 0 };

/// The points of a path. If a point equals the previous one up to rounding, it is omitted, since
/// the direction between them would be rounding noise. Throws Error kBadArgument if the path has no
/// length, or if consecutive points have no face in common; `number` names the path.
Array<SurfacePoint> pointsApart(const Geometry& geometry, const SurfacePath& path, int number);

class PathDistance {
 public:
  /// Finds the distances of all points that are at most `limit` away. The geometry must outlive the
  /// object. `widths` belong to places at equal steps of length along each path, and are linear in
  /// between; on a closed path, the first width follows the last. The distance of a point is then
  /// the least value of d + W - w over all places of the paths: d is the distance from the place, w
  /// the width there, and W the greatest width. Throws Error kBadArgument if a path has no length,
  /// if consecutive points have no face in common, or if the search needs more than
  /// kMostWindowsPerFace windows for each face.
  PathDistance(const Geometry& geometry, std::span<const SurfacePath> paths, double limit,
               std::span<const double> widths = {});

  struct Distance {
    double value = kInfinity;
    SideOfPath side = SideOfPath::kEnd;
  };

  /// The distance of a position in the frame of a face.
  Distance at(int face, const Vec2& place) const;
  /// The distance of a point: the least over all faces that contain it.
  Distance at(const SurfacePoint& point) const;
  double atVertex(int vertex) const { return arrivals_[vertex].distance; }

  /// The faces within the limit, in ascending order.
  const Array<int>& faces() const { return faces_; }

 private:
  /// An image of the paths in a face: a front, or the center of a fan.
  struct Image {
    int face = -1;
    bool isFront = false;
    SideOfPath side = SideOfPath::kEnd;
    double offset = 0;
    double least = 0;            ///< a lower bound on the distances through the image
    Vec2 source = Vec2::Zero();  ///< the unit direction of a front, or the center of a fan
    /// for a front, the right end of the line from which it starts; for a fan, a unit vector along
    /// its right side
    Vec2 right = Vec2::Zero();
    Vec2 left = Vec2::Zero();
  };

  /// A window that waits to cross the face of a half-edge. For a front, `sourceX` and `depth` are
  /// its direction, and `offset` is the distance at the tail of the half-edge.
  struct Waiting {
    double key = 0;
    int number = 0;
    int halfedge = -1;  ///< the half-edge, or -1 if the vertex `vertex` sends out its fan
    int vertex = -1;
    bool isFront = false;
    SideOfPath side = SideOfPath::kEnd;
    Window window;

    bool operator<(const Waiting& other) const {
      return key != other.key ? key > other.key : number > other.number;
    }
  };

  struct VertexArrival {
    double distance = kInfinity;
    double back = 0;  ///< the unscaled direction in which the shortest connection leaves the vertex
    SideOfPath side = SideOfPath::kEnd;
    bool isOnPath = false;
  };

  int partsOf(const SurfacePath& path) const;
  double startAt(const SurfacePath& path, double length) const;
  double growthAfter(const SurfacePath& path, int index) const;
  SurfacePath bentPath(const SurfacePath& path, int number) const;
  void markVertices(const SurfacePath& path);
  void leavePath(const SurfacePath& path);
  void leaveFront(int face, const Vec2& from, const Vec2& to, double start, double growth,
                  SideOfPath side);
  void leaveTurn(const SurfacePath& path, int index);
  void leaveFan(const PointFan& fan, double from, double to, double offset, SideOfPath side);
  void leaveCorner(int face, const Vec2& middle, double from, double to, double offset,
                   SideOfPath side);
  void leaveVertex(int vertex);
  void arrive(int vertex, double distance, double back, SideOfPath side);
  void addWindow(int h, const Window& window, bool isFront, SideOfPath side);
  void carryAcross(const Waiting& waiting);
  void run();
  void sortImages();

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  double limit_;
  std::span<const double> widths_;  ///< the widths, only during construction
  Array<VertexArrival> arrivals_;
  std::priority_queue<Waiting> queue_;
  int count_ = 0;
  Array<Image> images_;
  Array<int> faces_;
  /// for each face of `faces_`, the index of its first image; at the end, the number of images
  Array<int> firstOfFace_;
};

/// The distances of points from the nearest of the paths; kInfinity where no connection exists. The
/// search stops as soon as all distances are known. Throws what PathDistance throws.
Array<double> distancesFromPaths(const Geometry& geometry, std::span<const SurfacePath> paths,
                                 std::span<const SurfacePoint> points);

}  // namespace karcher
