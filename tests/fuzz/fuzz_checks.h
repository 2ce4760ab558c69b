#pragma once

#include <stdexcept>
#include <string>

#include "fuzz/fuzz_bytes.h"
#include "intrinsic/surface_path.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"

/// What must hold of the engine whatever it is given. Each check reads its case from bytes, takes
/// an Error for an answer, and throws FuzzFinding, or what the engine should not have thrown, where
/// something is wrong. Fuzzers call them (fuzz/targets), and tests with what fuzzers have found.
namespace karcher {

class FuzzFinding : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes are an OBJ file: it is opened, with and without repairs, or refused with a sentence;
/// what was opened is a mesh as `expectSoundMesh` has it.
void fuzzObj(Bytes bytes);

/// The bytes are vertices, many of them at the same place or nearly, any triangles of them, and the
/// options of repairs. What is opened is a mesh as `expectSoundMesh` has it, points keep their
/// place, distances are finite within a component, symmetric and no shorter than straight lines,
/// and the mesh can be saved and opened again.
void fuzzRepairs(Bytes bytes);

/// The bytes are a mesh, control points, a kind, levels, and edits of that curve. All points are on
/// the surface, paths do not leave it, and after each edit the curve is the one made anew; an edit
/// that is refused changes nothing. Shortest paths are as long in both directions.
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
