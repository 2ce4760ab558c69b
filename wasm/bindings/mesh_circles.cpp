#include "bindings/curve_handle.h"
#include "bindings/field_options.h"
#include "bindings/mesh_handle.h"
#include "curves/circle.h"
#include "curves/isoline.h"

namespace karcher::bindings {
namespace {

val circleToJs(const MeshHandle& mesh, const GeodesicCircle& circle) {
  CurvePath line;
  line.path.closed = true;
  Array<const Array<CurveSample>*> segments;
  Array<const Array<Bridge>*> bridges;
  for (int j = 0; j < circle.samples.count(); ++j) {
    segments.push_back(&circle.samples[j]);
    bridges.push_back(&circle.bridges[j]);
    appendSegment(mesh, circle.paths[j], line);
  }
  val result = val::object();
  result.set("samples", samplesToJs(mesh, segments));
  result.set("bridged", bridgedToJs(bridges));
  result.set("path", toJs(line.path));
  result.set("unconverged", toJs(line.unconverged));
  result.set("notShortest", toJs(circle.notShortest));
  return result;
}

}  // namespace

val MeshHandle::circle(const val& center, double radius, int arcs, int samples, const val& field) {
  return circleToJs(*this, traceCircle(surface_, pointFromJs(numbering_, mesh(), center), radius,
                                       {arcs, samples, fieldOptionsFromJs(field)}));
}

val MeshHandle::ellipse(const val& center, double along, double across, const val& direction,
                        int arcs, int samples, const val& field) {
  const SurfacePoint point = pointFromJs(numbering_, mesh(), center);
  return circleToJs(
      *this, traceEllipse(surface_, point, along, across, directionInFace(point.face, direction),
                          {arcs, samples, fieldOptionsFromJs(field)}));
}

val MeshHandle::isolines(const val& center, double radius, bool exact, const val& field) {
  const SurfacePoint source = pointFromJs(numbering_, mesh(), center);
  const Array<Isoline> lines =
      exact ? exactIsolines(surface_.geometry(), source, radius)
            : linearIsolines(mesh(), distancesFromPoint(source, field), radius);
  val list = val::array();
  for (int i = 0; i < lines.count(); ++i) {
    const Isoline& line = lines[i];
    list.set(i, pathToJs(numbering_, mesh(), line.points, line.length, line.closed));
  }
  return list;
}

}  // namespace karcher::bindings
