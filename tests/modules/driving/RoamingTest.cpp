// SPDX-License-Identifier: GPL-3.0-or-later
// Ten minutes of wandering in maps of real buildings.
#include <gtest/gtest.h>

#include <set>

#include "modules/driving/Wanderer.h"
#include "tests/modules/driving/Ride.h"

namespace modules {
namespace {

struct Roaming {
  const char* name;
  const char* map;
  robotlink::Pose2 start;
  Avoidance avoidance;
  bool laser;
};

class RoamingTest : public testing::TestWithParam<Roaming> {};

TEST_P(RoamingTest, itWandersForTenMinutesWithoutTouchingAWall) {
  const robotlink::GroundMap map = sharedMap(GetParam().map);
  if (map.lines.empty()) GTEST_SKIP() << "needs ../shared/data/arcos/" << GetParam().map;
  const FlatWorld world(map);
  Ride ride(world, {.start = GetParam().start, .laser = GetParam().laser}, GetParam().avoidance);
  Wanderer wanderer({});
  std::set<std::pair<int, int>> squares;
  ride.run(600, [&](auto points) {
    squares.insert(
        {static_cast<int>(ride.robot().pose().x / 2), static_cast<int>(ride.robot().pose().y / 2)});
    return wanderer.decide(points, ride.robot().odometry(), ride.robot().time());
  });
  EXPECT_GT(ride.robot().nearest(), 0.05);
  // It gets about, and through doors.
  EXPECT_GT(ride.robot().way(), 120);
  EXPECT_GT(squares.size(), GetParam().laser ? 12U : 8U);
}

constexpr robotlink::Pose2 kOfficeHome{1, 1.498, 0}, kColumbiaHome{-0.182, 0.176, 0};

INSTANTIATE_TEST_SUITE_P(
    Maps, RoamingTest,
    testing::Values(
        Roaming{"officeVectorField", "office.map", kOfficeHome, Avoidance::kVectorField, true},
        Roaming{"officeDynamicWindow", "office.map", kOfficeHome, Avoidance::kDynamicWindow, true},
        Roaming{"officeVectorFieldBySonar", "office.map", kOfficeHome, Avoidance::kVectorField, false},
        Roaming{"officeDynamicWindowBySonar", "office.map", kOfficeHome, Avoidance::kDynamicWindow, false},
        Roaming{"columbiaVectorField", "columbia.map", kColumbiaHome, Avoidance::kVectorField, true},
        Roaming{"columbiaDynamicWindow", "columbia.map", kColumbiaHome, Avoidance::kDynamicWindow, true},
        Roaming{"columbiaVectorFieldBySonar", "columbia.map", kColumbiaHome, Avoidance::kVectorField, false},
        Roaming{"columbiaDynamicWindowBySonar", "columbia.map", kColumbiaHome, Avoidance::kDynamicWindow,
                false}),
    [](const auto& roaming) { return std::string(roaming.param.name); });

}  // namespace
}  // namespace modules
