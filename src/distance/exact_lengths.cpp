#include "distance/exact_lengths.h"

#include <algorithm>

#include "mesh/sorted_numbers.h"

namespace karcher {

void writeLengths(const Geometry& geometry, const WindowDistance& distance,
                  const Array<SurfacePoint>& points, Array<double>& lengths) {
  Array<const SourceImage*> images;
  for (const SourceImage& image : distance.images()) images.push_back(&image);
  sortItems(images, [](const SourceImage* a, const SourceImage* b) { return a->face < b->face; });
  for (int i = 0; i < points.count(); ++i) {
    const int face = points[i].face;
    const Vec2 place = pointInFace(geometry, points[i]);
    double length = kInfinity;
    const auto first =
        std::lower_bound(images.begin(), images.end(), face,
                         [](const SourceImage* image, int f) { return image->face < f; });
    for (auto image = first; image != images.end() && (*image)->face == face; ++image) {
      length = std::min(length, lengthFrom(**image, place));
    }
    for (int k = 0; k < 3; ++k) {
      const double way = (place - cornerInFace(geometry, face, k)).norm();
      length = std::min(length, distance.distance(geometry.mesh->corner(face, k)) + way);
    }
    lengths[i] = length;
  }
}

Array<double> exactLengths(const Geometry& geometry, const SurfacePoint& source,
                           const Array<SurfacePoint>& points, double likely) {
  Array<int> faces;
  for (const SurfacePoint& point : points) faces.push_back(point.face);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());

  WindowDistance distance(geometry);
  distance.keepImagesIn(faces);
  distance.setSource(source);
  distance.grow(likely);
  Array<double> lengths;
  lengths.assign(points.size(), 0);
  writeLengths(geometry, distance, points, lengths);
  const auto isBeyond = [&](double length) { return length > likely; };
  if (std::none_of(lengths.begin(), lengths.end(), isBeyond)) return lengths;
  // The length of any path to a point bounds the point's distance. So the search first reaches the
  // face of each point that has no path yet.
  for (int i = 0; i < points.count(); ++i) {
    if (lengths[i] == kInfinity) distance.growTo(geometry.mesh->corner(points[i].face, 0));
  }
  writeLengths(geometry, distance, points, lengths);
  double longest = likely;
  for (const double length : lengths) {
    if (length != kInfinity) longest = std::max(longest, length);
  }
  distance.grow(longest);
  writeLengths(geometry, distance, points, lengths);
  return lengths;
}

}  // namespace karcher
