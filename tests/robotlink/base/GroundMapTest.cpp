// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/GroundMap.h"

#include <gtest/gtest.h>

#include <string>

using namespace robotlink;
using Kind = GroundMap::Place::Kind;

namespace {

const std::filesystem::path kRealMaps = ROBOTCONTROL_SOURCE_DIR "/../shared/data/arcos",
                            kShippedMaps = ROBOTCONTROL_SOURCE_DIR "/resources/scenes";

GroundMap parsed(const std::string& text) {
  const auto map = GroundMap::parse(text, "folder/room.map");
  EXPECT_TRUE(map) << describe(map.error());
  return map.value_or(GroundMap{});
}

std::string errorsOf(const std::string& text) {
  const auto map = GroundMap::parse(text, "room.map");
  return map ? "" : describe(map.error());
}

std::string withCairn(const std::string& cairn) {
  return "2D-Map\nCairn: " + cairn + "\nLINES\n0 0 1000 0\nDATA\n";
}

}  // namespace

TEST(GroundMap, linesPointsAndPlacesAreReadInMetersAndRadians) {
  const GroundMap map = parsed(
      "2D-Map\nMinPos: 0 0\nMaxPos: 1 1\nNumPoints: 2\nResolution: 50\nPointsAreSorted: true\n"
      "Cairn: GoalWithHeading -1860 -22440 -48.5 \"\" ICON \"Lobby door\"\n"
      "LINES\n-1000 0 2500 -40\nDATA\n20 -40\n60.5 1e3\n");
  EXPECT_EQ(map.name, "room");
  EXPECT_EQ(map.resolution, 0.05);
  ASSERT_EQ(map.lines.size(), 1U);
  EXPECT_EQ(map.lines[0].from, Vector2(-1, 0));
  EXPECT_EQ(map.lines[0].to, Vector2(2.5, -0.04));
  ASSERT_EQ(map.points.size(), 2U);
  EXPECT_EQ(map.points[1], Vector2(0.0605, 1));
  ASSERT_EQ(map.places.size(), 1U);
  const GroundMap::Place& door = map.places[0];
  EXPECT_EQ(door.kind, Kind::kGoal);
  EXPECT_EQ(door.type, "GoalWithHeading");
  EXPECT_EQ(door.name, "Lobby door");
  EXPECT_TRUE(door.hasHeading);
  EXPECT_DOUBLE_EQ(door.pose.x, -1.86);
  EXPECT_DOUBLE_EQ(door.pose.y, -22.44);
  EXPECT_DOUBLE_EQ(door.pose.heading, radians(-48.5));
  EXPECT_TRUE(map.notes.empty());
}

TEST(GroundMap, kindsOfPlacesAreDistinguished) {
  const GroundMap map = parsed(
      "2D-Map-Ex4\n"
      "Cairn: Goal 1 2 90 \"\" ICON \"a\"\n"
      "Cairn: RobotHome 1 2 90 \"\" ICON \"\"\n"
      "Cairn: DockLynx 1 2 90 \"\" ICON \"c\"\n"
      "Cairn: ForbiddenLine 1 2 0 \"\" ICON \"\" 1000 2000 3000 4000\n"
      "Cairn: ForbiddenArea 0 0 30 \"\" ICON \"\" -1000 -2000 3000 4000\n"
      "Cairn: Measure 1 2 0.5 \"\" ICON \"stick\" 5 6 7 8\n");
  ASSERT_EQ(map.places.size(), 6U);
  const Kind kinds[] = {Kind::kGoal,          Kind::kHome,          Kind::kDock,
                        Kind::kForbiddenLine, Kind::kForbiddenArea, Kind::kOther};
  const bool headings[] = {false, true, true, false, false, true};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(map.places[i].kind, kinds[i]) << i;
    EXPECT_EQ(map.places[i].hasHeading, headings[i]) << i;
  }
  EXPECT_EQ(map.places[4].extent.from, Vector2(-1, -2));
  EXPECT_EQ(map.places[4].extent.to, Vector2(3, 4));
  EXPECT_DOUBLE_EQ(map.places[4].pose.heading, radians(30));
  EXPECT_EQ(map.places[5].type, "Measure");
  EXPECT_EQ(map.places[5].extent.to, Vector2(0.007, 0.008));
  EXPECT_EQ(map.find(Kind::kHome), &map.places[1]);
  EXPECT_EQ(map.find("stick"), &map.places[5]);
  EXPECT_EQ(map.find("nowhere"), nullptr);
}

TEST(GroundMap, countsOfTheHeaderAreNotTrusted) {
  const GroundMap map =
      parsed("2D-Map\nNumPoints: 99999999999\nNumLines: -3\nLINES\n0 0 1 1\nDATA\n1 2\n3 4\n");
  EXPECT_EQ(map.lines.size(), 1U);
  EXPECT_EQ(map.points.size(), 2U);
  ASSERT_EQ(map.notes.size(), 2U);
  EXPECT_NE(map.notes[0].find("room.map:2: the header promises 99999999999 points, but there are 2"),
            std::string::npos)
      << map.notes[0];
}

TEST(GroundMap, aMapThatWasCutOffSaysSoFirst) {
  const GroundMap map =
      parsed("2D-Map\nMapInfo: x\nNumLines: 4\nNumPoints: 2\nLINES\n0 0 1000 0\nDATA\n1 2\n3 4\n");
  ASSERT_EQ(map.notes.size(), 2U);
  EXPECT_NE(map.notes[0].find(
                "room.map:3: the header promises 4 lines, but there are 1: the map may have been cut off"),
            std::string::npos)
      << map.notes[0];
}

TEST(GroundMap, whatIsMoreThanPromisedIsUsedAndReported) {
  const GroundMap map = parsed("2D-Map\nNumLines: 1\nLINES\n0 0 1000 0\n0 0 0 1000\n");
  EXPECT_EQ(map.lines.size(), 2U);
  ASSERT_EQ(map.notes.size(), 1U);
  EXPECT_NE(map.notes[0].find("all of them are used"), std::string::npos);
}

TEST(GroundMap, linesThatNoBuildingHasAreRefused) {
  std::string text = "2D-Map\nLINES\n";
  for (int i = 0; i < 99'900; ++i) text += "-9000000 -8000000 9000000 " + std::to_string(i * 10) + "\n";
  EXPECT_NE(errorsOf(text).find("more than 2000 km long, which no building's walls are"), std::string::npos);
}

TEST(GroundMap, theOriginOfAGeoreferencedMapIsRead) {
  const GroundMap map = parsed("2D-Map\nOriginLatLongAlt: 42.807191 -71.578661 72.000000\nDATA\n1 2\n");
  ASSERT_TRUE(map.origin);
  EXPECT_EQ(*map.origin, (GlobalPosition{42.807191, -71.578661, 72}));
  EXPECT_TRUE(map.notes.empty());
  EXPECT_FALSE(parsed("2D-Map\nDATA\n1 2\n").origin);
  const GroundMap wrong = parsed("2D-Map\nOriginLatLongAlt: 142 x\nDATA\n1 2\n");
  EXPECT_FALSE(wrong.origin);
  EXPECT_EQ(wrong.notes.size(), 1U);
}

TEST(GroundMap, filesOfOtherSystemsAreReadTheSame) {
  const std::string text =
      "2D-Map-Ex2\nCairn: Goal 1 2 0 \"\" ICON \"a b\"\n\nLINES\n0 0 1000 0\n\nDATA\n1 2\n";
  std::string other = "\xEF\xBB\xBF";
  for (const char c : text) other += c == '\n' ? std::string("  \r\n") : std::string(1, c);
  const GroundMap expected = parsed(text), map = parsed(other);
  EXPECT_EQ(map.lines, expected.lines);
  EXPECT_EQ(map.points, expected.points);
  EXPECT_EQ(map.places, expected.places);
}

TEST(GroundMap, allSensorsOfAMapCount) {
  const GroundMap map = parsed(
      "2D-Map-Ex\nSources: LMS TIM\nTIMMinPos: 0 0\nTIMNumPoints: 1\nLINES\n0 0 1 0\nDATA\n1 2\nTIM_LINES\n0 "
      "0 0 1\n"
      "2 2 3 3\nTIM_DATA\n5 6\n");
  EXPECT_EQ(map.lines.size(), 3U);
  EXPECT_EQ(map.points.size(), 2U);
}

TEST(GroundMap, whatIsLeftOutIsNotedOnceWithItsLine) {
  const GroundMap map = parsed(
      "2D-Map\nMapInfo: GoalType Name=Goal\nMapInfo: SectorType Name=BadGPS \"Label=a b\n"
      "PointsOfInterest: 42.8\n# a comment\nResolution: -5\nDATA\n1 2\n");
  EXPECT_EQ(map.resolution, 0.02);
  ASSERT_EQ(map.notes.size(), 3U);
  EXPECT_NE(map.notes[0].find("room.map:6: the resolution"), std::string::npos) << map.notes[0];
  EXPECT_NE(map.notes[1].find("room.map:2: MapInfo is not used, 2 entries"), std::string::npos)
      << map.notes[1];
  EXPECT_NE(map.notes[2].find("room.map:4: PointsOfInterest is not used"), std::string::npos) << map.notes[2];
}

TEST(GroundMap, namesInLatin1BecomeUtf8) {
  EXPECT_EQ(parsed(withCairn("Goal 0 0 0 \"\" ICON \"T\xFCr\"")).places[0].name, "T\xC3\xBCr");
  EXPECT_EQ(parsed(withCairn("Goal 0 0 0 \"\" ICON \"T\xC3\xBCr\"")).places[0].name, "T\xC3\xBCr");
}

TEST(GroundMap, boundsAreThoseOfWhatIsThere) {
  const auto bounds = parsed("2D-Map\nMaxPos: 9 9\nLINES\n-1000 0 2000 500\nDATA\n0 -3000\n").bounds();
  EXPECT_EQ(bounds.low, Vector2(-1, -3));
  EXPECT_EQ(bounds.high, Vector2(2, 0.5));
  const auto places = parsed("2D-Map\nCairn: Goal 1000 2000 0\nCairn: Goal 3000 -500 0\n").bounds();
  EXPECT_EQ(places.low, Vector2(1, -0.5));
  EXPECT_EQ(places.high, Vector2(3, 2));
  EXPECT_EQ(parsed("2D-Map\n").bounds().high, Vector2(0, 0));
}

TEST(GroundMap, whatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(errorsOf(""), "room.map: the file is empty: a map begins with '2D-Map'");
  EXPECT_NE(errorsOf("<sdf>\n").find("room.map:1:1: this is not a map"), std::string::npos);
  EXPECT_NE(errorsOf("2D-Map\nLINES\n0 0 1\n").find("room.map:3:1: a line of LINES must be four numbers"),
            std::string::npos);
  EXPECT_NE(errorsOf("2D-Map\nDATA\n 1 2 3\n").find("room.map:3:2: a line of DATA must be two numbers"),
            std::string::npos);
  EXPECT_NE(errorsOf("2D-Map\nDATA\n1 2x\n").find("two numbers"), std::string::npos);
  EXPECT_NE(errorsOf("2D-Map\nDATA\n1 200000000\n").find("room.map:3:3: a coordinate"), std::string::npos);
  EXPECT_NE(errorsOf("2D-Map\nDATA\n1 2\nnonsense\n").find("room.map:4:1: this is neither"),
            std::string::npos);
  EXPECT_NE(errorsOf("2D-Map\n17 4\n").find("room.map:2:1: this is neither"), std::string::npos);
  EXPECT_NE(errorsOf(withCairn("Goal 1 x 0")).find("room.map:2:15: a Cairn's pose"), std::string::npos);
  EXPECT_NE(errorsOf(withCairn("Goal 1 nan 0")).find("a Cairn's pose"), std::string::npos);
  EXPECT_NE(errorsOf(withCairn("Goal 1 2")).find("must have a type and a pose"), std::string::npos);
  EXPECT_NE(errorsOf(withCairn("Goal 1 2 0 \"\" ICON \"open")).find("room.map:2:27: a quote"),
            std::string::npos);
  EXPECT_NE(errorsOf(withCairn("ForbiddenLine 1 2 0 \"\" ICON \"\" 1 2 3")).find("must end in its corners"),
            std::string::npos);
}

TEST(GroundMap, aFileOfNonsenseGivesFewErrors) {
  std::string text = "2D-Map\n";
  for (int i = 0; i < 1000; ++i) text += "nonsense\n";
  const auto map = GroundMap::parse(text, "room.map");
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().size(), 20U);
  EXPECT_NE(map.error().back().text.find("not listed"), std::string::npos);
}

TEST(GroundMap, aFileThatIsNotThereIsAnError) {
  const auto map = GroundMap::load("/nowhere/at/all.map");
  ASSERT_FALSE(map);
  EXPECT_NE(describe(map.error()).find("/nowhere/at/all.map"), std::string::npos);
}

struct MapFile {
  std::filesystem::path file;
  std::size_t lines, points, places;
  Vector2 low, high;
};

class MapFiles : public testing::TestWithParam<MapFile> {};

TEST_P(MapFiles, areReadAsTheyAre) {
  const MapFile& expected = GetParam();
  if (!std::filesystem::exists(expected.file)) GTEST_SKIP() << "there is no real map " << expected.file;
  const auto map = GroundMap::load(expected.file);
  ASSERT_TRUE(map) << describe(map.error());
  EXPECT_EQ(map->lines.size(), expected.lines);
  EXPECT_EQ(map->points.size(), expected.points);
  EXPECT_EQ(map->places.size(), expected.places);
  EXPECT_EQ(map->resolution, 0.02);
  EXPECT_EQ(map->bounds().low, expected.low);
  EXPECT_EQ(map->bounds().high, expected.high);
  EXPECT_NE(map->find(Kind::kHome), nullptr);
}

INSTANTIATE_TEST_SUITE_P(
    GroundMap, MapFiles,
    testing::Values(MapFile{kRealMaps / "columbia.map", 470, 63311, 25, {-4.78, -27}, {19.56, 24.68}},
                    MapFile{kRealMaps / "office.map", 101, 0, 1, {0, 0}, {18.76, 14}},
                    MapFile{kRealMaps / "triangle.map", 9, 0, 1, {0, 0}, {10.26, 10.08}},
                    MapFile{kShippedMaps / "house.map", 80, 0, 9, {0, 0}, {16, 11}}),
    [](const auto& map) { return map.param.file.stem().string(); });

TEST(GroundMap, whatIsWrittenIsReadAsTheSame) {
  for (const char* file : {"columbia.map", "office.map"}) {
    if (!std::filesystem::exists(kRealMaps / file)) continue;
    const auto real = GroundMap::load(kRealMaps / file);
    ASSERT_TRUE(real) << describe(real.error());
    const auto back = GroundMap::parse(real->text(), file);
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(back->lines, real->lines);
    EXPECT_EQ(back->points, real->points);
    EXPECT_EQ(back->resolution, real->resolution);
    ASSERT_EQ(back->places.size(), real->places.size());
    for (std::size_t i = 0; i < real->places.size(); ++i) {
      EXPECT_EQ(back->places[i].type, real->places[i].type);
      EXPECT_EQ(back->places[i].name, real->places[i].name);
      EXPECT_EQ(back->places[i].extent, real->places[i].extent);
      EXPECT_EQ(back->places[i].pose.translation(), real->places[i].pose.translation());
      EXPECT_NEAR(back->places[i].pose.heading, real->places[i].pose.heading, radians(0.051));
    }
    EXPECT_EQ(back->origin.has_value(), real->origin.has_value());
    EXPECT_FALSE(back->incomplete);
  }
}

TEST(GroundMap, aMapThatWasNotReadHasTypesAndCountsInItsFile) {
  GroundMap map;
  map.points = {{1, -0.5}, {1.05, -0.5}};
  map.resolution = 0.05;
  GroundMap::Place& home = map.places.emplace_back();
  home.kind = Kind::kHome;
  home.name = "my \"home\"\n";
  home.pose = {0.5, 0, kPi / 2};
  GroundMap::Place& area = map.places.emplace_back();
  area.kind = Kind::kForbiddenArea;
  area.extent = {{0, 0}, {1, 1}};
  EXPECT_EQ(map.text(),
            "2D-Map\nMinPos: 1000 -500\nMaxPos: 1050 -500\nNumPoints: 2\nResolution: 50\n"
            "Cairn: RobotHome 500 0 90.0 \"\" ICON \"my  home  \"\n"
            "Cairn: ForbiddenArea 0 0 0.0 \"\" ICON \"\" 0 0 1000 1000\nDATA\n1000 -500\n1050 -500\n");
  EXPECT_EQ(parsed(map.text()).points, map.points);
  EXPECT_EQ(parsed(GroundMap().text()).lines.size(), 0U);
}
