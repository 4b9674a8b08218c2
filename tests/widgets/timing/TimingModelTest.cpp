// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/TimingModel.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"

namespace widgets {
namespace {

class TimingModelTest : public testing::Test {
 protected:
  /// A frame of the process "cognition" that takes 4 ms, and the task "ball" in it.
  void frame(std::uint64_t number, double time, double ball, const char* solution = "lines") {
    robotcontrol::StopwatchTimes times;
    auto& whole = *times.add_entries();
    whole.set_seconds(0.004);
    auto& task = *times.add_entries();
    task.set_task("ball");
    task.set_solution(solution);
    task.set_seconds(ball);
    model.add("cognition", number, robotlink::Instant(robotlink::fromSeconds(time)), times);
    model.update();
  }
  double number(int row, TimingModel::Column column) const {
    return model.data(model.index(row, column), TimingModel::kNumberRole).toDouble();
  }
  std::string text(int row, TimingModel::Column column) const {
    return model.data(model.index(row, column), Qt::DisplayRole).toString().toStdString();
  }

  TimingModel model;
};

TEST_F(TimingModelTest, sumsUpTheTimesOfATask) {
  frame(1, 0.00, 0.001);
  frame(2, 0.04, 0.003);
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(text(0, TimingModel::kTask), "frame");
  EXPECT_EQ(text(1, TimingModel::kTask), "ball");
  EXPECT_DOUBLE_EQ(number(1, TimingModel::kLast), 3);
  EXPECT_DOUBLE_EQ(number(1, TimingModel::kMean), 2);
  EXPECT_DOUBLE_EQ(number(1, TimingModel::kMinimum), 1);
  EXPECT_DOUBLE_EQ(number(1, TimingModel::kMax), 3);
  EXPECT_DOUBLE_EQ(number(1, TimingModel::kRate), 25);
  EXPECT_DOUBLE_EQ(number(1, TimingModel::kShare), 0.002 * 25);
  EXPECT_EQ(text(1, TimingModel::kShare), "5.00 %");
}

TEST_F(TimingModelTest, theRateCountsFramesThatWereNotPublished) {
  frame(1, 0.0, 0.001);
  frame(51, 2.0, 0.001);
  EXPECT_DOUBLE_EQ(number(0, TimingModel::kRate), 25);
}

TEST_F(TimingModelTest, aSolutionThatNoLongerRunsHasNeitherRateNorShare) {
  frame(1, 0.00, 0.001, "lines");
  frame(2, 0.04, 0.001, "regions");
  frame(3, 0.08, 0.001, "regions");
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(text(1, TimingModel::kRate), "");
  EXPECT_EQ(text(1, TimingModel::kShare), "");
  EXPECT_EQ(text(2, TimingModel::kRate), "25.0");
}

TEST_F(TimingModelTest, theRateStartsOverWhenTheClockGoesBack) {
  frame(100, 9.0, 0.001);
  frame(101, 9.04, 0.001);
  frame(1, 0.0, 0.001);
  EXPECT_DOUBLE_EQ(number(0, TimingModel::kRate), 0);
  frame(2, 0.1, 0.001);
  EXPECT_DOUBLE_EQ(number(0, TimingModel::kRate), 10);
}

TEST_F(TimingModelTest, tasksThatALayoutNoLongerHasAreRemoved) {
  frame(1, 0, 0.001);
  robotcontrol::ProcessTable program;
  program.add_processes()->set_name("cognition");
  model.keepOnly(program);
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(text(0, TimingModel::kTask), "frame");
  model.keepOnly({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST_F(TimingModelTest, percentilesSayHowLongMostFramesTake) {
  for (int i = 1; i <= 100; ++i) frame(static_cast<std::uint64_t>(i), i * 0.04, i * 1e-4);
  EXPECT_NEAR(number(1, TimingModel::kMedian), 5, 0.1);
  EXPECT_NEAR(number(1, TimingModel::kNinetyFive), 9.5, 0.2);
  EXPECT_NEAR(number(1, TimingModel::kNinetyNine), 9.9, 0.2);
}

TEST_F(TimingModelTest, framesThatTakeLongerThanTheyMayAreOverruns) {
  robotcontrol::ProcessTable program;
  auto& process = *program.add_processes();
  process.set_name("cognition");
  process.add_tasks("ball");
  model.keepOnly(program);
  // It has no period: 4 ms are too long only where the next frame comes after 2 ms.
  for (int i = 1; i <= 10; ++i) frame(static_cast<std::uint64_t>(i), i * 0.04, 0.003);
  EXPECT_EQ(text(0, TimingModel::kOverruns), "0");
  for (int i = 11; i <= 2010; ++i) frame(static_cast<std::uint64_t>(i), 0.4 + (i - 10) * 0.002, 0.003);
  EXPECT_GT(number(0, TimingModel::kOverruns), 1000);
  EXPECT_EQ(number(1, TimingModel::kOverruns), number(0, TimingModel::kOverruns)) << "it took longest";
  // With a period of 10 ms they are not.
  process.set_period(0.01);
  model.keepOnly(program);
  model.reset();
  for (int i = 2011; i <= 2020; ++i) frame(static_cast<std::uint64_t>(i), 5 + (i - 2010) * 0.002, 0.003);
  EXPECT_EQ(text(0, TimingModel::kOverruns), "0");
}

TEST_F(TimingModelTest, jitterIsHowMuchThePeriodsDiffer) {
  frame(1, 0.000, 0.001);
  EXPECT_EQ(text(0, TimingModel::kJitter), "") << "one frame has no period";
  frame(2, 0.030, 0.001);
  frame(3, 0.080, 0.001);
  for (const int row : {0, 1}) {
    EXPECT_NEAR(number(row, TimingModel::kPeriodMinimum), 30, 1e-9);
    EXPECT_NEAR(number(row, TimingModel::kPeriodMax), 50, 1e-9);
    EXPECT_NEAR(number(row, TimingModel::kJitter), 10, 1e-9);
  }
  EXPECT_EQ(text(1, TimingModel::kJitter), "10.000");
}

TEST_F(TimingModelTest, whatWasNotPublishedOrRunIsNoPeriod) {
  frame(1, 0.00, 0.001, "lines");
  frame(2, 0.04, 0.001, "regions");
  frame(3, 0.08, 0.001, "lines");
  frame(9, 0.32, 0.001, "lines");  // frames 4 to 8 were not published
  frame(1, 0.10, 0.001, "lines");  // a reset
  frame(2, 0.14, 0.001, "lines");
  EXPECT_NEAR(number(0, TimingModel::kPeriodMax), 40, 1e-9);
  EXPECT_NEAR(number(1, TimingModel::kPeriodMax), 40, 1e-9);
  EXPECT_EQ(text(2, TimingModel::kPeriodMax), "") << "regions ran in one frame only";
}

TEST_F(TimingModelTest, theTableIsWrittenWithItsUnits) {
  frame(1, 0.00, 0.001);
  frame(2, 0.04, 0.001);
  EXPECT_EQ(model.csv().toStdString(),
            "process,task,solution,last_ms,mean_ms,min_ms,median_ms,p95_ms,p99_ms,max_ms,hz,period_min_ms,"
            "period_max_ms,period_deviation_ms,overruns,share\n"
            "cognition,frame,,4,4,4,4,4,4,4,25,40,40,0,0,0.1\n"
            "cognition,ball,lines,1,1,1,1,1,1,1,25,40,40,0,0,0.025\n");
  model.reset();
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace widgets
