#include "bench_support.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "generators/gallery.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"

namespace karcher {

std::string readFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

BenchMesh loadBenchMesh(const std::string& objPath, const std::string& pointsPath) {
  ImportedMesh imported = importObj(readFile(objPath));
  BenchMesh result;
  if (!pointsPath.empty()) {
    std::istringstream lines(readFile(pointsPath));
    int face = 0;
    double b1 = 0;
    double b2 = 0;
    while (lines >> face >> b1 >> b2) {
      const int engineFace = imported.numbering.engineFace[face];
      result.points.push_back(checkedPoint(imported.mesh, engineFace, {1 - b1 - b2, b1, b2}));
    }
  }
  result.mesh = std::move(imported.mesh);
  return result;
}

TriangleMesh studyMesh(const std::string& name) {
  constexpr int kShapeTriangles = 20'000;
  for (const Shape shape : kShapes) {
    if (name != shapeName(shape)) continue;
    TriangleSoup soup = makeShape(shape, kShapeTriangles);
    return buildMesh(std::move(soup.positions), std::move(soup.triangles));
  }
  return loadBenchMesh(name, "").mesh;
}

std::string meshName(const std::string& path) {
  const std::string file = path.substr(path.rfind('/') + 1);
  return file.substr(0, file.rfind('.'));
}

void forEachMesh(const Array<std::string>& names,
                 const std::function<void(const std::string& name, const TriangleMesh& mesh,
                                          bool isFlat)>& visit) {
  bool isOfFiles = false;
  for (const std::string& name : names) {
    if (!name.ends_with(".obj")) continue;
    isOfFiles = true;
    visit(name.substr(name.rfind('/') + 1), loadBenchMesh(name, "").mesh, false);
  }
  if (isOfFiles) return;
  const std::string part = names.empty() ? "" : names[0];
  for (const GalleryMesh& example : gallery()) {
    if (example.name.find(part) == std::string::npos) continue;
    visit(example.name, buildMesh(example.soup.positions, example.soup.triangles), example.isFlat);
  }
}

Array<Vec3> readPositions(const std::string& json, const std::string& name, size_t& at) {
  Array<Vec3> positions;
  at = json.find('"' + name + '"', at);
  if (at == std::string::npos) throw std::runtime_error("the file has no " + name);
  at = json.find('[', at) + 1;
  const size_t end = json.find("]]", at);
  while ((at = json.find('[', at)) < end) {
    Vec3& p = positions.emplace_back();
    if (std::sscanf(json.c_str() + at, "[%lf, %lf, %lf]", &p[0], &p[1], &p[2]) != 3) {
      throw std::runtime_error("a row of " + name + " is not three numbers");
    }
    ++at;
  }
  at = end;
  return positions;
}

double processorMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double quantile(Array<double> values, double rank) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[static_cast<int>(rank * (values.count() - 1) + 0.5)];
}

double mean(const Array<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / values.count();
}

double median(Array<double> values) { return quantile(std::move(values), 0.5); }

}  // namespace karcher
