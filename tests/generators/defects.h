#pragma once

#include <array>
#include <cstdint>

#include "generators/random.h"
#include "mesh/mesh_import.h"

/// Meshes with the defects of files from the wild, made of sound ones.
namespace karcher {

enum class Defect {
  kOnALine,          ///< a triangle on a line fills a vertex in the middle of an edge
  kRepeatedCorner,   ///< a face with one vertex at two corners
  kDuplicate,        ///< a face twice
  kDuplicateTurned,  ///< a face, and the same turned over
  kTurnedOver,       ///< a face in the other direction
  kFin,              ///< a third face on an edge
  kBowTie,           ///< a tetrahedron that touches the surface at a vertex
  kShortEdge,        ///< two vertices at 1e-16 of the diagonal, with an edge
  kNotANumber,       ///< a vertex that is not finite, and that no face uses
  kSeams,            ///< every triangle with vertices of its own, moved by 1e-9 of the diagonal
};

inline constexpr std::array kDefects = {Defect::kOnALine,    Defect::kRepeatedCorner,
                                        Defect::kDuplicate,  Defect::kDuplicateTurned,
                                        Defect::kTurnedOver, Defect::kFin,
                                        Defect::kBowTie,     Defect::kShortEdge,
                                        Defect::kNotANumber, Defect::kSeams};

/// "a triangle on a line".
const char* defectName(Defect defect);

/// The repair that mends it.
Repair::Kind repairOf(Defect defect);

class DefectiveMesh {
 public:
  /// Of a closed mesh without defects.
  DefectiveMesh(TriangleSoup sound, uint64_t seed);

  /// Puts some of one kind in, apart from all others; kSeams goes last, and its count is of
  /// vertices. Returns how many there are: less than `count` where the mesh is too small.
  int add(Defect defect, int count);

  const TriangleSoup& soup() const { return soup_; }

 private:
  /// A vertex whose faces nothing has touched, and they are touched then; -1 where none was found.
  int takeVertex();
  /// A face with such a corner, its corners turned so that this is the first.
  int takeFace();
  void splitVertex(int v);
  void putOnALine(int f);
  int explode();

  TriangleMesh mesh_;
  TriangleSoup soup_;
  Array<uint8_t> taken_;
  Random random_;
  double diagonal_;
};

}  // namespace karcher
