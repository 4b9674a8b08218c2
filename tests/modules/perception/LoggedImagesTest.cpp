// SPDX-License-Identifier: GPL-3.0-or-later
// The robot program's perception on the images of a real robot, with the color table that its team made and
// the pose of the camera that it logged.
#include <gtest/gtest.h>

#include <cmath>

#include "colortool/table/ColorTableFile.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Geometry.h"
#include "tests/modules/perception/LoggedRobot.h"

using namespace modules;

namespace {

const std::string kData = ROBOTCONTROL_SOURCE_DIR "/../shared/data/";
/// In the pictures of labels.
constexpr std::uint8_t kOrange = 1;

struct LabeledBall {
  robotlink::Vector2 center;
  double radius = 0;
};

std::string labelFile(int image) {
  char name[64];
  std::snprintf(name, sizeof name, "colour/bhuman2009/labels/%03d.png", image);
  return kData + name;
}

/// The ball as somebody drew it; nothing if the image shows none.
std::optional<LabeledBall> labeledBall(int image) {
  const std::string bytes = robotlink::readFile(labelFile(image)).value();
  const auto labels =
      logplayer::decodePng({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}).value();
  robotlink::Vector2 sum = robotlink::Vector2::Zero();
  int count = 0;
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x)
      if (labels.row(y)[x] == kOrange) {
        sum += robotlink::Vector2(x + 0.5, y + 0.5);
        ++count;
      }
  if (count == 0) return std::nullopt;
  return LabeledBall{sum / count, std::sqrt(count / robotlink::kPi)};
}

robotcontrol::ColorTable realTable() {
  const auto file = colortool::ColorTableFile::load(kData + "colour/bhuman2009/tables/default.c64").value();
  robotcontrol::ColorTable table;
  for (const auto name : colortool::ColorTableFile::kBHuman2009Classes)
    table.add_class_names(std::string(name));
  const auto cells = file.singleClasses();
  table.set_cells(cells.data(), cells.size());
  return table;
}

struct Solutions {
  const char* segmentation;
  const char* ballPercept;
};

class LoggedImages : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (std::filesystem::exists(labelFile(0))) views_ = readViews(kData + "logs/bhuman2009.log");
  }
  void SetUp() override {
    if (views_.empty()) GTEST_SKIP() << "the real log and its labels are not below " << kData;
  }

  static inline std::vector<LoggedView> views_;
};

class LabeledImages : public LoggedImages, public testing::WithParamInterface<Solutions> {};

}  // namespace

TEST_P(LabeledImages, theBallIsFoundWhereSomebodyDrewIt) {
  LoggedRobot robot(GetParam().segmentation, GetParam().ballPercept);
  ASSERT_EQ(robot.setColorTable(realTable()), "");
  int shown = 0;
  for (const int image : {0, 32, 66}) {
    const auto percept = robot.look(views_[static_cast<std::size_t>(image)]);
    const auto ball = labeledBall(image);
    ASSERT_EQ(percept.seen(), ball.has_value()) << "image " << image;
    if (!ball) continue;
    ++shown;
    const robotlink::Vector2 found(percept.center_in_image().x(), percept.center_in_image().y());
    RecordProperty("offBy" + std::to_string(image), std::to_string((found - ball->center).norm()));
    EXPECT_LT((found - ball->center).norm(), 10) << "image " << image << " at " << found.transpose();
    EXPECT_NEAR(percept.radius_in_image(), ball->radius, 0.25 * ball->radius + 1) << "image " << image;
  }
  EXPECT_EQ(shown, 2);
  EXPECT_TRUE(robot.failures().empty());
}

TEST_F(LoggedImages, theBallIsFollowedOverTheLog) {
  LoggedRobot robot("whole-image", "region");
  ASSERT_EQ(robot.setColorTable(realTable()), "");
  int seen = 0, jumps = 0;
  std::optional<robotlink::Vector2> last;
  // The robot stands, turns its head and walks straight to the ball, which lies still.
  for (std::size_t i = 0; i < 27; ++i) {
    const auto percept = robot.look(views_[i]);
    if (!percept.seen()) continue;
    ++seen;
    const robotlink::Vector2 place(percept.position_in_robot().x(), percept.position_in_robot().y());
    jumps += last && (place - *last).norm() > 0.25 ? 1 : 0;
    last = place;
  }
  EXPECT_GE(seen, 26);
  EXPECT_EQ(jumps, 0);
  ASSERT_TRUE(last);
  EXPECT_NEAR(last->x(), 1.1, 0.2);
}

TEST_F(LoggedImages, tablesTakeEffectAtTheNextImage) {
  LoggedRobot robot("whole-image", "region");
  const auto orangeRegions = [&] {
    robot.look(views_[66]);
    int count = 0;
    for (const auto& region : robot.regions().regions())
      count += robot.regions().class_names(static_cast<int>(region.color_class())) == "orange" ? 1 : 0;
    return count;
  };
  const int generated = orangeRegions();

  robotcontrol::ColorTable allGreen;
  allGreen.add_class_names("green");
  allGreen.set_cells(std::string(64 * 64 * 64, '\1'));
  ASSERT_EQ(robot.setColorTable(allGreen), "");
  EXPECT_EQ(orangeRegions(), 0);
  EXPECT_EQ(robot.regions().regions_size(), 1) << "the image is one region";
  EXPECT_FALSE(robot.look(views_[66]).seen());

  ASSERT_EQ(robot.setColorTable(realTable()), "");
  EXPECT_GT(orangeRegions(), 0);
  EXPECT_TRUE(robot.look(views_[66]).seen());

  ASSERT_EQ(robot.setColorTable({}), "") << "takes it back";
  EXPECT_EQ(orangeRegions(), generated);
}

TEST_F(LoggedImages, classesGoByTheirNames) {
  LoggedRobot robot("whole-image", "region");
  // The same table with its classes in another order.
  robotcontrol::ColorTable reversed = realTable();
  const int count = reversed.class_names_size();
  for (int i = 0; i < count / 2; ++i) reversed.mutable_class_names()->SwapElements(i, count - 1 - i);
  for (char& cell : *reversed.mutable_cells())
    if (cell != 0) cell = static_cast<char>(count + 1 - cell);
  ASSERT_EQ(robot.setColorTable(realTable()), "");
  robot.look(views_[0]);
  const std::string expected = robot.regions().SerializeAsString();
  ASSERT_EQ(robot.setColorTable(reversed), "");
  robot.look(views_[0]);
  EXPECT_EQ(robot.regions().SerializeAsString(), expected);
}

TEST_F(LoggedImages, tablesThatCannotBeUsedAreRefused) {
  LoggedRobot robot("whole-image", "region");
  robotcontrol::ColorTable table;
  table.add_class_names("orange");
  table.set_cells("short");
  EXPECT_EQ(robot.setColorTable(table), "a color table has 262144 cells, this one has 5");
  table.set_cells(std::string(64 * 64 * 64, '\2'));
  EXPECT_EQ(robot.setColorTable(table), "cells of the color table have classes without a name");
}

INSTANTIATE_TEST_SUITE_P(
    All, LabeledImages,
    testing::Values(Solutions{"whole-image", "region"}, Solutions{"whole-image", "circle-fit"},
                    Solutions{"scan-lines", "region"}, Solutions{"scan-lines", "circle-fit"}),
    [](const auto& solutions) {
      std::string name = std::string(solutions.param.segmentation) + "_" + solutions.param.ballPercept;
      std::ranges::replace(name, '-', '_');
      return name;
    });
