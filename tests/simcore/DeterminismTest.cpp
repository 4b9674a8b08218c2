// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "robotlink/base/threads/ThreadPool.h"
#include "simcore/Simulation.h"
#include "tests/simcore/DriveScenes.h"
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

/// A field with robots that fall onto each other, boxes of their own, and a ball.
std::shared_ptr<const Scene> crowd() {
  std::string contents =
      "<include><uri>model://field2002</uri></include><include><uri>model://ball</uri><pose>0 0 0.2 0 0 "
      "0</pose></include>";
  for (int i = 0; i < 5; ++i) {
    contents += "<include><uri>model://ers210</uri><name>red" + std::to_string(i + 1) + "</name><pose>" +
                std::to_string(-1.2 + 0.32 * i) + " 0.7 0.15 0 0 " + std::to_string(i) + "</pose></include>";
  }
  for (int i = 0; i < 4; ++i) {
    contents += "<model name='box" + std::to_string(i) + "'><pose>" + std::to_string(0.06 * i) + " -0.5 " +
                std::to_string(0.06 + 0.11 * i) +
                " 0 0 0</pose><link name='box'><inertial><mass>0.2</mass><inertia><ixx>0.0003</ixx>"
                "<iyy>0.0003</iyy><izz>0.0003</izz></inertia></inertial><collision name='box'><geometry>"
                "<box><size>0.1 0.1 0.1</size></box></geometry></collision></link></model>";
  }
  const SceneFolder folder;
  folder.copyShippedModels();
  return Scene::load(folder.write("world.sdf", worldAround(contents))).value();
}

TEST(Determinism, anyNumberOfThreadsGivesTheSameBytes) {
  const auto scene = crowd();
  std::vector<std::uint64_t> digests;
  for (const int threads : {1, 2, 3, 8}) {
    auto simulation = std::move(
        Simulation::create(scene, {.seed = 3, .pool = std::make_shared<robotlink::ThreadPool>(threads)})
            .value());
    std::uint64_t all = 0;
    for (int i = 0; i < 200; ++i) {
      for (std::size_t s = 0; s < simulation->servos().size(); ++s)
        simulation->requestAngle(s, 0.4 * std::sin(0.03 * i + static_cast<double>(s)));
      simulation->step();
      all = all * 31 + simulation->digest();
    }
    digests.push_back(all);
  }
  for (const std::uint64_t digest : digests) EXPECT_EQ(digest, digests.front());
}

/// A cart with an image sensor of each kind.
std::string seeingCart(int i) {
  const std::string camera =
      "<camera><horizontal_fov>1</horizontal_fov><image><width>16</width><height>9</height></image>"
      "<clip><near>0.1</near><far>9</far></clip></camera></sensor>";
  return "<model name='cart" + std::to_string(i) + "'><pose>-2 " + std::to_string(i) +
         " 0.1 0 0 0</pose><link name='base'><inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy>"
         "<izz>0.01</izz></inertia></inertial><collision name='c'><geometry><box><size>0.3 0.3 "
         "0.1</size></box></geometry></collision><visual name='v'><geometry><box><size>0.3 0.3 "
         "0.1</size></box></geometry></visual><sensor name='depth' type='depth_camera'>" +
         camera + "<sensor name='labels' type='segmentation_camera'>" + camera +
         "<sensor name='eye' type='custom'><robotcontrol:facette><robotcontrol:azimuth>1 -1 "
         "12</robotcontrol:azimuth><robotcontrol:elevation>0.4 -0.4 5</robotcontrol:elevation>"
         "</robotcontrol:facette></sensor></link></model>";
}

TEST(Determinism, anyNumberOfThreadsMeasuresTheSame) {
  std::string contents;
  for (int i = 0; i < 3; ++i)
    contents += pioneerAt("p3at" + std::to_string(i + 1), i, 0.5 * i, i) + seeingCart(i);
  const auto scene = floorWith(contents + wallAhead());
  std::vector<std::vector<double>> all;
  for (const int threads : {1, 2, 3, 8}) {
    auto simulation = std::move(
        Simulation::create(scene, {.seed = 3, .pool = std::make_shared<robotlink::ThreadPool>(threads)})
            .value());
    auto& values = all.emplace_back();
    for (int i = 0; i < 30; ++i) {
      simulation->step();
      if (i % 5 != 0) continue;
      // In the middle one is measured again from another place.
      if (i == 20) {
        ASSERT_TRUE(simulation->placeModel("p3at1", {-1, -1, 0}));
      }
      for (const Port& port : simulation->ports()) {
        if (port.kind != Port::Kind::kRange && port.kind != Port::Kind::kImage) continue;
        const auto read = simulation->read(port.info.path).value();
        values.insert(values.end(), read.begin(), read.end());
      }
    }
  }
  EXPECT_GT(all[0].size(), 6U * 3U * (16U * 9U * 2U + 12U * 5U));
  for (const auto& values : all) EXPECT_TRUE(values == all[0]);
}

TEST(Determinism, aSimulationMayMoveToAnotherThread) {
  const auto moved = simulation(1);
  std::uint64_t digest = 0;
  std::jthread([&] { digest = play(*moved); }).join();
  EXPECT_EQ(digest, digestOf(1));
}

}  // namespace
}  // namespace simcore
