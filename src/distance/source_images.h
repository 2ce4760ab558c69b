#pragma once

#include <algorithm>
#include <utility>

#include "distance/window.h"
#include "intrinsic/geometry.h"

namespace karcher {

/// An image of the source in the plane of a face: the source itself or a vertex at which paths
/// turn, unfolded across the edges that straight paths into the face cross. Coordinates are in the
/// frame of the face.
struct SourceImage {
  int face = -1;
  Vec2 source = Vec2::Zero();
  double offset = 0;      ///< the distance of the point that the image represents
  int pseudoSource = -1;  ///< this point if it is a vertex, else -1
  /// The paths lie in a sector, counterclockwise from the unit vector `right` to `left`. If
  /// `isFull`, the source itself lies in the face, and paths leave it in all directions.
  Vec2 right = Vec2(1, 0);
  Vec2 left = Vec2(1, 0);
  bool isFull = false;
};

/// The length of the path from the source, by way of an image, to a point of the image's face. The
/// point is in the face's frame. The length is kInfinity if the image does not see the point.
double lengthFrom(const SourceImage& image, const Vec2& point);

/// The images with paths to points at one distance from the source, or to points of given faces.
class SourceImages {
 public:
  /// The geometry must outlive the object.
  explicit SourceImages(const Geometry& geometry) : geometry_(geometry) {}

  /// Keeps, from now on, images for points at this distance.
  void keep(double distance) {
    distance_ = distance;
    faces_.clear();
  }
  /// Keeps, from now on, all images in these faces.
  void keepIn(Array<int> faces) {
    distance_ = kInfinity;
    faces_ = std::move(faces);
    std::sort(faces_.begin(), faces_.end());
  }
  bool areKept() const { return distance_ >= 0; }
  void clear() { images_.clear(); }
  const Array<SourceImage>& all() const { return images_; }

  /// Adds the source itself as an image in a face that contains it.
  void addSource(int face, const SurfacePoint& source);
  /// Adds the sources of windows that cross the face of half-edge h, if the face may have points at
  /// the distance. Keeps even an image that gives smaller distances in the whole face: it shows
  /// that points to which another image gives this distance are nearer. Omits windows that start
  /// beyond the distance. `tailDistance` is the distance of h's tail.
  void addWindows(int h, const Array<Window>& windows, double tailDistance);
  /// Adds the tail of half-edge h, a vertex at `distance` from the source that sends out paths.
  /// These leave in the corner of h between the angles `from` and `to`, measured from h.
  void addCorner(int h, double distance, double from, double to);

 private:
  /// Whether no point of a face is relevant. The distances of its points lie between `nearest` and
  /// `farthest`.
  bool isNotAsked(int face, double nearest, double farthest) const {
    if (!faces_.empty()) return !std::binary_search(faces_.begin(), faces_.end(), face);
    return nearest > distance_ || farthest < distance_;
  }

  const Geometry& geometry_;
  double distance_ = -1;  ///< the distance; -1 to keep no images
  Array<int> faces_;      ///< sorted faces; empty if the distance decides
  Array<SourceImage> images_;
};

}  // namespace karcher
