// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "simcore/Simulation.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

constexpr int kSteps = 1000;

/// Steps a simulation with requests that depend on the step only, and reads its sensors now and then.
std::uint64_t play(Simulation& simulation) {
  for (int i = 0; i < kSteps; ++i) {
    for (std::size_t s = 0; s < simulation.servos().size(); ++s) {
      const Servo& servo = simulation.servos()[s];
      const double middle = (servo.minimum + servo.maximum) / 2, range = (servo.maximum - servo.minimum) / 4;
      simulation.requestAngle(s, middle + range * std::sin(0.01 * i + static_cast<double>(s)));
    }
    simulation.step();
  }
  return simulation.digest();
}

std::unique_ptr<Simulation> simulation(std::uint64_t seed) {
  return std::move(Simulation::create(shippedScene(), {.seed = seed, .noise = true}).value());
}

std::uint64_t digestOf(std::uint64_t seed) {
  return play(*simulation(seed));
}

TEST(Determinism, theSameSeedGivesTheSameBytes) {
  EXPECT_EQ(digestOf(1), digestOf(1));
}

TEST(Determinism, anotherSeedGivesOtherBytes) {
  EXPECT_NE(digestOf(1), digestOf(2));
}

TEST(Determinism, aResetSimulationIsAsGoodAsANewOne) {
  const auto used = simulation(2);
  play(*used);
  ASSERT_TRUE(used->placeModel("ball", {1, 0.5, 0}));
  used->setTorqueLimit(7, 0.1);
  used->reset(1);
  const auto fresh = simulation(1);
  EXPECT_EQ(used->digest(), fresh->digest());
  EXPECT_EQ(play(*used), play(*fresh));
  for (std::size_t i = 0; i < fresh->sensors().size(); ++i) {
    EXPECT_EQ(used->sensors()[i].values, fresh->sensors()[i].values) << fresh->sensors()[i].info.path;
  }
}

TEST(Determinism, readingSensorsDisturbsNothing) {
  const auto read = simulation(1), unread = simulation(1);
  for (int i = 0; i < 100; ++i) {
    read->step();
    unread->step();
    EXPECT_FALSE(read->sensors().empty());
    EXPECT_FALSE(read->bodyPoses().empty());
  }
  EXPECT_EQ(read->digest(), unread->digest());
}

TEST(Determinism, simulationsOnSeveralThreadsDoNotDisturbEachOther) {
  const std::uint64_t alone[] = {digestOf(1), digestOf(2)};
  std::uint64_t together[2] = {};
  {
    std::jthread first([&] { together[0] = digestOf(1); });
    std::jthread second([&] { together[1] = digestOf(2); });
  }
  EXPECT_EQ(together[0], alone[0]);
  EXPECT_EQ(together[1], alone[1]);
}

TEST(Determinism, aSimulationMayMoveToAnotherThread) {
  const auto moved = simulation(1);
  std::uint64_t digest = 0;
  std::jthread([&] { digest = play(*moved); }).join();
  EXPECT_EQ(digest, digestOf(1));
}

}  // namespace
}  // namespace simcore
