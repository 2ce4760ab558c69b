#pragma once

#include <functional>

#include "peers/phong_projection.h"

/// A mesh embedded in eight dimensions, where straight lines are about as long as the shortest
/// paths on the surface: D. Panozzo, I. Baran, O. Diamanti, O. Sorkine-Hornung, "Weighted Averages
/// on Surfaces" (2013), section 3.5.
///
/// Landmarks, each as far as possible from those before, are placed by metric multidimensional
/// scaling of their geodesic distances. Between them the surface is as smooth as possible: the
/// least-squares mesh (O. Sorkine, D. Cohen-Or, "Least-squares meshes", 2004). If faces of it are
/// folded over, local refinement adds landmarks, placed among all others, and tries again.
namespace karcher {

/// Geodesic distances from a vertex to all vertices.
using DistancesFromVertex = std::function<Array<double>(int vertex)>;

struct EmbeddingOptions {
  int landmarks = 500;  ///< at least 4; all vertices if they are fewer
  int mostRefinements = 5;
  /// An embedding is refused with more folded faces, as a part of all,
  double mostFolded = 0.01;
  /// or with a larger root mean square of the relative errors of the landmarks' distances.
  double mostStress = 0.3;
};

struct Embedding {
  Array<EmbeddedPoint> positions;  ///< per vertex
  Array<TangentPlane> planes;      ///< per vertex
  int landmarks = 0;
  int foldedFaces = 0;
  double stress = 0;  ///< of the first landmarks, before refinement
};

/// Throws Error: kNoEmbedding if no acceptable embedding is found; kUnreachable (several
/// components), kBadArgument (too few landmarks, or not a distance a vertex), kDegenerateFace.
Embedding embedSurface(const Geometry& geometry, const DistancesFromVertex& distancesFrom,
                       const EmbeddingOptions& options = {});

}  // namespace karcher
