// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/Particles.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

struct WeightedPose {
  robotlink::Pose2 pose;
  double weight = 1;
};

TEST(WeightedParticles, equalWeightsCountInFull) {
  EXPECT_DOUBLE_EQ(effectiveParticles(std::vector<WeightedPose>{{{}, 3}, {{}, 3}, {{}, 3}}), 3);
}

TEST(WeightedParticles, oneHeavyParticleCountsAlone) {
  EXPECT_NEAR(effectiveParticles(std::vector<WeightedPose>{{{}, 1e6}, {{}, 1}, {{}, 1}}), 1, 1e-5);
}

TEST(WeightedParticles, withoutWeightsNothingIsInformative) {
  EXPECT_EQ(effectiveParticles(std::vector<WeightedPose>{{{}, 0}, {{}, 0}}), 0);
}

TEST(WeightedParticles, posesComeInTheirOrder) {
  const std::vector<robotlink::Pose2> poses{{1, 2, 0.5}, {-3, 4, -0.5}};
  EXPECT_EQ(posesOf(std::vector<WeightedPose>{{poses[0], 1}, {poses[1], 0}}), poses);
}

}  // namespace
}  // namespace modules
