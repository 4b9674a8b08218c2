// SPDX-License-Identifier: GPL-3.0-or-later
// Tables scored exactly by `robotctl`, on simulated images with their true classes.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "colortool/image/ClassPresets.h"
#include "colortool/table/NamedColorTable.h"
#include "colortool/table/PaletteTable.h"
#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

class RobotctlTruth : public testing::Test {
 protected:
  RobotctlOutcome robotctl(const std::string& arguments) const {
    return runRobotctl(folder_.path(), arguments);
  }
  /// A table of the field's colors as t.c64, with the names of its classes.
  void writeTable() const {
    colortool::NamedColorTable table;
    table.classes = colortool::findClassPreset("2002")->classes();
    std::vector<colortool::NamedColor> palette;
    for (int i = 1; i < table.classes.size(); ++i)
      palette.push_back({table.classes.name(i), table.classes.shownColor(i)});
    const colortool::ColorTable made = colortool::paletteTable(palette, table.classes);
    table.file.cells.assign(made.cells().begin(), made.cells().end());
    ASSERT_TRUE(table.save(folder_ / "t.c64"));
  }
  json evaluated(const std::string& arguments) const {
    const RobotctlOutcome outcome = robotctl("color evaluate --table t.c64 --json " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }
  TestFolder folder_;
};

}  // namespace

TEST_F(RobotctlTruth, labeledImagesAreFilesThatATableIsScoredAgainst) {
  const RobotctlOutcome sim =
      robotctl("sim " + kScene + " --seconds 1.1 --labelled-images labelled --images-every 0.5 --digest");
  ASSERT_EQ(sim.status, 0) << sim.errors;
  EXPECT_THAT(sim.errors, HasSubstr("3 images with their true classes"));
  EXPECT_EQ(sim.out, robotctl("sim " + kScene + " --seconds 1.1 --digest").out) << "nothing else is changed";
  for (const char* part : {"labelled/images", "labelled/labels"}) {
    for (const char* name : {"red1-000040.png", "red1-000520.png", "red1-001000.png"})
      EXPECT_TRUE(std::filesystem::exists(folder_ / part / name)) << part << "/" << name;
  }
  writeTable();
  const json scores = evaluated("--images labelled/images --labels labelled/labels");
  EXPECT_GT(scores["recall"]["orange"], 0.95);
  EXPECT_GT(scores["recall"]["green"], 0.95);
  EXPECT_GT(scores["recall"]["skyblue"], 0.9);
}

TEST_F(RobotctlTruth, aLogWithClassImagesHoldsItsOwnLabels) {
  ASSERT_EQ(robotctl("sim " + kScene + " --seconds 0.5 --class-images --record game.mcap").status, 0);
  writeTable();
  const json asIs = evaluated("--images game.mcap --labels game.mcap");
  EXPECT_GT(asIs["recall"]["orange"], 0.95);
  EXPECT_GT(asIs["mean_recall"], 0.9);
  const std::string dark = " --light 0.5 --warmth 0.5 --vignetting 0.4 0.1 --image-noise 6";
  ASSERT_EQ(
      robotctl("sim " + kScene + " --seconds 0.5 --class-images --images jpeg --record dark.mcap" + dark)
          .status,
      0);
  const json other = evaluated("--images dark.mcap --labels dark.mcap");
  EXPECT_LT(other["mean_recall"], asIs["mean_recall"]);
}

TEST_F(RobotctlTruth, whatCannotBeDoneIsSaid) {
  ASSERT_EQ(robotctl("sim " + kScene + " --seconds 0.1 --record without.mcap").status, 0);
  writeTable();
  const RobotctlOutcome without =
      robotctl("color evaluate --table t.c64 --images without.mcap --labels without.mcap");
  EXPECT_EQ(without.status, 1);
  EXPECT_THAT(without.errors,
              HasSubstr("without.mcap: no image has true classes here: record with --class-images"));
  const RobotctlOutcome other = robotctl("color evaluate --table t.c64 --images . --labels without.mcap");
  EXPECT_EQ(other.status, 1);
  std::ofstream(folder_ / "file") << "x";
  const RobotctlOutcome sim = robotctl("sim " + kScene + " --seconds 0.1 --labelled-images file");
  EXPECT_EQ(sim.status, 1);
  EXPECT_THAT(sim.errors, HasSubstr("file/images: cannot make this folder for labeled images"));
  for (const char* wrong : {"--light 11", "--light -1", "--warmth 2", "--vignetting 1.5", "--image-noise -1",
                            "--image-noise 3 --no-noise", "--vignetting 0.1 0.2 0.3", "--images-every 1",
                            "--trials 1 --labelled-images x"}) {
    EXPECT_EQ(robotctl("sim " + kScene + " --seconds 0.1 " + wrong).status, 2) << wrong;
  }
}
