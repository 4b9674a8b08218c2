// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/MapConversions.h"

#include <gtest/gtest.h>

#include <limits>

#include "robotcontrol/Driving.pb.h"

using namespace robotlink;
using Kind = GroundMap::Place::Kind;

namespace {

GroundMap smallMap() {
  GroundMap map;
  map.name = "office";
  map.lines = {{{0, 1}, {2, 3.5}}, {{-4, 0.1}, {0, 0}}};
  map.points = {{0.5, -0.25}, {24.68, -27}};
  int number = 0;
  for (const Kind kind :
       {Kind::kGoal, Kind::kHome, Kind::kDock, Kind::kForbiddenLine, Kind::kForbiddenArea, Kind::kOther}) {
    map.places.push_back({kind,
                          "type" + std::to_string(number),
                          "name" + std::to_string(number),
                          {1.0 * number, 2, 0.5},
                          number % 2 == 0,
                          {{1, 2}, {3, 4}}});
    ++number;
  }
  return map;
}

}  // namespace

TEST(MapConversions, aMapComesBackAsItWas) {
  const GroundMap map = smallMap();
  robotcontrol::GroundMap sent, received;
  sent.set_name("something else");
  sent.add_points(1);
  assign(sent, map);
  ASSERT_TRUE(received.ParseFromString(sent.SerializeAsString()));
  const GroundMap back = groundMap(received);
  EXPECT_EQ(back.name, map.name);
  EXPECT_EQ(back.lines, map.lines);
  EXPECT_EQ(back.places, map.places);
  ASSERT_EQ(back.points.size(), map.points.size());
  for (std::size_t i = 0; i < map.points.size(); ++i)
    EXPECT_LT((back.points[i] - map.points[i]).norm(), 1e-5);
}

TEST(MapConversions, kindsHaveTheirNamesInPackages) {
  robotcontrol::GroundMap message;
  assign(message, smallMap());
  ASSERT_EQ(message.places_size(), 6);
  EXPECT_EQ(message.places(1).kind(), robotcontrol::GroundMap::Place::HOME);
  EXPECT_EQ(message.places(4).kind(), robotcontrol::GroundMap::Place::FORBIDDEN_AREA);
  EXPECT_EQ(message.places(4).type(), "type4");
}

TEST(MapConversions, whateverALinkDeliversIsAMap) {
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  robotcontrol::GroundMap message;
  for (const float value : {1.F, 2.F, static_cast<float>(kNotANumber), 0.F, 3.F}) message.add_points(value);
  message.add_lines()->set_x1(kNotANumber);
  message.add_lines()->set_x2(7);
  message.add_places()->mutable_pose()->set_heading(kNotANumber);
  message.add_places()->set_kind(static_cast<robotcontrol::GroundMap::Place::Kind>(99));
  const GroundMap map = groundMap(message);
  ASSERT_EQ(map.points.size(), 1U);
  EXPECT_EQ(map.points[0], Vector2(1, 2));
  ASSERT_EQ(map.lines.size(), 1U);
  EXPECT_EQ(map.lines[0].to, Vector2(7, 0));
  ASSERT_EQ(map.places.size(), 1U);
  EXPECT_EQ(map.places[0].kind, Kind::kOther);
}
