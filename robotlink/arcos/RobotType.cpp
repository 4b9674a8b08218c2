// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/RobotType.h"

#include <algorithm>
#include <span>
#include <string_view>

namespace robotlink::arcos {
namespace {

/// The place of a sonar: mm and degrees, as in the manufacturer's parameter files.
struct SonarPlace {
  int x, y, heading;
};
/// Sixteen sonars in two arrays: 0 to 7 point forwards, from left to right, 8 to 15 backwards, from right to
/// left.
constexpr SonarPlace kP3at[]{{147, 136, 90},    {193, 119, 50},     {227, 79, 30},     {245, 27, 10},
                             {245, -27, -10},   {227, -79, -30},    {193, -119, -50},  {147, -136, -90},
                             {-144, -136, -90}, {-189, -119, -130}, {-223, -79, -150}, {-241, -27, -170},
                             {-241, 27, 170},   {-223, 79, 150},    {-189, 119, 130},  {-144, 136, 90}};
/// The same of a smaller base; a PeopleBot has eight more in its head, 16 to 23, that point forwards.
constexpr SonarPlace kP3dx[]{{69, 136, 90},     {114, 119, 50},     {148, 78, 30},     {166, 27, 10},
                             {166, -27, -10},   {148, -78, -30},    {114, -119, -50},  {69, -136, -90},
                             {-157, -136, -90}, {-203, -119, -130}, {-237, -78, -150}, {-255, -27, -170},
                             {-255, 27, 170},   {-237, 78, 150},    {-203, 119, 130},  {-157, 136, 90}};
constexpr SonarPlace kPeopleBotHead[]{{-20, 136, 90}, {24, 119, 50},  {58, 78, 30},    {77, 27, 10},
                                      {77, -27, -10}, {58, -78, -30}, {24, -119, -50}, {-20, -136, -90}};

/// The properties that differ between types of robots: the begin of the subclass, and the sonars.
struct TypeRow {
  std::string_view begin;
  std::span<const SonarPlace> base, head;
};
constexpr TypeRow kTypes[]{{"p3dx", kP3dx, {}}, {"peoplebot", kP3dx, kPeopleBotHead}, {"", kP3at, {}}};

void addTo(std::vector<Pose2>& sonars, std::span<const SonarPlace> places) {
  for (const SonarPlace& place : places)
    sonars.push_back({place.x / 1000.0, place.y / 1000.0, radians(place.heading)});
}

}  // namespace

RobotType robotType(const std::string& subclass) {
  RobotType type;
  type.subclass = subclass;
  const auto* row =
      std::ranges::find_if(kTypes, [&](const TypeRow& known) { return subclass.starts_with(known.begin); });
  addTo(type.sonarsInRobot, row->base);
  addTo(type.sonarsInRobot, row->head);
  // Robots with an older controller.
  if (subclass == "p3at") type.distance = 0.000465;
  return type;
}

}  // namespace robotlink::arcos
