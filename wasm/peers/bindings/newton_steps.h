#pragma once

#include "bindings/mesh_handle.h"

namespace karcher::bindings {

/// What the paper's searches (rcm/paper_method.h) did for each row of weights: ten numbers a row,
/// which karcher-peers.d.mts lists. Searches begin at the point with the largest weight; if `warm`,
/// those after one that converged begin where it ended.
val newtonSteps(MeshHandle& mesh, const val& points, const val& weights, const val& options,
                bool warm);

}  // namespace karcher::bindings
