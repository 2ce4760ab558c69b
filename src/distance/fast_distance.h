#pragma once

#include <memory>

#include "distance/distance_solver.h"
#include "distance/edge_crossing.h"
#include "distance/ordered_queue.h"
#include "distance/paged_array.h"
#include "intrinsic/vertex_fans.h"

/// Approximate geodesic distances and directions from a point of the surface, fast.
///
/// As in Dijkstra's algorithm vertices are settled from the nearest outwards, but paths cross
/// faces. A vertex holds its distance, the direction to the source and the base of that direction:
/// the distance of the last vertex that the path turns round (0 if none). With these it places a
/// virtual source in the plane of the faces around it. A face's apex is reached from the edge
/// opposite to it (edge_crossing.h): from the virtual source of one end, or, where both ends are
/// settled, over the squared distance along the edge, interpolated from both. Of two paths of one
/// length across faces the mesh's numbering chooses (arrival.h). On a plane all is exact on any
/// tessellation. Elsewhere, on the meshes of docs/gallery.md that the solver suits (fast_trial.h),
/// the mean relative error is at most 1.1e-3 and the worst 1.5 %.
namespace karcher {

class FastDistance final : public DistanceSolver {
 public:
  /// The geometry must outlive the solver. Fans may be shared between solvers of one geometry;
  /// without them the solver builds its own. The pool may be shared, too.
  explicit FastDistance(const Geometry& geometry, std::shared_ptr<const VertexFans> fans = nullptr,
                        std::shared_ptr<PagePool> pages = newPagePool());

  void setSource(const SurfacePoint& source) override;
  void grow(double radius) override;
  double growTo(int vertex) override;

  double reached() const override {
    return queue_.empty() ? kInfinity : front_ - static_cast<double>(longestDelay_);
  }
  bool isFinal(int vertex) const override {
    const VertexRecord* record = vertices_.find(vertex);
    return record != nullptr && (isFinal(*record) || (record->settled && queue_.empty()));
  }

  /// Before it is final an estimate.
  double distance(int vertex) const override {
    const VertexRecord* record = vertices_.find(vertex);
    return record == nullptr ? kInfinity : record->distance;
  }

  /// Calls visit(v) for every vertex that a path may have reached.
  template <class Visit>
  void forEachMet(const Visit& visit) const {
    vertices_.forEach(visit);
  }

  /// Unscaled direction (geometry.h), in [0, total angle], in which the path leaves the vertex
  /// towards the source; 0 at the source itself. Meaningless where nothing arrived.
  double direction(int vertex) const;
  Vec2 logVector(int vertex) const override;
  PathStep stepTo(int vertex) const override;

 private:
  static constexpr int kNotWaiting = -1;
  /// A vertex is settled so often at most. Ordinary ones are a few times, but in slivers rounding
  /// may find the same path shorter for ever.
  static constexpr int kMostTimes = 100;

  struct VertexRecord {
    double distance = kInfinity;
    double base = 0;
    Vec2 toSource = Vec2::Zero();  ///< unit, unscaled in the fan's plane; zero at the source
    int corner = -1;               ///< the corner of the fan through which the path arrives
    int place = kNotWaiting;       ///< in the queue
    float delay = 0;               ///< VertexFans::delay
    uint16_t times = 0;            ///< it was settled
    bool settled = false;
    bool alongEdge = false;  ///< the path comes along an edge from the vertex at `base`
  };

  /// The edges of the vertex that is being settled, side by side, and what is known at their ends.
  /// Each number has an array, so that the compiler treats several edges at once.
  struct Ring {
    static constexpr int kCorners = 30;  ///< of wider fans a part at a time
    static constexpr int kEdges = kCorners + 2;
    VertexRecord* record[kEdges];
    int number[kEdges];       ///< of the edge, among all fans'
    double before[kEdges];    ///< the distance at the end, before
    double distance[kEdges];  ///< and after a path along the edge
    double length[kEdges];
    double least[kEdges];  ///< no path meets the edge nearer to the source; times its length
    /// How far from the edge an apex may lie that is reached before the edge's end, as twice the
    /// area between; kInfinity if the end is settled.
    double room[kEdges];
    double area[kEdges];  ///< twice that of the triangle on the left of the edge
    /// The direction from the vertex to its source times the edge: dot product, and cross product
    /// with the edge turned counterclockwise from the source on and clockwise (then negated). Not a
    /// number where it turns beyond the boundary.
    double dot[kEdges];
    double left[kEdges];
    double right[kEdges];
    /// Whether a path may cross the edge to the end of the next one on its left, or the next one to
    /// the end of this one.
    bool crossesLeft[kEdges];
    bool crossesRight[kEdges];
    int leftward[kEdges];
    int rightward[kEdges];
  };

  /// Whether the front has gone so far that the vertex's value does not change any more.
  bool isFinal(const VertexRecord& record) const {
    return record.settled & (record.distance + static_cast<double>(record.delay) <= front_);
  }

  void placeInFace(int face, const Vec2& source);
  void settle(int vertex);
  bool goesStraightOn(int vertex, const VertexRecord& record, int number) const;
  void goRound(int vertex, const VertexRecord& from, int first, int count);
  void goAlongEdge(const VertexRecord& from, const Vec2 (&turns)[2], const FanEdge& edge,
                   int number, int place);
  void closeRing(int place);
  void findCrossings(double distance, double radius, int corners);
  template <int kSide>
  void cross(int vertex, const VertexRecord& from, int edgeInRing, int targetInRing);
  template <int kSide>
  void crossEdge(const FanEdge& edge, const FanEdge& target, const VertexRecord& other,
                 VertexRecord& reached, const EdgeEnd& a, const Vec2& apex, double inverse);
  template <int kSide>
  bool findSourceAngle(const FanEdge& along, const VertexRecord& record, double inverseLength,
                       EdgeEnd& end) const;
  bool turnsTooFar(int vertex, int edge, int side) const;
  double noLessThanStraight(int vertex, double distance) const;
  bool mayArrive(const VertexRecord& record, double distance, int corner) const;
  static bool ties(const VertexRecord& record, double distance, int corner);
  double direction(const VertexRecord& record) const;
  bool haveOneDirection(int vertex, const VertexRecord& a, const VertexRecord& b) const;
  void enqueueTied(int met);
  void enqueue(int vertex, VertexRecord& record, double before);

  const Geometry& geometry_;
  Vec3 source_ = Vec3::Zero();
  std::shared_ptr<const VertexFans> fans_;
  PagedArray<VertexRecord, 4> vertices_;
  OrderedQueue queue_;
  Ring ring_{};
  VertexRecord nowhere_;    ///< takes what is not wanted
  double front_ = 0;        ///< the largest distance settled so far
  bool hasTied_ = false;    ///< it has replaced a path by another one of the same length
  float longestDelay_ = 0;  ///< the largest delay of the vertices met so far
};

}  // namespace karcher
