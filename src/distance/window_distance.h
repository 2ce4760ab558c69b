#pragma once

#include <optional>
#include <unordered_map>
#include <utility>

#include "distance/bucket_queue.h"
#include "distance/distance_solver.h"
#include "distance/edge_midpoints.h"
#include "distance/joined_windows.h"
#include "distance/paged_array.h"
#include "distance/source_images.h"
#include "distance/waiting_windows.h"
#include "distance/watched_target.h"
#include "intrinsic/geometry.h"

/// Geodesic distances from a point of the surface, by windows: exact, or with a tolerance.
///
/// A window is an interval of an edge and the position of its source: the source of the distances,
/// or a vertex at which shortest paths turn. All points of the interval see this source in a
/// straight line, unfolded into the plane of the face behind the edge. Windows cross the faces from
/// the nearest outwards (J. Chen, Y. Han, "Shortest paths on a polyhedron", 1990). If a vertex of
/// the face has shorter paths, it trims or ends windows (S. Xin, G. Wang, "Improving Chen and Han's
/// algorithm on the discrete geodesic problem", 2009). All windows that wait at an edge cross its
/// face at once. Windows cross edges in the order of distance; the order may deviate by up to half
/// a mean edge (after the triangle-oriented propagation of Y. Qin, X. Han, H. Yu, Y. Yu, J. Zhang,
/// "Fast and exact discrete geodesic computation based on triangle-oriented wavefront propagation",
/// 2016).
///
/// Where edges of very different lengths meet, the rounding of the long ones may exceed the width
/// of a window on the short ones, so that no window comes to a vertex. Paths along edges lead to
/// such a vertex.
///
/// A vertex at which shortest paths turn sends windows only into the wedge straight behind it: the
/// directions that are at least pi, on both sides, from the path that reached it.
///
/// With a tolerance, windows that wait at an edge are joined if that changes distances along the
/// edge by less than the tolerance times the height of the next face (after V. Surazhsky, T.
/// Surazhsky, D. Kirsanov, S. Gortler, H. Hoppe, "Fast exact and approximate geodesics on meshes",
/// 2005). The height is about the length of a path in the face. A joint window's source and offset
/// are those of the front to which both windows belong, so that on smooth surfaces distances
/// converge with the mesh as exact ones do. Only windows that touch are joined, and the rays at the
/// ends of a joint window may turn outwards, but not inwards: a gap between windows would lose the
/// places behind it, and a join across a gap would see places in a shadow. Distances are off by far
/// less than the tolerance. This is measured (`npm run study -- fields`) and not proven.
namespace karcher {

/// Whether shortest paths turn at a vertex: its total angle is greater than 2 pi (pi on the
/// boundary), or equal to it at the tip of a sliver.
bool spreadsPaths(const Geometry& geometry, int vertex);

class WindowDistance final : public DistanceSolver {
 public:
  /// The geometry must outlive the solver. Solvers may share the pool. Throws Error kBadArgument if
  /// the longest edge is more than kWidestRange times the shortest.
  explicit WindowDistance(const Geometry& geometry, double tolerance = 0,
                          const std::shared_ptr<PagePool>& pages = newPagePool());

  void setSource(const SurfacePoint& source) override;
  const SurfacePoint& source() const { return source_; }

  /// Propagates windows. The order of the steps is fixed, and no step changes a vertex that is
  /// nearer than the queue's least key. Throws Error kBadArgument if the search needs more than
  /// kMostWindowsPerFace windows for each face.
  void grow(double radius) override;
  /// The number of windows propagated since `setSource`.
  int64_t windowsCarried() const {
    return static_cast<int64_t>(kMostWindowsPerFace) * mesh_.faceCount() - windowsLeft_;
  }
  static constexpr double kWidestRange = 1e12;
  double growTo(int vertex) override { return growInSteps(*this, geometry_, source_, vertex); }

  double reached() const override { return queue_.empty() ? kInfinity : queue_.leastKey(); }
  bool isFinal(int vertex) const override { return distance(vertex) <= reached(); }

  /// The distance found so far, an upper bound until it is final.
  double distance(int vertex) const override {
    const VertexRecord* record = vertices_.find(vertex);
    return record == nullptr ? kInfinity : record->arrival.distance;
  }

  /// Calls visit(v) for every vertex that a path may have reached.
  template <class Visit>
  void forEachMet(const Visit& visit) const {
    vertices_.forEach(visit);
  }

  /// The distance of a vertex and the last turn of its path, which have no meaning where no path
  /// has arrived.
  const Arrival& arrival(int vertex) const { return vertices_.find(vertex)->arrival; }

  /// The unscaled direction (geometry.h), in [0, total angle], in which the shortest path leaves
  /// the vertex towards the source; 0 at the source itself. It has no meaning where no path has
  /// arrived.
  double direction(int vertex) const;
  Vec2 logVector(int vertex) const override {
    return logVectorAlong(geometry_, vertex, distance(vertex), direction(vertex));
  }

  PathStep stepTo(int vertex) const override;

  bool keepMidpoints() override { return keepsMidpoints_ = true; }
  MidpointArrival midpointOf(int h) const override {
    return midpoints_.arrival(h, source_, distance(mesh_.tail(h)), distance(mesh_.head(h)));
  }

  /// Also finds the distance of a point of a face or an edge. Call it after `setSource` and before
  /// `grow`; the source must not lie in a face of the target. Throws Error kBadArgument for a point
  /// at a vertex.
  void setTarget(const SurfacePoint& target) { target_.set(target); }
  /// The arrival at the target, final once `arrival.distance` <= reached().
  const TargetArrival& targetArrival() const { return target_.best(); }

  /// From the next `setSource` on, keeps the images with paths to points at this distance. Once all
  /// points within the distance are final, the shortest path from an image to a point at this
  /// distance has the point's distance as its length.
  void keepImages(double distance) { images_.keep(distance); }
  /// From the next `setSource` on, keeps all images in these faces.
  void keepImagesIn(Array<int> faces) { images_.keepIn(std::move(faces)); }
  const Array<SourceImage>& images() const { return images_.all(); }

  int64_t bytesHeld() const override { return vertices_.bytesHeld() + waiting_.bytesHeld(); }

  void aimAt(const std::optional<PathAim>& aim) override { aim_ = aim; }

 private:
  static constexpr int kNotQueued = std::numeric_limits<int>::max();

  struct VertexRecord {
    Arrival arrival;
    /// The path arrives through the face of half-edge `via`, which is opposite to the vertex; `via`
    /// is -1 at the source. `crossing` is the place where the path meets the line of this
    /// half-edge, measured from the half-edge's tail.
    double crossing = 0;
    int via = -1;
    int bucket = kNotQueued;  ///< the bucket in which the vertex waits to send out its own windows
  };

  void leaveSourceFace(int face, const SurfacePoint& source, int ownEdge);
  void leaveVertex(int vertex);
  void leaveThroughCorner(int vertex, int h, double from, double to);
  void carryAcross(int h);
  void arriveBent(int vertex, VertexRecord& record, int via, const Vec2& apex, const Window& window,
                  double crossing);
  void arrive(int vertex, VertexRecord& record, const Arrival& arrival, int via, double crossing);
  void addWindow(int h, const Window& window);
  bool leadsAway(int h, const Window& window) const;
  bool isBehindAnother(int h, const Window& window);
  void reachAlongEdges();

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  double tolerance_;
  SurfacePoint source_;
  PagedArray<VertexRecord, 7> vertices_;
  WaitingWindows waiting_;
  bool isWide_;       ///< whether the mesh has edges of very different lengths
  bool isThin_;       ///< whether paths may wind round a tip
  double narrowest_;  ///< the least width of a window, relative to its edge
  /// the widest window so far at each half-edge, if isThin_
  std::unordered_map<int, Window> widest_;
  bool keepsMidpoints_ = false;
  EdgeMidpoints midpoints_;
  BucketQueue queue_;
  int64_t windowsLeft_ = 0;
  int reachedCount_ = 0;  ///< the number of vertices reached
  Array<Window> batch_;
  /// the places where lines from the batch's sources to the apex cross the half-edge
  Array<double> crossings_;
  std::optional<PathAim> aim_;
  WatchedTarget target_;
  SourceImages images_;
};

}  // namespace karcher
