#pragma once

#include "peers/vector_heat.h"

/// The affine heat method: Y. Soliman, N. Sharp, "The Affine Heat Method", Computer Graphics Forum
/// 44 (2025), the successor of the vector heat method for log maps. Heat transports positions
/// instead of directions. Each vertex sees the source as a point of its own tangent plane, in
/// homogeneous coordinates (v, u). Transport along an edge rotates such a point and translates it
/// by the edge. The heat starts at the source, as the origin of the source's plane. At each vertex
/// that the heat (v, u) reaches, the logarithm is v / u, turned back by a transported frame. The
/// method needs no Poisson equation and is exact on the plane.
///
/// The 3 n x 3 n operator of the paper is block triangular: u is ordinary heat, and v is heat of
/// vectors with a source that u determines. So both variants need only the factors of the vector
/// heat method, not a factor of the unsymmetric operator. The adaptive variant would need one such
/// factor for each source.
namespace karcher {

enum class AffineVariant {
  kLocal,     ///< rotates positions along edges by the connection
  kAdaptive,  ///< rotates positions into the frame transported from the source, which is more
              ///< accurate near the cut locus
};

/// The log map from a vertex, in the vertex's rescaled frame. The local variant solves two systems
/// of vectors and one of scalars; the adaptive variant solves one of vectors and three of scalars.
LogMap affineHeatLogMap(const HeatOperators& operators, int vertex, AffineVariant variant);

}  // namespace karcher
