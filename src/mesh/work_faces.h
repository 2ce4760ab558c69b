#pragma once

#include "mesh/numbering.h"
#include "mesh/triangle_soup.h"

namespace karcher {

/// The faces of a file during its repair. Vertices keep the file's numbers; welded vertices all
/// have the smallest of their numbers.
struct WorkFaces {
  Array<Triangle> corners;
  Array<int> source;  ///< the input triangle that contains each face
  /// For each face, the index of its corners' weights in `weights`; -1 if the face is the whole
  /// input triangle. The array is empty if all faces are whole.
  Array<int> part;
  Array<std::array<Vec3, 3>> weights;

  int count() const { return corners.count(); }
  bool isWhole(int f) const { return part.empty() || part[f] < 0; }
  /// The weights of a face's corners in its input triangle.
  std::array<Vec3, 3> weightsOf(int f) const {
    if (isWhole(f)) return {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    return weights[part[f]];
  }
  /// Replaces every corner by number[corner].
  void renumber(const Array<int>& number) {
    for (Triangle& t : corners) t = {number[t[0]], number[t[1]], number[t[2]]};
  }
  /// Omits the faces f for which gone(f) is true.
  template <class Gone>
  void leaveOut(Gone&& gone) {
    int kept = 0;
    for (int f = 0; f < count(); ++f) {
      if (gone(f)) continue;
      corners[kept] = corners[f];
      source[kept] = source[f];
      if (!part.empty()) part[kept] = part[f];
      ++kept;
    }
    corners.resize(static_cast<size_t>(kept));
    source.resize(static_cast<size_t>(kept));
    if (!part.empty()) part.resize(static_cast<size_t>(kept));
  }
};

/// Whether two corners are the same vertex.
inline bool hasRepeatedCorner(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

}  // namespace karcher
