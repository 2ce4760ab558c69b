#include "fuzz/fuzz_checks.h"

#include <cmath>

#include "intrinsic/strip_path.h"

namespace karcher {

void expect(bool holds, const std::string& what) {
  if (!holds) throw FuzzFinding(what);
}

void expectSentence(const Error& error) {
  const std::string sentence = error.what();
  expect(!sentence.empty() && sentence.size() < 500, "an error of no readable length");
  for (const char c : sentence) {
    const auto code = static_cast<unsigned char>(c);
    expect(code >= ' ' && code != 127, "an error with control characters: " + sentence);
  }
}

void expectSoundMesh(const ImportedMesh& imported) {
  const TriangleMesh& mesh = imported.mesh;
  const Numbering& numbering = imported.numbering;
  expect(mesh.faceCount() > 0, "a mesh without faces");
  for (const Vec3& p : mesh.positions) expect(p.allFinite(), "a position that is not finite");
  expect(std::isfinite(boundingBoxDiagonal(mesh)), "a diagonal that is not finite");
  // `buildMesh` throws if the faces form no surface.
  const TriangleMesh again = buildMesh(mesh.positions, mesh.faces);
  expect(again.twin == mesh.twin && again.onBoundary == mesh.onBoundary,
         "adjacency that is not that of the faces");
  expect(numbering.inputVertex.count() == mesh.vertexCount() &&
             numbering.inputFace.count() == mesh.faceCount(),
         "a numbering of another mesh");
  for (const int v : numbering.inputVertex) {
    expect(v >= 0 && v < numbering.engineVertex.count(), "no such input vertex");
  }
  for (const int f : numbering.inputFace) {
    expect(f >= 0 && f < numbering.inputFaceCount(), "no such input triangle");
  }
  for (const Repair& repair : imported.repairs) {
    expect(repair.count > 0 && !repair.sentence.empty(), "a repair of nothing");
  }
}

void expectOnSurface(const TriangleMesh& mesh, const SurfacePoint& point) {
  expect(point.face >= 0 && point.face < mesh.faceCount() && point.bary.minCoeff() >= 0 &&
             std::abs(point.bary.sum() - 1) <= 1e-12,
         "a point is not on the surface");
}

void expectOnSurface(const TriangleMesh& mesh, const SurfacePath& path) {
  expect(!path.points.empty() && path.points.size() == path.lengths.size(), "a path of no points");
  for (int i = 0; i < path.points.count(); ++i) {
    expectOnSurface(mesh, path.points[i]);
    expect(std::isfinite(path.lengths[i]), "a length that is not finite");
    if (i == 0) continue;
    expect(haveCommonFace(mesh, path.points[i - 1], path.points[i]), "a path leaves its faces");
    expect(path.lengths[i] >= path.lengths[i - 1], "lengths along a path go down");
  }
}

}  // namespace karcher
