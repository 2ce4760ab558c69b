#pragma once

#include <functional>

#include "peers/phong_projection.h"

/// A mesh embedded in eight dimensions, where straight lines are about as long as the shortest
/// paths on the surface: D. Panozzo, I. Baran, O. Diamanti, O. Sorkine-Hornung, "Weighted Averages
/// on Surfaces" (2013), section 3.5.
///
/// Landmarks, each as far as possible from the earlier ones, are placed by metric multidimensional
/// scaling of their geodesic distances. Between them the surface is as smooth as possible: the
/// least-squares mesh (O. Sorkine, D. Cohen-Or, "Least-squares meshes", 2004). If some of its faces
/// are folded over, local refinement adds landmarks, places them among all others, and tries again.
namespace karcher {

/// A function that returns the geodesic distances from a vertex to all vertices.
using DistancesFromVertex = std::function<Array<double>(int vertex)>;

struct EmbeddingOptions {
  int landmarks = 500;  ///< the number of landmarks, at least 4; all vertices if the mesh has fewer
  int mostRefinements = 5;
  /// The largest share of folded faces in an embedding that is accepted.
  double mostFolded = 0.01;
  /// The largest root mean square of the relative errors of the landmarks' distances in an
  /// embedding that is accepted.
  double mostStress = 0.3;
};

struct Embedding {
  Array<EmbeddedPoint> positions;  ///< the position of each vertex
  Array<TangentPlane> planes;      ///< the tangent plane of each vertex
  int landmarks = 0;
  int foldedFaces = 0;
  double stress = 0;  ///< the stress of the first landmarks, before refinement
};

/// Throws Error: kNoEmbedding if no acceptable embedding is found; kUnreachable (several
/// components), kBadArgument (too few landmarks, or not one distance for each vertex),
/// kDegenerateFace.
Embedding embedSurface(const Geometry& geometry, const DistancesFromVertex& distancesFrom,
                       const EmbeddingOptions& options = {});

}  // namespace karcher
