#pragma once

#include <stdexcept>
#include <string>

#include "fuzz/fuzz_bytes.h"
#include "intrinsic/surface_path.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"

/// Invariants of the engine for any input. Each check reads its case from bytes and accepts an
/// Error as an answer. It throws FuzzFinding for a violation, or an exception that the engine
/// should not throw. Fuzzers call them (fuzz/targets), and tests with the findings of fuzzers.
namespace karcher {

class FuzzFinding : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes are an OBJ file. The engine opens it, with and without repairs, or refuses it with a
/// sentence. An opened file is a mesh in the sense of `expectSoundMesh`.
void fuzzObj(Bytes bytes);

/// The bytes are vertices, many of them at the same place or nearly, any triangles of them, and the
/// options of repairs. The imported mesh is sound in the sense of `expectSoundMesh`, and points
/// keep their place. Distances are finite within a component, symmetric and no shorter than
/// straight lines. The mesh survives a file.
void fuzzRepairs(Bytes bytes);

/// The bytes are a mesh, control points, a kind, levels, and edits of that curve. All points are on
/// the surface, paths do not leave it, and after each edit the curve equals a new one. An edit that
/// is refused changes nothing. Shortest paths are as long in both directions.
void fuzzCurve(Bytes bytes);

/// Throws FuzzFinding unless the condition holds.
void expect(bool holds, const std::string& what);

/// Throws FuzzFinding unless an error has a printable sentence of readable length.
void expectSentence(const Error& error);

/// Throws FuzzFinding unless the adjacency matches the faces, indices are in range, and positions
/// are finite.
void expectSoundMesh(const ImportedMesh& imported);

/// Throws FuzzFinding unless the points are on the surface, consecutive ones in a common face, and
/// lengths finite and increasing.
void expectOnSurface(const TriangleMesh& mesh, const SurfacePath& path);
void expectOnSurface(const TriangleMesh& mesh, const SurfacePoint& point);

}  // namespace karcher
