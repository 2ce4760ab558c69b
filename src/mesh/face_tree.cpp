#include "mesh/face_tree.h"

#include <algorithm>
#include <cmath>

#include "mesh/nearest_in_triangle.h"
#include "mesh/positions.h"

namespace karcher {
namespace {

constexpr int kFacesInLeaf = 4;

}  // namespace

FaceTree::FaceTree(const TriangleMesh& mesh) : mesh_(mesh) {
  while (leaves_ * kFacesInLeaf < mesh.faceCount()) leaves_ *= 2;
  boxes_.resize(2 * static_cast<size_t>(leaves_));
  for (int face = 0; face < mesh.faceCount(); ++face) {
    Box& box = boxes_[leaves_ + face / kFacesInLeaf];
    for (int k = 0; k < 3; ++k) {
      const Vec3& corner = mesh.positions[mesh.corner(face, k)];
      box.low = box.low.cwiseMin(corner);
      box.high = box.high.cwiseMax(corner);
    }
  }
  for (int node = leaves_ - 1; node > 0; --node) {
    boxes_[node].low = boxes_[2 * node].low.cwiseMin(boxes_[2 * node + 1].low);
    boxes_[node].high = boxes_[2 * node].high.cwiseMax(boxes_[2 * node + 1].high);
  }
}

FaceTree::Nearest FaceTree::nearest(const Vec3& place) const {
  checkPlace(place);
  Nearest best;
  search(1, place, best);
  return best;
}

/// The recursion is as deep as the tree: some twenty levels.
void FaceTree::search(int node, const Vec3& place, Nearest& best) const {
  if (node >= leaves_) {
    const int first = (node - leaves_) * kFacesInLeaf;
    const int end = std::min(first + kFacesInLeaf, mesh_.faceCount());
    for (int face = first; face < end; ++face) {
      const auto corner = [&](int k) { return mesh_.positions[mesh_.corner(face, k)]; };
      const Vec3 bary = nearestInTriangle(place, corner(0), corner(1), corner(2));
      const Vec3 at = bary[0] * corner(0) + bary[1] * corner(1) + bary[2] * corner(2);
      const double distance = (at - place).norm();
      if (distance > best.distance) continue;
      if (distance == best.distance && face > best.face) continue;
      best = {face, bary, distance};
    }
    return;
  }
  int near = 2 * node;
  int far = near + 1;
  double toNear = squaredDistance(near, place);
  double toFar = squaredDistance(far, place);
  if (toFar < toNear) {
    std::swap(near, far);
    std::swap(toNear, toFar);
  }
  // A square of the rounded distance could be less than that of an equally distant box.
  if (std::sqrt(toNear) <= best.distance) search(near, place, best);
  if (std::sqrt(toFar) <= best.distance) search(far, place, best);
}

/// The squared distance of a place from a node's box; kInfinity for a box without faces.
double FaceTree::squaredDistance(int node, const Vec3& place) const {
  const Box& box = boxes_[node];
  if (box.low.x() > box.high.x()) return kInfinity;
  return (place - place.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

}  // namespace karcher
