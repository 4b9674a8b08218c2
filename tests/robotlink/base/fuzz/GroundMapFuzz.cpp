// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of a building's floor.
#include <cmath>
#include <cstdlib>

#include "robotlink/base/GroundMap.h"
#include "robotlink/base/Utf8.h"
#include "tests/fuzz/FuzzTarget.h"

namespace ground_map_fuzz {

using robotlink::GroundMap;

namespace {

bool isNear(const robotlink::Vector2& point) {
  return std::abs(point.x()) <= 10'000 && std::abs(point.y()) <= 10'000;
}

void check(const GroundMap& map, std::size_t size) {
  for (const GroundMap::Line& line : map.lines)
    require(isNear(line.from) && isNear(line.to), "lines are near");
  for (const robotlink::Vector2& point : map.points) require(isNear(point), "points are near");
  for (const GroundMap::Place& place : map.places) {
    require(isNear(place.pose.translation()) && isNear(place.extent.from) && isNear(place.extent.to),
            "places are near");
    require(std::abs(place.pose.heading) <= robotlink::kPi, "headings are angles");
    require(robotlink::validUtf8(place.name) == place.name, "names are UTF-8");
  }
  // Each takes a line of its own; the shortest are "1 2" and a line's end.
  require((map.lines.size() + map.points.size() + map.places.size()) * 4 <= size + 4,
          "nothing comes from nothing");
  require(map.notes.size() <= 50, "notes are few");
  require(map.resolution >= 0.001 && map.resolution <= 1, "the resolution is sensible");
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const auto map = GroundMap::parse({reinterpret_cast<const char*>(data), size}, "fuzz.map");
  if (map)
    check(*map, size);
  else
    require(!map.error().empty() && map.error().size() <= 20 && !map.error()[0].text.empty(),
            "a refusal says why");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {
      "2D-Map\nMinPos: 0 0\nMaxPos: 100 100\nNumPoints: 2\nResolution: 20\nCairn: RobotHome 1 2 54 \"\" ICON "
      "\"Home\"\n"
      "Cairn: ForbiddenArea 0 0 30.5 \"\" ICON \"\" -4540 -10800 -3080 -7780\nLINES\n0 10080 0 0\n-1 2 3 "
      "4\nDATA\n1 2\n"
      "-3.5 1e3\n",
      "2D-Map-Ex2\r\nSources: LMS TIM\r\nMapInfo: GoalType Name=Goal \"Label=a b\"\r\nCairn: Goal 1 2 0 \"\" "
      "ICON \"T\xFCr\"\r\n"
      "LINES\r\nTIM_LINES\r\n1 2 3 4\r\nTIM_DATA\r\n1 2\r\n",
      "2D-Map\n",
      "\xEF\xBB\xBF"
      "2D-Map\nDATA\n1 2\n1 2 3\n"};
}

const FuzzRegistration kTarget({"ground_map", &fuzzSeeds, &runInput});

}  // namespace ground_map_fuzz
