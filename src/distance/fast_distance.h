#pragma once

#include <memory>

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
/// settled, over the squared distance along the edge, interpolated from both. On a plane all is
/// exact on any tessellation; elsewhere errors are about 5e-4 of the distance.
namespace karcher {

class FastDistance {
 public:
  /// The geometry must outlive the solver. Fans may be shared between solvers of one geometry;
  /// without them the solver builds its own.
  explicit FastDistance(const Geometry& geometry, std::shared_ptr<const VertexFans> fans = nullptr);

  /// Starts anew from a point of a face, an edge or a vertex. Costs what was touched before.
  void setSource(const SurfacePoint& source);
  const SurfacePoint& source() const { return source_; }

  /// Settles vertices until all within `radius` (any number up to kInfinity) are final. Goes on
  /// where it stopped before: the work, and so every value, is the same as in one go.
  void grow(double radius);

  /// Every vertex as near as this is final; kInfinity once the whole component is.
  double reached() const { return barrier_; }

  /// Final values depend on the source alone, not on where `grow` stopped.
  bool isFinal(int vertex) const { return distance(vertex) <= barrier_; }

  /// Before it is final an estimate; kInfinity where nothing arrived.
  double distance(int vertex) const {
    const Jet* jet = jets_.find(vertex);
    return jet == nullptr ? kInfinity : jet->distance;
  }

  /// Distance of the last vertex that the path turns round; 0 where it comes straight from the
  /// source.
  double pseudoSourceDistance(int vertex) const { return jets_.find(vertex)->base; }

  /// Unscaled direction (geometry.h), in [0, total angle], in which the path leaves the vertex
  /// towards the source; 0 at the source itself. Meaningless where nothing arrived.
  double direction(int vertex) const;

  /// -2 log_v(source) = grad d^2 in the frame of the vertex: of length 2 d, pointing on along the
  /// path that arrives. Meaningless where nothing arrived.
  Vec2 logVector(int vertex) const;

  /// The vertices that something arrived at, in the order in which they were first touched.
  const Array<int>& touched() const { return touched_; }

 private:
  struct Jet {
    double distance = kInfinity;
    double base = 0;
    Vec2 toSource = Vec2::Zero();  ///< unit, unscaled in the fan's plane; zero at the source
    int corner = -1;               ///< the corner of the fan through which the path arrives
    bool settled = false;
    bool alongEdge = false;  ///< the path comes along an edge from the vertex at `base`
  };

  /// The vertex at the end of an edge of the vertex that is being settled.
  struct End {
    Jet* jet;
    double before;  ///< its distance until now
    double distance;
    double open;  ///< the distance while it is not settled, else kInfinity
  };

  void placeInFace(int face, const Vec2& source);
  void settle(int vertex);
  void goAlongEdge(const Jet& own, const FanEdge& edge, Jet& end);
  int listCrossings(const Jet& own, int begin, int count);
  template <int kSide>
  void cross(int vertex, const Jet& own, int edgeNumber, int targetNumber);
  template <int kSide>
  void crossEdge(const FanEdge& edge, const FanEdge& target, const EdgeEnd& a, const Vec2& apex,
                 double inverse);
  template <int kSide>
  bool look(const FanEdge& along, const Jet& jet, double inverseLength, EdgeEnd& end) const;
  bool looksTooFar(int vertex, int edge, int side) const;
  bool mayArrive(const Jet& jet, double distance, int corner) const;
  void enqueue(int vertex, double before);

  const Geometry& geometry_;
  std::shared_ptr<const VertexFans> fans_;
  SurfacePoint source_;
  PagedArray<Jet, 6> jets_;
  Array<int> touched_;
  OrderedQueue queue_;
  /// Of the vertex that is being settled: its edges' ends, and the edges that a path may cross: to
  /// the left of edge i as 2 i, to the right of the one after it as 2 i + 1.
  Array<End> ends_;
  Array<int> crossings_;
  double front_ = 0;     ///< the largest distance settled so far
  double longest_ = 0;   ///< the longest edge met so far
  double barrier_ = -1;  ///< what is as near as this does not change any more
};

}  // namespace karcher
