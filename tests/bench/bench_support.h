#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "generators/random_points.h"
#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"

/// Helpers that the benchmarks and studies share.
namespace karcher {

/// The text of a file. Throws std::runtime_error if it cannot be read.
std::string readFile(const std::string& path);

/// The mesh of an OBJ file, and the points of a points file (`face b1 b2` a line) in the mesh's own
/// numbering.
struct BenchMesh {
  TriangleMesh mesh;
  Array<SurfacePoint> points;
};
BenchMesh loadBenchMesh(const std::string& objPath, const std::string& pointsPath);

/// The mesh of an OBJ file, or of 20,000 triangles of the built-in shape of this name.
TriangleMesh studyMesh(const std::string& name);

/// A mesh's name in tables: that of the file, without folder and extension.
std::string meshName(const std::string& path);

/// Calls `study` for each mesh of a study: the files among the names, which end with .obj, or else
/// the meshes of the gallery (generators/gallery.h) whose names contain the first name, if there is
/// one.
void forEachMesh(const Array<std::string>& names,
                 const std::function<void(const std::string& name, const TriangleMesh& mesh,
                                          bool isFlat)>& visit);

/// The rows of three numbers of the next array with this name in a JSON text, from place `at` on,
/// which moves to the array's end. Throws std::runtime_error if the array is missing or has other
/// content.
Array<Vec3> readPositions(const std::string& json, const std::string& name, size_t& at);

inline double milliseconds() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

/// The milliseconds that `work` takes, measured once.
template <class Work>
double timed(const Work& work) {
  const double start = milliseconds();
  work();
  return milliseconds() - start;
}

/// The processor's milliseconds that the program has used: other programs do not count.
double processorMilliseconds();

template <class Work>
double processorTimed(const Work& work) {
  const double start = processorMilliseconds();
  work();
  return processorMilliseconds() - start;
}

double mean(const Array<double>& values);
double median(Array<double> values);
/// The value below which the part `rank` (0 to 1) of the values lies.
double quantile(Array<double> values, double rank);

}  // namespace karcher
