#include "curves/polygon/piece_boxes.h"

#include <algorithm>

namespace karcher {
namespace {

/// Room around the faces of the pieces' legs, in the longest edges of the faces at their points: a
/// sample's face may reach out so far. With less, fields are read outside their boxes more often,
/// which costs more than smaller boxes spare.
constexpr double kRoom = 0.05;
/// In a box that is longer than twice this, in mean edges, fields are worth a fit.
constexpr double kLongest = 16;
/// Away from the surface, as a part of the longest side: there is nothing else to keep out, and the
/// surface may bend.
constexpr double kThickness = 0.5;

Vec3 normalOf(const TriangleMesh& mesh, int face) {
  const Vec3& a = mesh.positions[mesh.corner(face, 0)];
  const Vec3& b = mesh.positions[mesh.corner(face, 1)];
  const Vec3& c = mesh.positions[mesh.corner(face, 2)];
  return (b - a).cross(c - a);
}

/// What boxes are made of, each part once: the normals and longest edges at the points, and the
/// corners of the faces along each leg.
class Parts {
 public:
  Parts(const Geometry& geometry, const RefinedPolygon& refined, BoxWorkspace& workspace)
      : geometry_(geometry), mesh_(*geometry.mesh), workspace_(workspace) {
    workspace.normals.clear();
    workspace.longest.clear();
    for (const WeightedPoint& point : refined.points) addPoint(point.point.face);
    workspace.corners.clear();
    workspace.ofLegs.assign(1, 0);
    for (int leg = 0; leg < refined.legs.count(); ++leg) {
      lastFace_ = -1;
      addFace(refined.points[leg].point.face);
      for (const SurfacePoint& p : refined.legs[leg].points) addFace(p.face);
      addFace(refined.points[leg + 1 < refined.points.count() ? leg + 1 : 0].point.face);
      workspace.ofLegs.push_back(workspace.corners.count());
    }
  }

 private:
  void addPoint(int face) {
    workspace_.normals.push_back(normalOf(mesh_, face).normalized());
    double longest = 0;
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      longest = std::max(longest, geometry_.edgeLength[h]);
    }
    workspace_.longest.push_back(longest);
  }

  /// Faces along a leg have two corners in common.
  void addFace(int face) {
    if (face == lastFace_) return;
    for (int k = 0; k < 3; ++k) {
      const int corner = mesh_.corner(face, k);
      if (lastFace_ < 0 || !isCornerOf(lastFace_, corner)) {
        workspace_.corners.push_back(mesh_.positions[corner]);
      }
    }
    lastFace_ = face;
  }

  bool isCornerOf(int face, int vertex) const {
    return mesh_.corner(face, 0) == vertex || mesh_.corner(face, 1) == vertex ||
           mesh_.corner(face, 2) == vertex;
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  BoxWorkspace& workspace_;
  int lastFace_ = -1;
};

/// Grows over pieces, then becomes a box.
class Extent {
 public:
  Extent(const Geometry& geometry, BoxWorkspace& workspace)
      : geometry_(geometry), workspace_(workspace) {}

  void clear() {
    workspace_.legs.clear();
    normal_ = Vec3::Zero();
    longest_ = 0;
  }

  void add(const SegmentLayout& piece) {
    Array<int>& legs = workspace_.legs;
    for (int k = 0; k < piece.points.count(); ++k) {
      normal_ += workspace_.normals[piece.points[k]];
      longest_ = std::max(longest_, workspace_.longest[piece.points[k]]);
      if (k == 0) continue;
      // The pieces of a B-spline share most of their legs.
      const int leg = piece.points[k - 1];
      if (std::find(legs.begin(), legs.end(), leg) == legs.end()) legs.push_back(leg);
    }
  }

  /// Along the line from the point to what is farthest of it.
  std::optional<OrientedBox> box(const SurfacePoint& point) const {
    const Vec3 from = position(*geometry_.mesh, point);
    Vec3 along = Vec3::Zero();
    forEachCorner([&](const Vec3& p) {
      if ((p - from).squaredNorm() > along.squaredNorm()) along = p - from;
    });
    OrientedBox box;
    box.axes[0] = along.normalized();
    box.axes[1] = normal_.cross(along).normalized();
    box.axes[2] = box.axes[0].cross(box.axes[1]);
    if (!(box.axes[0].norm() > 0.5 && box.axes[1].norm() > 0.5)) return std::nullopt;
    Vec3 least = Vec3::Constant(kInfinity);
    Vec3 most = Vec3::Constant(-kInfinity);
    forEachCorner([&](const Vec3& p) {
      for (int k = 0; k < 3; ++k) {
        const double at = box.axes[k].dot(p);
        least[k] = std::min(least[k], at);
        most[k] = std::max(most[k], at);
      }
    });
    box.halfSize = (most - least) / 2 + Vec3::Constant(kRoom * longest_);
    if (box.halfSize[0] > kLongest * geometry_.meanEdge) return std::nullopt;
    box.halfSize[2] += kThickness * box.halfSize[0];
    for (int k = 0; k < 3; ++k) box.center += (least[k] + most[k]) / 2 * box.axes[k];
    return box;
  }

 private:
  template <class Work>
  void forEachCorner(const Work& work) const {
    for (const int leg : workspace_.legs) {
      const int end = workspace_.ofLegs[leg + 1];
      for (int i = workspace_.ofLegs[leg]; i < end; ++i) work(workspace_.corners[i]);
    }
  }

  const Geometry& geometry_;
  BoxWorkspace& workspace_;
  Vec3 normal_ = Vec3::Zero();
  double longest_ = 0;
};

/// The pieces that blend each point.
void listPieces(const RefinedPolygon& refined, BoxWorkspace& workspace) {
  Array<int>& begin = workspace.begin;
  begin.assign(refined.points.size() + 1, 0);
  for (const SegmentLayout& piece : refined.pieces) {
    for (const int point : piece.points) ++begin[point];
  }
  // The ends first: they go down to the begins as the pieces are put in.
  for (int i = 1; i < begin.count(); ++i) begin[i] += begin[i - 1];
  workspace.ofPoints.resize(static_cast<size_t>(begin.back()));
  for (int p = refined.pieces.count() - 1; p >= 0; --p) {
    for (const int point : refined.pieces[p].points) workspace.ofPoints[--begin[point]] = p;
  }
}

}  // namespace

void boxPieces(const Geometry& geometry, const RefinedPolygon& refined, BoxWorkspace& workspace,
               Array<std::optional<OrientedBox>>& boxes) {
  listPieces(refined, workspace);
  boxes.clear();
  const Parts parts(geometry, refined, workspace);
  Extent extent(geometry, workspace);
  for (int i = 0; i < refined.points.count(); ++i) {
    extent.clear();
    for (int k = workspace.begin[i]; k < workspace.begin[i + 1]; ++k) {
      extent.add(refined.pieces[workspace.ofPoints[k]]);
    }
    boxes.push_back(extent.box(refined.points[i].point));
  }
}

}  // namespace karcher
