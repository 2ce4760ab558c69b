#include "measures/corner.h"

#include <cmath>
#include <limits>

#include "curves/query/evaluate.h"

namespace karcher {

double cornerAt(Curve& curve, double parameter) {
  constexpr double kBeside = 1e-7;
  const CurveTangent before = tangentAt(curve, parameter - kBeside);
  const CurveTangent after = tangentAt(curve, parameter + kBeside);
  const Geometry& geometry = curve.surface().geometry();
  Vec2 in = before.inFace;
  // On an edge, the point before and the point after lie in faces of their own.
  if (before.at.point.face != after.at.point.face) {
    const TriangleMesh& mesh = *geometry.mesh;
    int h = 3 * before.at.point.face;
    const int last = h + 2;
    while (h < last && mesh.twin[h] / 3 != after.at.point.face) ++h;
    if (mesh.twin[h] < 0 || mesh.twin[h] / 3 != after.at.point.face) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    in = acrossEdge(geometry, h, in);
  }
  return std::abs(std::atan2(cross(in, after.inFace), in.dot(after.inFace))) * 180 / kPi;
}

}  // namespace karcher
