#include "generators/accuracy.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>

#include "support.h"

namespace karcher {
namespace {

/// The largest RMS error, in mean edges, with the fast and with the exact solver, and the largest
/// turning noise. For long triangles the noise varies from mesh to mesh, 1.2e-3 to 2.5e-3 at this
/// size.
struct Asked {
  const char* family;
  double fast;
  double exact;
  double turningNoise;
};

const Asked kAsked[] = {
    {"sphere: relaxed random points", 0.006, 0.003, 0.002},
    {"torus: isotropic irregular", 0.006, 0.003, 0.002},
    {"torus: stretched 8:1", 0.03, 0.03, 0.003},
};

class AccuracyOnSmoothSurfaces : public testing::TestWithParam<Asked> {};

std::string testName(const testing::TestParamInfo<Asked>& asked) {
  std::string result;
  for (const char c : std::string(asked.param.family)) {
    if (std::isalnum(static_cast<unsigned char>(c))) result += c;
  }
  return result;
}

TEST_P(AccuracyOnSmoothSurfaces, IsAFractionOfTheMeanEdge) {
  SKIP_WHERE_SANITIZED();
  const Asked asked = GetParam();
  constexpr int kTriangles = 20480;
  bool found = false;
  for (const AccuracyFamily& family : accuracyFamilies()) {
    if (family.name != asked.family) continue;
    found = true;
    AccuracyCase example(family, kTriangles);
    const Accuracy fast = measureAccuracy(example, {Method::kKarcher, Solver::kFast, 6});
    const Accuracy exact = measureAccuracy(example, {Method::kKarcher, Solver::kExact, 6});
    EXPECT_LE(fast.rms / fast.meanEdge, asked.fast);
    EXPECT_LE(exact.rms / exact.meanEdge, asked.exact);
    EXPECT_LE(fast.turningNoise, asked.turningNoise);
    EXPECT_LE(exact.turningNoise, asked.turningNoise);
    EXPECT_EQ(fast.lost, 0);
    EXPECT_EQ(exact.lost, 0);
  }
  EXPECT_TRUE(found);
}

INSTANTIATE_TEST_SUITE_P(Families, AccuracyOnSmoothSurfaces, testing::ValuesIn(kAsked), testName);

}  // namespace
}  // namespace karcher
