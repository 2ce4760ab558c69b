#pragma once

/// All that users of the engine include: `#include <karcher/karcher.h>`. What these headers do not
/// reach is internal and not installed.

// Meshes: reading and repairing, shapes, subdivision, the nearest point on them.
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

// Centers of mass.
#include "rcm/certificate.h"
#include "rcm/mean.h"
#include "rcm/mean_weights.h"
#include "rcm/statistics.h"

// Curves: their points and lengths, control points put in, circles, isolines, offsets.
#include "curves/circle.h"
#include "curves/curve.h"
#include "curves/isoline.h"
#include "curves/offset.h"
#include "curves/query/evaluate.h"
#include "curves/query/measure.h"
#include "curves/refine/refine.h"

// Regions, and meshes cut along paths.
#include "regions/cut.h"
#include "regions/region.h"
