#include <gtest/gtest.h>

#include "fuzz/fuzz_checks.h"
#include "fuzz/fuzz_seeds.h"

namespace karcher {
namespace {

/// Checks that the fuzzers find nothing in their own seeds.
void expectNoFinding(void (*check)(Bytes), const Array<Seed>& seeds) {
  for (int i = 0; i < seeds.count(); ++i) {
    EXPECT_NO_THROW(check(seeds[i])) << "seed " << i;
  }
}

TEST(Fuzz, ObjFilesAreOpenedOrRefused) { expectNoFinding(fuzzObj, objSeeds()); }

TEST(Fuzz, TrianglesAreMendedOrRefused) { expectNoFinding(fuzzRepairs, repairsSeeds()); }

TEST(Fuzz, EditedCurvesEqualCurvesTracedAnew) { expectNoFinding(fuzzCurve, curveSeeds()); }

/// A check that cannot fail would detect nothing.
TEST(Fuzz, ChecksFail) {
  EXPECT_THROW(expect(false, "so"), FuzzFinding);
  EXPECT_THROW(expectSentence(Error(ErrorCode::kBadFile, "")), FuzzFinding);
  EXPECT_THROW(expectSentence(Error(ErrorCode::kBadFile, "a\nb")), FuzzFinding);
  ImportedMesh imported = importObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_NO_THROW(expectSoundMesh(imported));
  const SurfacePath outside{{{0, Vec3(1, 0, 0)}, {7, Vec3(1, 0, 0)}}, {0, 1}};
  EXPECT_THROW(expectOnSurface(imported.mesh, outside), FuzzFinding);
  imported.mesh.twin[0] = 5;
  EXPECT_THROW(expectSoundMesh(imported), FuzzFinding);
}

}  // namespace
}  // namespace karcher
