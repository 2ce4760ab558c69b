#pragma once

#include "bindings/mesh_handle.h"

namespace karcher::bindings {

/// Records of the paper's searches (rcm/paper_method.h): ten numbers for each row of weights,
/// which karcher-peers.d.mts lists. Searches begin at the point with the largest weight; if `warm`,
/// those after one that converged begin where it ended.
val newtonSteps(MeshHandle& mesh, const val& points, const val& weights, const val& options,
                bool warm);

}  // namespace karcher::bindings
