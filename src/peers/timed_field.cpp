#include "peers/timed_field.h"

#include <cmath>
#include <unordered_set>

namespace karcher {
namespace {

/// The vertices within the radius. The search goes from vertex to vertex, so that it visits only
/// the neighbourhood.
Array<int> verticesWithin(const TriangleMesh& mesh, PointField& field, double radius) {
  Array<int> stack;
  std::unordered_set<int> seen;
  const auto visit = [&](int v) {
    if (seen.insert(v).second) stack.push_back(v);
  };
  for (int k = 0; k < 3; ++k) visit(mesh.corner(field.point().face, k));
  Array<int> within;
  while (!stack.empty()) {
    const int v = stack.back();
    stack.pop_back();
    if (std::sqrt(field.field().at(v).squaredDistance) > radius) continue;
    within.push_back(v);
    for (const int h : outgoingHalfedges(mesh, v)) {
      visit(mesh.head(h));
      visit(mesh.opposite(h));
    }
  }
  return within;
}

}  // namespace

TimedField::TimedField(Surface& surface, const FieldOptions& options, const SurfacePoint& point,
                       double radius)
    : field_(surface, options), point_(point) {
  field_.setPoint(point);
  within_ = verticesWithin(surface.mesh(), field_, radius);
}

void TimedField::read() {
  field_.setPoint(point_);
  for (const int v : within_) field_.field().at(v);
}

}  // namespace karcher
