#pragma once

#include "distance/window.h"
#include "intrinsic/geometry.h"

namespace karcher {

/// The vertices that a point sees in a straight line across the faces around it, unfolded: the arcs
/// of the graph solver. A window is the part of an edge that the point sees; it is carried across
/// the face behind and split at the vertex there (the windows of window_distance.h without vertices
/// that paths turn round: a path that does is made of arcs).
class Visibility {
 public:
  struct Sight {
    int vertex = -1;
    double length = 0;
    double direction = 0;  ///< unscaled, at the vertex, in which the line leaves it to the source
  };

  explicit Visibility(const Geometry& geometry);

  /// What a vertex sees within its k-ring: the faces whose corners are all at most `rings` edges
  /// away. For each vertex the shortest line; a line longer than another path may be left out.
  const Array<Sight>& fromVertex(int vertex, int rings);

  /// What a point inside a face or on an edge sees within the faces that share a vertex with its
  /// face or faces.
  const Array<Sight>& fromPoint(const SurfacePoint& point);

 private:
  /// What the source sees of a half-edge; it goes on through the half-edge's face.
  struct WaitingWindow {
    int halfedge;
    Window window;
  };

  void start();
  void allowRing(int vertex, int rings);
  bool allowed(int vertex) const { return ringCall_[vertex] == call_; }
  void see(int vertex, double length, double direction);
  double seen(int vertex) const;
  void addWindow(int h, Window window);
  void carryAcross(int h, const Window& window);
  void run();

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  /// Per vertex the number of the last call that allowed it, and of the last that saw it: a new
  /// call need not clear them.
  Array<int> ringCall_;
  Array<int> sightCall_;
  Array<int> sightOf_;  ///< per vertex, its number in sights_
  int call_ = 0;
  Array<int> ring_;
  Array<WaitingWindow> windows_;
  Array<Sight> sights_;
};

}  // namespace karcher
