#pragma once

#include "curves/trace/piece.h"
#include "intrinsic/surface_path.h"

namespace karcher {

/// A leg of a control polygon as a curve, with samples at the fractions t of its length. If the leg
/// is a shortest path, the samples are the exact centers of mass of its ends with weights 1 - t and
/// t.
TracedPiece traceLeg(const TriangleMesh& mesh, const SurfacePath& leg, int samples);

}  // namespace karcher
