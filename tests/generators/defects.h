#pragma once

#include <array>
#include <cstdint>

#include "generators/random.h"
#include "mesh/mesh_import.h"

/// Meshes with the defects of real files, created from sound meshes.
namespace karcher {

enum class Defect {
  kOnALine,          ///< a triangle on a line, which fills a vertex in the middle of an edge
  kRepeatedCorner,   ///< a face with one vertex at two corners
  kDuplicate,        ///< a repeated face
  kDuplicateTurned,  // a face and its reversed copy
  kTurnedOver,       // a face with the opposite orientation
  kFin,              ///< a third face on an edge
  kBowTie,           ///< a tetrahedron that touches the surface at a vertex
  kShortEdge,        ///< two vertices at 1e-16 of the diagonal, with an edge
  kNotANumber,       ///< a vertex that is not finite, outside all faces
  kSeams,            // separate vertices for every triangle, moved by 1e-9 of the diagonal
};

inline constexpr std::array kDefects = {Defect::kOnALine,    Defect::kRepeatedCorner,
                                        Defect::kDuplicate,  Defect::kDuplicateTurned,
                                        Defect::kTurnedOver, Defect::kFin,
                                        Defect::kBowTie,     Defect::kShortEdge,
                                        Defect::kNotANumber, Defect::kSeams};

/// The defect's name, such as "a triangle on a line".
const char* defectName(Defect defect);

/// The repair of the defect.
Repair::Kind repairOf(Defect defect);

class DefectiveMesh {
 public:
  /// Starts with a closed mesh without defects.
  DefectiveMesh(TriangleSoup sound, uint64_t seed);

  /// Inserts up to `count` defects of one kind, apart from all others, and returns their number,
  /// which is smaller if the mesh has no room. kSeams must come last; it ignores `count`, and
  /// returns the number of vertices that it adds.
  int add(Defect defect, int count);

  const TriangleSoup& soup() const { return soup_; }

 private:
  /// A vertex with untouched faces, which this call marks as touched; -1 if none remains.
  int takeVertex();
  /// An untouched face with such a vertex, rotated so that the vertex comes first.
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
