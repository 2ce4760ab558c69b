#include "bindings/field_options.h"
#include "bindings/path.h"
#include "bindings/view.h"
#include "curves/circle.h"
#include "curves/isoline.h"

namespace karcher::bindings {
namespace {

val circleToJs(const MeshHandle& mesh, const GeodesicCircle& circle) {
  TracedLine line;
  line.closed = true;
  line.levels = circle.levels;
  for (int j = 0; j < circle.samples.count(); ++j) {
    line.samples.push_back(&circle.samples[j]);
    line.bridges.push_back(&circle.bridges[j]);
    line.paths.push_back(&circle.paths[j]);
  }
  val result = val::object();
  result.set("view", viewToJs(mesh, line, {.inDouble = true, .withPoints = true}));
  result.set("notShortest", toJs(circle.notShortest));
  if (circle.deviation) result.set("deviation", *circle.deviation);
  return result;
}

std::optional<int> arcsFromJs(const val& arcs) {
  if (arcs.isUndefined()) return {};
  return arcs.as<int>();
}

}  // namespace

val MeshHandle::circle(const val& center, double radius, const val& arcs, int samples, int levels,
                       const val& field, double tolerance) {
  return circleToJs(*this, traceCircle(surface_, pointFromJs(numbering_, mesh(), center), radius,
                                       {arcsFromJs(arcs), samples, fieldOptionsFromJs(field),
                                        levels, tolerance}));
}

val MeshHandle::ellipse(const val& center, double along, double across, const val& direction,
                        const val& arcs, int samples, int levels, const val& field) {
  const SurfacePoint point = pointFromJs(numbering_, mesh(), center);
  return circleToJs(
      *this, traceEllipse(surface_, point, along, across, directionInFace(point.face, direction),
                          {arcsFromJs(arcs), samples, fieldOptionsFromJs(field), levels}));
}

val MeshHandle::isolines(const val& center, double radius, bool exact, const val& field) {
  const SurfacePoint source = pointFromJs(numbering_, mesh(), center);
  const Array<Isoline> lines =
      exact ? exactIsolines(surface_.geometry(), source, radius)
            : linearIsolines(mesh(), distancesFromPoints({source}, field, kInfinity), radius);
  val list = val::array();
  for (int i = 0; i < lines.count(); ++i) {
    const Isoline& line = lines[i];
    list.set(i, pathToJs(numbering_, mesh(), line.points, line.length, line.closed));
  }
  return list;
}

}  // namespace karcher::bindings
