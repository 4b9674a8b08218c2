// SPDX-License-Identifier: GPL-3.0-or-later
// The robot program's perception on logged images, with a color table that was made for them and the pose of
// the camera that was logged: of a real robot, and of a made game.
#include <gtest/gtest.h>

#include <cmath>

#include "colortool/image/ClassPresets.h"
#include "colortool/table/ColorTableFile.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Geometry.h"
#include "tests/game/Data.h"
#include "tests/game/View.h"
#include "tests/modules/perception/LoggedRobot.h"

using namespace modules;

namespace {

/// In the pictures of labels.
constexpr std::uint8_t kOrange = 1;

struct LabeledBall {
  robotlink::Vector2 center;
  double radius = 0;
};

/// The ball as somebody drew it; nothing if the image shows none.
std::optional<LabeledBall> labeledBall(const std::filesystem::path& data, int image) {
  char name[64];
  std::snprintf(name, sizeof name, "colour/bhuman2009/labels/%03d.png", image);
  const std::string bytes = robotlink::readFile(data / name).value();
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

struct Solutions {
  const char* segmentation;
  const char* ballPercept;
};

/// The log and the labels of a source.
class ImagesOf {
 protected:
  bool load(const std::string& source) {
    data_ = game::dataOf(source);
    auto& views = read_[source];
    if (views.empty() && std::filesystem::exists(data_ / "colour/bhuman2009/labels"))
      views = readViews((data_ / "logs/bhuman2009.log").string());
    views_ = &views;
    real_ = source == "real";
    return !views.empty();
  }
  const LoggedView& view(int image) const { return views_->at(static_cast<std::size_t>(image)); }
  robotcontrol::ColorTable madeTable() const {
    const auto file = colortool::ColorTableFile::load(data_ / "colour/bhuman2009/tables/default.c64").value();
    robotcontrol::ColorTable table;
    for (const std::string& name : colortool::findClassPreset("bhuman2009")->classes().names())
      table.add_class_names(name);
    const auto cells = file.singleClasses();
    table.set_cells(cells.data(), cells.size());
    return table;
  }
  /// The images with labels; two of them show the ball.
  std::vector<int> labeled() const { return real_ ? std::vector{0, 32, 66} : std::vector{0, 5, 11}; }

  /// Read once for all tests.
  static inline std::map<std::string, std::vector<LoggedView>> read_;
  std::filesystem::path data_;
  std::vector<LoggedView>* views_ = nullptr;
  bool real_ = false;
};

/// The parameter is the source.
class LoggedImages : public ImagesOf, public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!load(GetParam())) GTEST_SKIP() << "the real log and its labels are not below " << data_;
  }
};

class LabeledImages : public ImagesOf, public testing::TestWithParam<std::tuple<Solutions, std::string>> {
 protected:
  void SetUp() override {
    if (!load(std::get<1>(GetParam()))) GTEST_SKIP() << "the real log and its labels are not below " << data_;
  }
  const Solutions& solutions() const { return std::get<0>(GetParam()); }
};

}  // namespace

TEST_P(LabeledImages, theBallIsFoundWhereSomebodyDrewIt) {
  LoggedRobot robot(solutions().segmentation, solutions().ballPercept);
  ASSERT_EQ(robot.setColorTable(madeTable()), "");
  int shown = 0;
  for (const int image : labeled()) {
    const auto percept = robot.look(view(image));
    const auto ball = labeledBall(data_, image);
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

TEST_P(LoggedImages, theBallIsFollowedOverTheLog) {
  LoggedRobot robot("whole-image", "region");
  ASSERT_EQ(robot.setColorTable(madeTable()), "");
  int seen = 0, jumps = 0;
  std::optional<robotlink::Vector2> last;
  // The robot stands, turns its head and walks straight to the ball, which lies still.
  const int count = real_ ? 27 : game::View::kCount - 1;
  for (int i = 0; i < count; ++i) {
    const auto percept = robot.look(view(i));
    if (!percept.seen()) continue;
    ++seen;
    const robotlink::Vector2 place(percept.position_in_robot().x(), percept.position_in_robot().y());
    jumps += last && (place - *last).norm() > 0.25 ? 1 : 0;
    last = place;
  }
  EXPECT_GE(seen, count - 1);
  EXPECT_EQ(jumps, 0);
  ASSERT_TRUE(last);
  EXPECT_NEAR(last->x(), 1.1, 0.2);
}

TEST_P(LoggedImages, tablesTakeEffectAtTheNextImage) {
  LoggedRobot robot("whole-image", "region");
  const LoggedView& withBall = view(labeled()[real_ ? 2 : 1]);
  const auto orangeRegions = [&] {
    robot.look(withBall);
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
  EXPECT_FALSE(robot.look(withBall).seen());

  ASSERT_EQ(robot.setColorTable(madeTable()), "");
  EXPECT_GT(orangeRegions(), 0);
  EXPECT_TRUE(robot.look(withBall).seen());

  ASSERT_EQ(robot.setColorTable({}), "") << "takes it back";
  EXPECT_EQ(orangeRegions(), generated);
}

TEST_P(LoggedImages, classesGoByTheirNames) {
  LoggedRobot robot("whole-image", "region");
  // The same table with its classes in another order.
  robotcontrol::ColorTable reversed = madeTable();
  const int count = reversed.class_names_size();
  for (int i = 0; i < count / 2; ++i) reversed.mutable_class_names()->SwapElements(i, count - 1 - i);
  for (char& cell : *reversed.mutable_cells())
    if (cell != 0) cell = static_cast<char>(count + 1 - cell);
  ASSERT_EQ(robot.setColorTable(madeTable()), "");
  robot.look(view(0));
  const std::string expected = robot.regions().SerializeAsString();
  ASSERT_EQ(robot.setColorTable(reversed), "");
  robot.look(view(0));
  EXPECT_EQ(robot.regions().SerializeAsString(), expected);
}

TEST_P(LoggedImages, tablesThatCannotBeUsedAreRefused) {
  LoggedRobot robot("whole-image", "region");
  robotcontrol::ColorTable table;
  table.add_class_names("orange");
  table.set_cells("short");
  EXPECT_EQ(robot.setColorTable(table), "a color table has 262144 cells, this one has 5");
  table.set_cells(std::string(64 * 64 * 64, '\2'));
  EXPECT_EQ(robot.setColorTable(table), "cells of the color table have classes without a name");
}

INSTANTIATE_TEST_SUITE_P(Data, LoggedImages, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

INSTANTIATE_TEST_SUITE_P(All, LabeledImages,
                         testing::Combine(testing::Values(Solutions{"whole-image", "region"},
                                                          Solutions{"whole-image", "circle-fit"},
                                                          Solutions{"scan-lines", "region"},
                                                          Solutions{"scan-lines", "circle-fit"}),
                                          testing::ValuesIn(game::kSources)),
                         [](const auto& parameters) {
                           const Solutions& solutions = std::get<0>(parameters.param);
                           std::string name = std::string(solutions.segmentation) + "_" +
                                              solutions.ballPercept + "_" + std::get<1>(parameters.param);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });
