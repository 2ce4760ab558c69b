#include "bindings/view.h"

#include <cstring>

#include "bindings/path.h"

namespace karcher::bindings {
namespace {

/// The vertices of the path. `unconverged` tells for each vertex whether the piece that ends there
/// is unconverged (JoinedPath).
struct Vertices {
  Path path;
  Array<uint8_t> unconverged;
};

Vertices verticesOf(const MeshHandle& mesh, const TracedLine& line) {
  Vertices result;
  for (const JoinedPath* segment : line.paths) {
    const Array<int> kept = append(result.path, mesh.numbering(), mesh.mesh(), segment->line.points,
                                   segment->line.length());
    for (const int i : kept) result.unconverged.push_back(segment->unconverged[i]);
  }
  return result;
}

template <class Number>
void put(Array<uint8_t>& bytes, const std::vector<Number>& numbers) {
  const size_t at = bytes.size();
  bytes.resize(at + numbers.size() * sizeof(Number));
  if (!numbers.empty()) std::memcpy(&bytes[at], numbers.data(), numbers.size() * sizeof(Number));
}

template <class... Arrays>
void putAll(Array<uint8_t>& bytes, const Arrays&... arrays) {
  (put(bytes, arrays), ...);
}

}  // namespace

ViewOptions viewOptionsFromJs(const val& options) {
  return {options["inDouble"].as<bool>(), options["withPoints"].as<bool>()};
}

val viewToJs(const MeshHandle& mesh, const TracedLine& line, const ViewOptions& options) {
  Array<double> t;
  Array<double> bary;
  Array<double> positions;
  Array<int> segments;
  Array<int> faces;
  Array<uint8_t> statuses;
  for (int j = 0; j < line.samples.count(); ++j) {
    for (const CurveSample& sample : *line.samples[j]) {
      const SurfacePoint input = toInput(mesh.numbering(), sample.point);
      t.push_back(sample.t);
      append(bary, input.bary);
      append(positions, position(mesh.mesh(), sample.point));
      segments.push_back(j);
      faces.push_back(input.face);
      statuses.push_back(static_cast<uint8_t>(sample.status));
    }
  }
  Array<double> from;
  Array<double> to;
  Array<int> bridged;
  Array<uint8_t> reasons;
  for (int j = 0; j < line.bridges.count(); ++j) {
    for (const Bridge& bridge : *line.bridges[j]) {
      from.push_back(bridge.t0);
      to.push_back(bridge.t1);
      bridged.push_back(j);
      reasons.push_back(static_cast<uint8_t>(bridge.reason));
    }
  }
  const Vertices vertices = verticesOf(mesh, line);
  const Path& path = vertices.path;
  Array<double> legs;
  Array<double> legBary;
  Array<int> legFaces;
  Array<int> legCounts;
  for (const SurfacePath* leg : line.legs) {
    for (const SurfacePoint& point : leg->points) {
      const SurfacePoint input = toInput(mesh.numbering(), point);
      append(legs, position(mesh.mesh(), point));
      append(legBary, input.bary);
      legFaces.push_back(input.face);
    }
    legCounts.push_back(leg->points.count());
  }
  const auto count = [](const auto& array) { return static_cast<double>(array.size()); };
  const double legPoints = count(legs) / 3;

  Array<uint8_t> bytes;
  put(bytes, std::vector<double>{count(path.lengths), count(t), count(from), count(line.knots),
                                 count(line.times), count(line.samples), path.length,
                                 line.closed ? 1.0 : 0.0, static_cast<double>(line.levels),
                                 options.inDouble ? 1.0 : 0.0, options.withPoints ? 1.0 : 0.0,
                                 count(legCounts), legPoints});
  putAll(bytes, line.times, line.knots, t, bary, positions, from, to, path.lengths, legBary);
  if (options.withPoints) put(bytes, path.bary);
  if (options.inDouble) {
    putAll(bytes, path.positions, legs);
  } else {
    putAll(bytes, std::vector<float>(path.positions.begin(), path.positions.end()),
           std::vector<float>(legs.begin(), legs.end()));
  }
  putAll(bytes, segments, faces, bridged, legCounts, legFaces);
  if (options.withPoints) put(bytes, path.faces);
  putAll(bytes, vertices.unconverged, statuses, reasons);
  return toJs(bytes);
}

}  // namespace karcher::bindings
