// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/Particle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace modules {
namespace {

using robotlink::kPi;

/// So many particles around a place, in a square of this side.
void addCloud(std::vector<Particle>& cloud, float x, float y, float heading, int count, float side,
              float logWeight = 0) {
  for (int i = 0; i < count; ++i) {
    const float across = side * (static_cast<float>(i % 5) / 4 - 0.5F);
    const float along = side * (static_cast<float>(i / 5 % 5) / 4 - 0.5F);
    cloud.push_back({x + across, y + along, heading, logWeight});
  }
}

TEST(Particle, equalWeightsAreAsInformativeAsTheyAreMany) {
  std::vector<Particle> cloud(40);
  EXPECT_DOUBLE_EQ(weightSums(cloud).effective(), 40);
  // Whatever the sum of the weights is: only differences of logarithms matter.
  for (Particle& particle : cloud) particle.logWeight = -1000;
  EXPECT_DOUBLE_EQ(weightSums(cloud).effective(), 40);
  EXPECT_DOUBLE_EQ(weightSums(cloud).best, -1000);
}

TEST(Particle, oneThatOutweighsAllOthersCountsAlone) {
  std::vector<Particle> cloud(40);
  cloud[7].logWeight = 100;
  EXPECT_NEAR(weightSums(cloud).effective(), 1, 1e-9);
  cloud[8].logWeight = 100;
  EXPECT_NEAR(weightSums(cloud).effective(), 2, 1e-9);
}

TEST(Particle, withoutParticlesNothingIsKnown) {
  const PoseEstimate estimate = summarize({});
  EXPECT_EQ(estimate.positionDeviation, 1e3);
  EXPECT_DOUBLE_EQ(estimate.headingDeviation, kPi);
}

TEST(Particle, aPoseIsTakenAndGivenBack) {
  const auto particle = Particle::at({1.5, -2.25, 0.5});
  EXPECT_EQ(particle.logWeight, 0);
  EXPECT_EQ(particle.pose().x, 1.5);
  EXPECT_EQ(particle.pose().y, -2.25);
  EXPECT_EQ(particle.pose().heading, 0.5);
}

TEST(Particle, theMiddleOfACloudIsFound) {
  std::vector<Particle> cloud;
  addCloud(cloud, 3.3F, -1.7F, 0.4F, 25, 0.4F);
  const PoseEstimate estimate = summarize(cloud);
  EXPECT_NEAR(estimate.robotInField.x, 3.3, 1e-5);
  EXPECT_NEAR(estimate.robotInField.y, -1.7, 1e-5);
  EXPECT_NEAR(estimate.robotInField.heading, 0.4, 1e-5);
  EXPECT_NEAR(estimate.headingDeviation, 0, 1e-5);
  // Five rows at -0.2, -0.1, 0, 0.1, 0.2 m have this deviation.
  EXPECT_NEAR(estimate.positionDeviation, std::sqrt(0.02), 1e-5);
}

TEST(Particle, ofTwoClustersTheHeavierCounts) {
  std::vector<Particle> cloud;
  addCloud(cloud, 0, 0, 0, 25, 0.2F);
  addCloud(cloud, 6, 0, 0, 10, 0.2F);
  EXPECT_NEAR(summarize(cloud).robotInField.x, 0, 1e-3);
  for (std::size_t i = 25; i < cloud.size(); ++i) cloud[i].logWeight = 2;
  EXPECT_NEAR(summarize(cloud).robotInField.x, 6, 1e-3);
  // The other one makes the estimate uncertain.
  EXPECT_GT(summarize(cloud).positionDeviation, 1);
}

TEST(Particle, headingsAreAveragedAcrossTheSeam) {
  std::vector<Particle> cloud;
  const auto nearlyBack = static_cast<float>(kPi) - 0.05F;
  addCloud(cloud, 0, 0, nearlyBack, 25, 0.1F);
  addCloud(cloud, 0, 0, -nearlyBack, 25, 0.1F);
  const PoseEstimate estimate = summarize(cloud);
  EXPECT_NEAR(std::abs(estimate.robotInField.heading), kPi, 1e-3);
  EXPECT_NEAR(estimate.headingDeviation, 0.05, 1e-3);
}

TEST(Particle, aWiderCloudNeedsMoreParticles) {
  std::vector<Particle> cloud;
  addCloud(cloud, 0.1F, 0.1F, 0.1F, 25, 0.01F);
  EXPECT_EQ(neededParticles(cloud), 1);
  EXPECT_EQ(neededParticles({}), 1);
  double before = 1;
  for (const float side : {0.6F, 2.0F, 8.0F}) {
    cloud.clear();
    addCloud(cloud, 0.1F, 0.1F, 0.1F, 25, side);
    EXPECT_GE(neededParticles(cloud), before) << side;
    before = neededParticles(cloud);
  }
  // Fox 2003, equation 13: 25 bins, an error of 0.05 with 99 %.
  const double a = 2.0 / (9 * 24);
  EXPECT_NEAR(before, 24 / 0.1 * std::pow(1 - a + std::sqrt(a) * 2.33, 3), 1e-6);
}

}  // namespace
}  // namespace modules
