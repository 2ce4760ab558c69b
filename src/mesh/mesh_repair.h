#pragma once

#include "mesh/mesh_import.h"

namespace karcher {

/// The result of `importMesh`, but `repairs` also lists the kinds with a count of 0.
ImportedMesh repairMesh(TriangleSoup soup, const ImportOptions& options);

/// The repair with its sentence for reports.
Repair repairOf(Repair::Kind kind, int count);

}  // namespace karcher
