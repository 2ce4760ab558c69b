#pragma once

#include "distance/window.h"
#include "intrinsic/geometry.h"

namespace karcher {

/// The vertices that a point sees in a straight line across the unfolded faces around it. The graph
/// solver uses these lines as arcs. A window is the part of an edge that the point sees. It crosses
/// the face behind the edge and splits at the opposite vertex. Unlike in window_distance.h, paths
/// do not turn at vertices: a path with turns consists of several arcs.
class Visibility {
 public:
  struct Sight {
    int vertex = -1;
    double length = 0;
    double direction = 0;  ///< the unscaled direction at the vertex towards the source
  };

  explicit Visibility(const Geometry& geometry);

  /// The vertices that a vertex sees within its k-ring: the faces whose corners are all at most
  /// `rings` edges away. Each comes with its shortest line. The result may omit a line if another
  /// path is shorter.
  const Array<Sight>& fromVertex(int vertex, int rings);

  /// The vertices that a point inside a face or on an edge sees within the faces that share a
  /// vertex with its face or faces.
  const Array<Sight>& fromPoint(const SurfacePoint& point);

 private:
  /// The part of a half-edge that the source sees. It waits to cross the half-edge's face.
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
  /// For each vertex, the number of the last call that allowed the vertex, and of the last call
  /// that saw it. So a new call need not clear the arrays.
  Array<int> ringCall_;
  Array<int> sightCall_;
  Array<int> sightOf_;  ///< the index of each vertex's line in sights_
  int call_ = 0;
  Array<int> ring_;
  Array<WaitingWindow> windows_;
  Array<Sight> sights_;
};

}  // namespace karcher
