#pragma once

#include <functional>

#include "peers/phong_projection.h"

/// A mesh embedded in eight dimensions, where straight lines are about as long as the shortest
/// paths on the surface: D. Panozzo, I. Baran, O. Diamanti, O. Sorkine-Hornung, "Weighted Averages
/// on Surfaces" (2013), section 3.5. The method chooses landmarks, each as far as possible from the
/// earlier ones, and places them by metric multidimensional scaling of their geodesic distances.
/// Between the landmarks the surface is as smooth as possible: the least-squares mesh (O. Sorkine,
/// D. Cohen-Or, "Least-squares meshes", 2004). If some of its faces fold over, local refinement
/// adds landmarks, places them among all others, and tries again.
namespace karcher {

/// A function that returns the geodesic distances from a vertex to all vertices.
using DistancesFromVertex = std::function<Array<double>(int vertex)>;

struct EmbeddingOptions {
  int landmarks = 500;  ///< the number of landmarks, at least 4; all vertices if the mesh has fewer
  int mostRefinements = 5;
  /// The largest share of folded faces in an acceptable embedding.
  double mostFolded = 0.01;
  /// The largest root mean square of the relative errors of the landmarks' distances in an
  /// acceptable embedding.
  double mostStress = 0.3;
};

struct Embedding {
  Array<EmbeddedPoint> positions;  ///< the position of each vertex
  Array<TangentPlane> planes;      ///< the tangent plane of each vertex
  int landmarks = 0;
  int foldedFaces = 0;
  double stress = 0;  ///< the stress of the first landmarks, before refinement
};

/// The embedding of a surface. Throws Error: kNoEmbedding if no embedding is acceptable;
/// kUnreachable (several components), kBadArgument (too few landmarks, or not one distance for each
/// vertex), kDegenerateFace.
Embedding embedSurface(const Geometry& geometry, const DistancesFromVertex& distancesFrom,
                       const EmbeddingOptions& options = {});

}  // namespace karcher
