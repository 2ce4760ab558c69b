#pragma once

#include "bindings/mesh_handle.h"

namespace karcher::bindings {

/// Records of the paper's searches (rcm/paper_method.h): for each row of weights, the ten numbers
/// that karcher-peers.d.mts lists. Searches begin at the point with the largest weight. If `warm`,
/// a search after a converged one begins where the converged one ended.
val newtonSteps(MeshHandle& mesh, const val& points, const val& weights, const val& options,
                bool warm);

}  // namespace karcher::bindings
