// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/GanttFrames.h"

#include <gtest/gtest.h>

#include "tests/widgets/streams/StoredMessages.h"

namespace widgets::test {
namespace {

/// The times of a frame: of its tasks, and of the whole unless that is 0.
robotcontrol::StopwatchTimes frameTimes(std::initializer_list<double> tasks, double whole = 0) {
  robotcontrol::StopwatchTimes times;
  for (const double seconds : tasks) {
    auto& entry = *times.add_entries();
    entry.set_task("task" + std::to_string(times.entries_size()));
    entry.set_seconds(seconds);
  }
  if (whole > 0) times.add_entries()->set_seconds(whole);
  return times;
}

class GanttFramesTest : public testing::Test {
 protected:
  void addFrame(const char* path, double time, const robotcontrol::StopwatchTimes& times,
                std::uint64_t number = 0) {
    stored.store.add({path, atSeconds(time), std::make_shared<const robotcontrol::StopwatchTimes>(times),
                      "cognition", number});
  }
  std::vector<GanttLane> lanes(double from, double to, const std::map<std::string, double>& periods = {}) {
    return ganttLanes(stored.store, "red1", {atSeconds(from), atSeconds(to)}, periods);
  }

  StoredMessages stored;
};

constexpr char kCognition[] = "red1/stopwatches/cognition";

TEST_F(GanttFramesTest, eachProcessOfTheRobotHasALane) {
  addFrame("red1/stopwatches/motion", 1, frameTimes({0.001}));
  addFrame(kCognition, 1, frameTimes({0.01}));
  addFrame("red1/logged/stopwatches/cognition", 1, frameTimes({0.02}));
  addFrame("blue1/stopwatches/motion", 1, frameTimes({0.001}));
  const auto all = lanes(0, 2);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].process, "cognition (logged)");
  EXPECT_EQ(all[1].process, "cognition");
  EXPECT_EQ(all[2].process, "motion");
}

TEST_F(GanttFramesTest, aFrameLastsAsItSaysOrAsLongAsItsTasks) {
  addFrame(kCognition, 1, frameTimes({0.01, 0.02}, 0.05));
  addFrame(kCognition, 2, frameTimes({0.01, 0.02}));
  addFrame(kCognition, 3, frameTimes({}));
  const auto frames = lanes(0, 4).at(0).frames;
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_DOUBLE_EQ(frames[0].seconds, 0.05);
  EXPECT_DOUBLE_EQ(frames[1].seconds, 0.03);
  EXPECT_EQ(frames[2].seconds, 0);
}

TEST_F(GanttFramesTest, framesThatStillRunWhereTheStretchBeginsAreThere) {
  addFrame(kCognition, 8.5, frameTimes({0.4}));
  addFrame(kCognition, 9, frameTimes({1.5}));
  addFrame(kCognition, 12, frameTimes({0.1}));
  addFrame(kCognition, 12.5, frameTimes({0.1}));
  const auto lane = lanes(10, 12).at(0);
  ASSERT_EQ(lane.frames.size(), 2U);
  EXPECT_EQ(lane.frames[0].time, atSeconds(9));
  EXPECT_EQ(lane.frames[1].time, atSeconds(12)) << "the end belongs to it";
  EXPECT_TRUE(lanes(20, 30).at(0).frames.empty()) << "the lane stays, so that rows do not jump";
}

TEST_F(GanttFramesTest, overrunsAreCountedByThePeriodOfTheProcess) {
  for (int i = 0; i < 10; ++i)
    addFrame(kCognition, 1 + 0.04 * i, frameTimes({i % 5 == 4 ? 0.05 : 0.03}), 100 + i);
  const auto lane = lanes(0, 2, {{"cognition", 0.04}}).at(0);
  EXPECT_EQ(lane.overruns, 2U);
  EXPECT_FALSE(lane.frames[0].overruns());
  EXPECT_TRUE(lane.frames[4].overruns());
  EXPECT_EQ(lane.frames[4].number, 104U);
  EXPECT_NEAR(lane.rate, 25, 0.5);
}

TEST_F(GanttFramesTest, withoutAPeriodAFrameHasToEndBeforeTheNextOne) {
  for (int i = 0; i < 10; ++i) addFrame(kCognition, 1 + 0.1 * i, frameTimes({i == 7 ? 0.11 : 0.09}), i + 1);
  const auto lane = lanes(0, 3).at(0);
  EXPECT_EQ(lane.frames[0].period, 0) << "not known yet";
  EXPECT_NEAR(lane.frames[9].period, 0.1, 0.005);
  EXPECT_EQ(lane.overruns, 1U);
}

TEST_F(GanttFramesTest, theProcessIsTheLastPartOfThePath) {
  EXPECT_EQ(measuredProcess("red1/stopwatches/motion"), "motion");
  EXPECT_EQ(measuredProcess("red1/logged/stopwatches/motion"), "motion (logged)");
  EXPECT_EQ(measuredProcess("motion"), "motion");
}

}  // namespace
}  // namespace widgets::test
