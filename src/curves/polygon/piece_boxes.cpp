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

/// Grows over pieces, then becomes a box.
class Extent {
 public:
  Extent(const Geometry& geometry, Array<Vec3>& positions)
      : geometry_(geometry), mesh_(*geometry.mesh), positions_(positions) {}

  void clear() {
    positions_.clear();
    last_ = nullptr;
    lastFace_ = -1;
    normal_ = Vec3::Zero();
    longest_ = 0;
  }

  void add(const RefinedPolygon& refined, const SegmentLayout& piece) {
    for (int k = 0; k < piece.points.count(); ++k) {
      const int face = refined.points[piece.points[k]].point.face;
      addFace(face);
      normal_ += normalOf(mesh_, face).normalized();
      for (int h = 3 * face; h < 3 * face + 3; ++h) {
        longest_ = std::max(longest_, geometry_.edgeLength[h]);
      }
      if (k > 0) addLeg(refined, piece.points[k - 1]);
    }
    last_ = &piece;
  }

  /// Along the line from the point to what is farthest of it.
  std::optional<OrientedBox> box(const SurfacePoint& point) const {
    const Vec3 from = position(mesh_, point);
    Vec3 along = Vec3::Zero();
    for (const Vec3& p : positions_) {
      if ((p - from).squaredNorm() > along.squaredNorm()) along = p - from;
    }
    OrientedBox box;
    box.axes[0] = along.normalized();
    box.axes[1] = normal_.cross(along).normalized();
    box.axes[2] = box.axes[0].cross(box.axes[1]);
    if (!(box.axes[0].norm() > 0.5 && box.axes[1].norm() > 0.5)) return std::nullopt;
    Vec3 least = Vec3::Constant(kInfinity);
    Vec3 most = Vec3::Constant(-kInfinity);
    for (const Vec3& p : positions_) {
      for (int k = 0; k < 3; ++k) {
        const double at = box.axes[k].dot(p);
        least[k] = std::min(least[k], at);
        most[k] = std::max(most[k], at);
      }
    }
    box.halfSize = (most - least) / 2 + Vec3::Constant(kRoom * longest_);
    if (box.halfSize[0] > kLongest * geometry_.meanEdge) return std::nullopt;
    box.halfSize[2] += kThickness * box.halfSize[0];
    for (int k = 0; k < 3; ++k) box.center += (least[k] + most[k]) / 2 * box.axes[k];
    return box;
  }

 private:
  void addLeg(const RefinedPolygon& refined, int leg) {
    // The pieces of a B-spline share most of their legs.
    const bool isThere = last_ && std::find(last_->points.begin(), last_->points.end() - 1, leg) !=
                                      last_->points.end() - 1;
    if (isThere) return;
    for (const SurfacePoint& p : refined.legs[leg].points) addFace(p.face);
  }

  /// Faces along a leg have two corners in common.
  void addFace(int face) {
    if (face == lastFace_) return;
    for (int k = 0; k < 3; ++k) {
      const int corner = mesh_.corner(face, k);
      if (lastFace_ < 0 || !isCornerOf(lastFace_, corner)) {
        positions_.push_back(mesh_.positions[corner]);
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
  Array<Vec3>& positions_;
  const SegmentLayout* last_ = nullptr;
  int lastFace_ = -1;
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
  Extent extent(geometry, workspace.positions);
  for (int i = 0; i < refined.points.count(); ++i) {
    extent.clear();
    for (int k = workspace.begin[i]; k < workspace.begin[i + 1]; ++k) {
      extent.add(refined, refined.pieces[workspace.ofPoints[k]]);
    }
    boxes.push_back(extent.box(refined.points[i].point));
  }
}

}  // namespace karcher
