#include "curves/trace/edge_crossings.h"

#include "mesh/rounding.h"
#include "mesh/sign_change.h"

namespace karcher {
namespace {

/// Calls visit(f) for each face that contains a point: one face if the point lies inside it, both
/// faces at an edge, and all faces around a vertex. Stops when visit returns true.
template <class Visit>
bool visitFacesAt(const TriangleMesh& mesh, const SurfacePoint& point, const Visit& visit) {
  const PointLocation place = locate(mesh, point);
  if (place.simplex == Simplex::kVertex) {
    for (const int h : outgoingHalfedges(mesh, place.vertex)) {
      if (visit(faceOf(h))) return true;
    }
    return false;
  }
  if (visit(place.face)) return true;
  const int twin = place.simplex == Simplex::kEdge ? mesh.twin[place.halfedge] : -1;
  return twin >= 0 && visit(faceOf(twin));
}

/// The way from point a to point b: a common face, or else a half-edge that leads from a face of
/// `a` into a face of `b`; -1 if no half-edge does.
struct Passage {
  bool sharesFace = false;
  int halfedge = -1;
};

Passage passageBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  if (a.face == b.face) return {true, -1};
  const auto holdsB = [&](int face) {
    return visitFacesAt(mesh, b, [&](int other) { return other == face; });
  };
  Passage passage;
  visitFacesAt(mesh, a, [&](int face) {
    passage.sharesFace = holdsB(face);
    for (int h = 3 * face; h < 3 * face + 3 && !passage.sharesFace; ++h) {
      if (mesh.twin[h] >= 0 && holdsB(faceOf(mesh.twin[h]))) passage.halfedge = h;
    }
    return passage.sharesFace;
  });
  return passage;
}

}  // namespace

EdgeCrossings::EdgeCrossings(SegmentFields& fields, const BasisWriter& basis, Method method,
                             CrossingWorkspace& workspace)
    : geometry_(fields.blend.geometry()),
      basis_(basis),
      method_(method),
      fields_(fields.blend),
      workspace_(workspace) {}

bool EdgeCrossings::append(const CurveSample& from, const CurveSample& to,
                           Array<SurfacePoint>& out) {
  workspace_.found.clear();
  if (!appendBetween(from, to, 0)) return false;
  for (const CurveSample& sample : workspace_.found) out.push_back(sample.point);
  return true;
}

bool EdgeCrossings::appendBetween(const CurveSample& from, const CurveSample& to, int bisections) {
  const Passage passage = passageBetween(*geometry_.mesh, from.point, to.point);
  if (passage.sharesFace ||
      (passage.halfedge >= 0 && appendCrossing(passage.halfedge, from.t, to.t))) {
    workspace_.found.push_back(to);
    return true;
  }
  if (bisections == kMostBisections) return false;
  const double t = (from.t + to.t) / 2;
  basis_(t, workspace_.weights);
  const SearchEnd center = findCenter(fields_, workspace_.weights, from.point, method_);
  if (center.status != Status::kConverged) return false;
  const CurveSample middle{t, center.point, SampleStatus::kConverged};
  return appendBetween(from, middle, bisections + 1) && appendBetween(middle, to, bisections + 1);
}

bool EdgeCrossings::appendCrossing(int h, double t0, double t1) {
  if (!fields_.cells().cut()) return appendCrossing(h, 0, t0, t1, true);
  return appendCrossing(h, 0, t0, t1, false) || appendCrossing(h, 1, t0, t1, false) ||
         appendCrossing(h, 0, t0, t1, true) || appendCrossing(h, 1, t0, t1, true);
}

bool EdgeCrossings::appendCrossing(int h, int half, double t0, double t1, bool orNearest) {
  fields_.alongEdge(h, half, workspace_.field);
  const auto valueAt = [&](double t) {
    basis_(t, workspace_.weights);
    return workspace_.field.at(workspace_.weights);
  };
  const auto across = [](const EdgeValues& v) { return cross(v.tail, v.head); };
  const double before = across(valueAt(t0));
  const double after = across(valueAt(t1));
  const bool passes = (before < 0) != (after < 0);
  if (!passes && !orNearest) return false;
  // If the curve does not pass the edge's line, a sample is so near the edge that the fields of the
  // faces place it on one side, and the field of the edge on the other.
  double t = std::abs(before) < std::abs(after) ? t0 : t1;
  if (passes) {
    t = signChange(t0, t1, before, after, kStepRounding,
                   [&](double place) { return across(valueAt(place)); });
  }
  const EdgeValues values = valueAt(t);
  double s = values.tail.x() / (values.tail.x() - values.head.x());
  if (!(s >= 0 && s <= 1)) return false;
  if (fields_.cells().cut()) s = (half + s) / 2;
  workspace_.found.push_back({t, edgePoint(h, s), SampleStatus::kConverged});
  return true;
}

}  // namespace karcher
