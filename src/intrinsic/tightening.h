#pragma once

#include "intrinsic/angles.h"
#include "intrinsic/strip_path.h"

/// Internal: the algorithm of strip_path.h. It is in tightening.cpp, strip_shortening.cpp and
/// strip_path.cpp.
namespace karcher {

inline bool touches(const TriangleMesh& mesh, int h, int vertex) {
  return mesh.tail(h) == vertex || mesh.head(h) == vertex;
}

/// The algorithm that pulls one strip between two points tight.
class Tightening {
 public:
  using Portal = StripWorkspace::Portal;
  using Bend = StripWorkspace::Bend;
  using Passage = StripWorkspace::Passage;

  Tightening(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
             StripWorkspace& workspace)
      : geometry_(geometry),
        mesh_(*geometry.mesh),
        from_(from),
        to_(to),
        fromLocation_(locate(mesh_, from)),
        toLocation_(locate(mesh_, to)),
        workspace_(workspace),
        strip_(workspace.strip),
        bends_(workspace.bends) {}

  void run(bool shorten) {
    // Each turn shortens the path, except at angles that equal pi up to rounding. Only such turns
    // need a bound. A strip that goes around a corner may pass over all vertices on the way, up to
    // a quarter of the squared number of crossings.
    const int64_t crossings = crossingCount();
    turnsLeft_ = 64 + 16 * crossings + crossings * crossings / 4;
    trimEnds();
    // Turns unfold parts of the strip in frames of their own. The final path needs a single frame.
    pullAllTight();
    while (turnSharpBends() || shorten) {
      if (shorten) passOverVertices();
      shorten = false;
      trimEnds();
      pullAllTight();
    }
  }

  double append(Array<SurfacePoint>& out) const;

 private:
  struct Trimmed {
    int front;
    int back;
  };
  Trimmed trimEnds();

  Vec2 unfold(int first, int last);
  Vec2 endBeyond(const Vec2& apex) const;
  void pullTight(int first, int last, const Vec2& start, const Vec2& end, Array<Bend>& bends);
  void measureBends(int first, int last, const Vec2& start, const Vec2& end, Array<Bend>& bends);
  void pullAllTight();
  void pullBetween(int before, int after);

  int sharpestBend() const;
  bool turnSharpBends();
  bool turnRound(const Bend& bend, int before, int after);
  void pullTightAround(int before, int after, int first, int last, int count);
  double length() const;
  void passOverVertices();
  bool shortenLeg(int leg);
  bool passOver(const Passage& passage, int leg);
  void updateOutside(Bend& bend);

  int crossing(int i) const { return strip_.crossings[i]; }
  int crossingCount() const { return strip_.crossings.count(); }

  int vertexOf(const Bend& bend) const {
    const int h = crossing(bend.portal);
    return bend.onLeft ? mesh_.head(h) : mesh_.tail(h);
  }
  Vec2 positionOf(const Bend& bend) const {
    const Portal& portal = workspace_.portals[bend.portal];
    return bend.onLeft ? portal.left : portal.right;
  }
  /// The end of a portal opposite to a bend's vertex. The portal must end at this vertex.
  Vec2 acrossFrom(const Bend& bend, int portal) const {
    return bend.onLeft ? workspace_.portals[portal].right : workspace_.portals[portal].left;
  }
  /// The angle in the strip between the two legs of the path at a bend.
  double angleInside(const Bend& bend) const {
    return geometry_.totalAngle[vertexOf(bend)] - bend.outside;
  }

  /// The portals that end at a bend's vertex: [first, last].
  struct Run {
    int first;
    int last;
  };
  Run runAround(const Bend& bend) const {
    const int vertex = vertexOf(bend);
    Run run{bend.portal, bend.portal};
    while (run.first > 0 && touches(mesh_, crossing(run.first - 1), vertex)) --run.first;
    while (run.last + 1 < crossingCount() && touches(mesh_, crossing(run.last + 1), vertex)) {
      ++run.last;
    }
    return run;
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const SurfacePoint& from_;
  const SurfacePoint& to_;
  PointLocation fromLocation_;
  PointLocation toLocation_;
  StripWorkspace& workspace_;
  Strip& strip_;
  Array<Bend>& bends_;
  Vec2 start_;  ///< the point from_, unfolded by pullAllTight
  Vec2 end_;
  double lastLeg_ = 0;  ///< the length of the path after the last bend
  int64_t turnsLeft_ = 0;
  int passagesLeft_ = 0;
};

}  // namespace karcher
