#pragma once

#include "bindings/mesh_handle.h"

namespace karcher::bindings {

/// Records of the paper's searches (rcm/paper_method.h): for each row of weights, the ten numbers
/// that karcher-peers.d.mts lists. Searches begin at the point with the largest weight. If `warm`,
/// a search that follows a converged search begins where that search ended.
val newtonSteps(MeshHandle& mesh, const val& points, const val& weights, const val& options,
                bool warm);

}  // namespace karcher::bindings
