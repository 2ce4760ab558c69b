#pragma once

/// The engine's public header: `#include <karcher/karcher.h>`. Headers that it does not include,
/// directly or indirectly, are internal and not installed.

// Meshes: reading, repair, shapes, subdivision, nearest points.
#include "mesh/error.h"
#include "mesh/face_tree.h"
#include "mesh/loop_subdivision.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "mesh/surface_point.h"

// Straightest geodesics, distances, shortest paths, log and exp.
#include "distance/distance_fields.h"
#include "distance/find_path.h"
#include "distance/graph_distance.h"
#include "distance/path_distance.h"
#include "distance/shortest_path.h"
#include "distance/source_vectors.h"
#include "distance/tangent_maps.h"
#include "distance/waypoints.h"
#include "distance/window_distance.h"
#include "intrinsic/straightest.h"

// Centers of mass, Voronoi diagrams.
#include "rcm/centroid.h"
#include "rcm/certificate.h"
#include "rcm/mean.h"
#include "rcm/mean_weights.h"
#include "rcm/statistics.h"
#include "rcm/voronoi.h"

// Curves: their points and lengths, inserted control points, circles, isolines, offsets.
#include "curves/circle.h"
#include "curves/curve.h"
#include "curves/isoline.h"
#include "curves/offset.h"
#include "curves/query/evaluate.h"
#include "curves/query/measure.h"
#include "curves/refine/refine.h"

// Regions, and meshes divided along paths.
#include "regions/cut.h"
#include "regions/region.h"
