#include "distance/source_images.h"

#include <algorithm>

#include "mesh/rounding.h"

namespace karcher {

double lengthFrom(const SourceImage& image, const Vec2& point) {
  const Vec2 toPoint = point - image.source;
  const double leg = toPoint.norm();
  // The directions of the sector's sides have rounding errors.
  const bool isSeen =
      image.isFull || (cross(image.right, toPoint) >= -kChainRounding * leg &&
                       cross(toPoint, image.left) >= -kChainRounding * leg &&
                       (image.right + image.left).dot(toPoint) >= -kChainRounding * leg);
  return isSeen ? image.offset + leg : kInfinity;
}

void SourceImages::addSource(int face, const SurfacePoint& source) {
  SourceImage image;
  image.face = face;
  image.source = pointInFace(geometry_, source);
  image.isFull = true;
  images_.push_back(image);
}

void SourceImages::addWindows(int h, const Array<Window>& windows, double tailDistance) {
  const double diameter = std::max(
      {geometry_.edgeLength[h], geometry_.edgeLength[next(h)], geometry_.edgeLength[previous(h)]});
  if (isNotAsked(faceOf(h), 0, tailDistance + diameter)) return;
  const Vec2 along = halfedgeInFace(geometry_, h) / geometry_.edgeLength[h];
  const Vec2 origin = cornerInFace(geometry_, faceOf(h), cornerOf(h));
  for (const Window& window : windows) {
    if (leastDistance(window) > distance_) continue;
    const Vec2 source(window.sourceX, -window.depth);
    const Vec2 toEnd = Vec2(window.end, 0) - source;
    const Vec2 toBegin = Vec2(window.begin, 0) - source;
    images_.push_back({faceOf(h), origin + rotate(along, source), window.offset,
                       window.pseudoSource, rotate(along, toEnd.normalized()),
                       rotate(along, toBegin.normalized()), false});
  }
}

void SourceImages::addCorner(int h, double distance, double from, double to) {
  const double longest = std::max(geometry_.edgeLength[h], geometry_.edgeLength[previous(h)]);
  if (isNotAsked(faceOf(h), distance, distance + longest)) return;
  const Vec2 along = halfedgeInFace(geometry_, h) / geometry_.edgeLength[h];
  images_.push_back({faceOf(h), cornerInFace(geometry_, faceOf(h), cornerOf(h)), distance,
                     geometry_.mesh->tail(h), rotate(along, unitVector(std::max(from, 0.0))),
                     rotate(along, unitVector(std::min(to, geometry_.cornerAngle[h]))), false});
}

}  // namespace karcher
