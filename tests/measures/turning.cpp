#include "measures/turning.h"

#include <algorithm>

#include "mesh/nearest_in_triangle.h"

namespace karcher {
namespace {

Array<Box> boxesOfFaces(const TriangleMesh& mesh) {
  Array<Box> boxes(mesh.faces.size());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) boxes[f].include(mesh.positions[mesh.corner(f, k)]);
  }
  return boxes;
}

SurfacePoint nearestInFace(const TriangleMesh& mesh, int f, const Vec3& q) {
  return {f,
          nearestInTriangle(q, mesh.positions[mesh.corner(f, 0)], mesh.positions[mesh.corner(f, 1)],
                            mesh.positions[mesh.corner(f, 2)])};
}

}  // namespace

NearestOnMesh::NearestOnMesh(const TriangleMesh& mesh) : mesh_(&mesh), tree_(boxesOfFaces(mesh)) {}

SurfacePoint NearestOnMesh::at(const Vec3& place) const {
  const auto squaredDistance = [&](int f, const Vec3& q) {
    return (position(*mesh_, nearestInFace(*mesh_, f, q)) - q).squaredNorm();
  };
  return nearestInFace(*mesh_, tree_.nearest(place, squaredDistance).item, place);
}

SmoothNormals::SmoothNormals(const TriangleMesh& mesh)
    : mesh_(&mesh), atVertex_(mesh.positions.size(), Vec3::Zero()) {
  for (const Triangle& f : mesh.faces) {
    const Vec3& a = mesh.positions[f[0]];
    const Vec3 twiceArea = (mesh.positions[f[1]] - a).cross(mesh.positions[f[2]] - a);
    for (int k = 0; k < 3; ++k) atVertex_[f[k]] += twiceArea;
  }
  for (Vec3& normal : atVertex_) normal.normalize();
}

Vec3 SmoothNormals::at(const SurfacePoint& point) const {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) sum += point.bary[k] * atVertex_[mesh_->corner(point.face, k)];
  return sum.normalized();
}

Array<Vec3> evenlySpaced(const Array<Vec3>& polyline, int count) {
  Array<double> lengths = {0};
  for (int i = 1; i < polyline.count(); ++i) {
    lengths.push_back(lengths.back() + (polyline[i] - polyline[i - 1]).norm());
  }
  Array<Vec3> places;
  int k = 0;  // the piece from point k to the next
  for (int i = 0; i < count; ++i) {
    const double length = lengths.back() * i / (count - 1);
    while (k + 2 < polyline.count() && lengths[k + 1] < length) ++k;
    const double piece = lengths[k + 1] - lengths[k];
    const double s = piece > 0 ? std::clamp((length - lengths[k]) / piece, 0.0, 1.0) : 0;
    places.push_back((1 - s) * polyline[k] + s * polyline[k + 1]);
  }
  return places;
}

double turning(const TurningMeasure& measure, const Array<Vec3>& curve, int pieces) {
  const Array<Vec3> places = evenlySpaced(curve, pieces + 1);
  double sum = 0;
  for (int i = 1; i < pieces; ++i) {
    const Vec3 normal = measure.normals.at(measure.nearest.at(places[i]));
    const Vec3 before = places[i] - places[i - 1];
    const Vec3 after = places[i + 1] - places[i];
    // The direction is projected to the tangent plane.
    const Vec3 in = before - before.dot(normal) * normal;
    const Vec3 out = after - after.dot(normal) * normal;
    sum += std::atan2(std::abs(in.cross(out).dot(normal)), in.dot(out));
  }
  return sum * 180 / kPi;
}

}  // namespace karcher
