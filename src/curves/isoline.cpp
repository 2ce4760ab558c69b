#include "curves/isoline.h"

#include <algorithm>
#include <utility>

#include "mesh/error.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// Traces one isoline after another on a walk from face to face.
class LinearIsolines {
 public:
  LinearIsolines(const TriangleMesh& mesh, const Array<double>& values, double level)
      : mesh_(mesh),
        values_(values),
        level_(level),
        visited_(static_cast<size_t>(mesh.faceCount()), 0) {}

  Array<Isoline> run() {
    // Lines that begin on the boundary come first, then closed ones.
    for (const bool fromBoundary : {true, false}) {
      for (int f = 0; f < mesh_.faceCount(); ++f) {
        if (visited_[f]) continue;
        const int entry = crossedHalfedge(f, true);
        if (entry >= 0 && (!fromBoundary || mesh_.twin[entry] < 0)) follow(entry);
      }
    }
    return std::move(isolines_);
  }

 private:
  bool isInside(int vertex) const { return values_[vertex] < level_; }

  /// The half-edge of a face along which the values rise through the level (or fall, if not
  /// `rising`); -1 for none.
  int crossedHalfedge(int face, bool rising) const {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      if (isInside(mesh_.tail(h)) == rising && isInside(mesh_.head(h)) != rising) return h;
    }
    return -1;
  }

  SurfacePoint crossing(int h) const {
    const double tail = values_[mesh_.tail(h)];
    const double head = values_[mesh_.head(h)];
    if (tail == kInfinity || head == kInfinity) return edgePoint(h, tail == kInfinity ? 1 : 0);
    return edgePoint(h, (level_ - tail) / (head - tail));
  }

  double edgeLength(int h) const {
    return (mesh_.positions[mesh_.head(h)] - mesh_.positions[mesh_.tail(h)]).norm();
  }

  /// Follows a line that enters a face at half-edge `entry`. The line leaves each face once, so
  /// that it ends at its first face or at the boundary.
  void follow(int entry) {
    Isoline line;
    line.closed = false;
    line.points.push_back(crossing(entry));
    double longestEdge = edgeLength(entry);
    for (int h = entry; h >= 0;) {
      const int face = faceOf(h);
      if (visited_[face]) {
        line.closed = true;
        break;
      }
      visited_[face] = 1;
      const int exit = crossedHalfedge(face, false);
      const SurfacePoint point = crossing(exit);
      longestEdge = std::max(longestEdge, edgeLength(exit));
      line.length += (position(mesh_, point) - position(mesh_, line.points.back())).norm();
      line.points.push_back(point);
      h = mesh_.twin[exit];
    }
    // Shorter lines go around a vertex whose value equals the level up to rounding.
    if (line.length > kChainRounding * longestEdge) isolines_.push_back(std::move(line));
  }

  const TriangleMesh& mesh_;
  const Array<double>& values_;
  double level_;
  Array<uint8_t> visited_;
  Array<Isoline> isolines_;
};

}  // namespace

void checkIsolineRadius(double radius) {
  if (radius > 0 && std::isfinite(radius)) return;
  refuse("an isoline's distance must be a positive number, not " + inSentence(radius));
}

Array<Isoline> linearIsolines(const TriangleMesh& mesh, const Array<double>& values, double level) {
  checkIsolineRadius(level);
  return LinearIsolines(mesh, values, level).run();
}

}  // namespace karcher
