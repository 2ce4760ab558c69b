#include "bindings/path.h"

#include "intrinsic/strip_path.h"

namespace karcher::bindings {

Array<int> append(Path& path, const Numbering& numbering, const TriangleMesh& mesh,
                  const Array<SurfacePoint>& points, double length) {
  Array<int> kept = pointsWithoutRepetitions(mesh, points);
  Array<double> chords;
  double whole = 0;
  Vec3 last = Vec3::Zero();
  for (const int i : kept) {
    const Vec3 here = position(mesh, points[i]);
    if (i > 0) whole += (here - last).norm();
    chords.push_back(whole);
    const SurfacePoint input = toInput(numbering, points[i]);
    path.faces.push_back(input.face);
    append(path.bary, input.bary);
    append(path.positions, here);
    last = here;
  }
  // Chords are shorter than arcs, and lengths have rounding errors. So all chords are stretched by
  // one factor, to the given length in total.
  const double stretch = whole > 0 ? length / whole : 0;
  for (const double chord : chords) path.lengths.push_back(path.length + stretch * chord);
  path.length += length;
  if (!kept.empty()) path.lengths.back() = path.length;
  return kept;
}

val toJs(const Path& path) {
  val result = val::object();
  result.set("closed", path.closed);
  result.set("length", path.length);
  result.set("face", toJs(path.faces));
  result.set("bary", toJs(path.bary));
  result.set("position", toJs(path.positions));
  result.set("lengths", toJs(path.lengths));
  return result;
}

val pathToJs(const Numbering& numbering, const TriangleMesh& mesh,
             const Array<SurfacePoint>& points, double length, bool closed) {
  Path path;
  path.closed = closed;
  append(path, numbering, mesh, points, length);
  return toJs(path);
}

}  // namespace karcher::bindings
