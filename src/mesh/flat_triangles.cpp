#include "mesh/flat_triangles.h"

#include <algorithm>

namespace karcher {
namespace {

class Flips {
 public:
  Flips(const Array<Vec3>& positions, WorkFaces& faces) : positions_(positions), faces_(faces) {}

  int run() {
    Array<int> flat;
    for (int f = 0; f < faces_.count(); ++f) {
      if (isFlat(f)) flat.push_back(f);
    }
    if (flat.empty()) return 0;
    const int found = flat.count();
    const int whole = faces_.count();
    alive_.assign(faces_.corners.size(), 1);
    first_.assign(positions_.size(), -1);
    if (faces_.part.empty()) faces_.part.assign(faces_.corners.size(), -1);
    for (int f = 0; f < whole; ++f) enter(f);
    // Each flip removes a longest edge, so that only rounding could make the loop endless.
    const int most = 100 * (flat.count() + 10);
    for (int i = 0; i < flat.count() && i < most; ++i) flip(flat[i], flat);
    faces_.leaveOut([&](int f) { return !alive_[f]; });
    return found;
  }

 private:
  const Vec3& place(int v) const { return positions_[v]; }

  bool isFlat(int f) const {
    const Triangle& t = faces_.corners[f];
    return isDegenerate(place(t[0]), place(t[1]), place(t[2]));
  }

  /// Enters face f in the lists of its corners.
  void enter(int f) {
    for (int k = 0; k < 3; ++k) {
      int& first = first_[faces_.corners[f][k]];
      next_.push_back(first);
      first = 3 * f + k;
    }
  }

  void flip(int f, Array<int>& flat) {
    if (!alive_[f]) return;
    const Triangle t = faces_.corners[f];
    int longest = 0;
    double length = -1;
    for (int k = 0; k < 3; ++k) {
      const double other = (place(t[(k + 1) % 3]) - place(t[k])).squaredNorm();
      if (other > length) {
        length = other;
        longest = k;
      }
    }
    const int a = t[longest];
    const int b = t[(longest + 1) % 3];
    const int c = t[(longest + 2) % 3];
    const Vec3 along = place(b) - place(a);
    const double s = std::clamp((place(c) - place(a)).dot(along) / length, 0.0, 1.0);
    alive_[f] = 0;
    Array<int> across;
    for (int h = first_[a]; h >= 0; h = next_[h]) {
      const int g = h / 3;
      const Triangle& corners = faces_.corners[g];
      if (alive_[g] && (corners.array() == b).any()) across.push_back(g);
    }
    for (const int g : across) cut(g, a, b, c, s, flat);
  }

  /// Cuts face g in two. The cut leads from the face's third corner to c, which lies on the edge
  /// from a to b at the ratio s of the way.
  void cut(int g, int a, int b, int c, double s, Array<int>& flat) {
    const Triangle corners = faces_.corners[g];
    alive_[g] = 0;
    // A face that also has the corner c has no area either, so it only disappears.
    if ((corners.array() == c).any()) return;
    const std::array<Vec3, 3> weights = faces_.weightsOf(g);
    int atA = 0;
    int atB = 0;
    for (int k = 0; k < 3; ++k) {
      if (corners[k] == a) atA = k;
      if (corners[k] == b) atB = k;
    }
    const Vec3 middle =
        (1 - s) * weights[static_cast<size_t>(atA)] + s * weights[static_cast<size_t>(atB)];
    for (const int k : {atB, atA}) {
      const int part = faces_.count();
      faces_.corners.push_back(corners);
      faces_.corners.back()[k] = c;
      faces_.source.push_back(faces_.source[g]);
      faces_.part.push_back(faces_.weights.count());
      faces_.weights.push_back(weights);
      faces_.weights.back()[static_cast<size_t>(k)] = middle;
      alive_.push_back(1);
      enter(part);
      if (isFlat(part)) flat.push_back(part);
    }
  }

  const Array<Vec3>& positions_;
  WorkFaces& faces_;
  Array<uint8_t> alive_;  ///< whether each face exists
  Array<int> first_;      ///< the first corner 3 f + k in the list of each vertex
  Array<int> next_;       ///< for each corner, the next one at the same vertex
};

}  // namespace

int flipFlatTriangles(const Array<Vec3>& positions, WorkFaces& faces) {
  return Flips(positions, faces).run();
}

}  // namespace karcher
