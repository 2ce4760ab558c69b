#pragma once

#include "mesh/mesh_import.h"

namespace karcher {

/// `importMesh`; repairs with a count of 0 are among them.
ImportedMesh repairMesh(TriangleSoup soup, const ImportOptions& options);

/// A repair with its sentence.
Repair repairOf(Repair::Kind kind, int count);

}  // namespace karcher
