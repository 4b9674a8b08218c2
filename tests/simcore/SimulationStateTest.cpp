// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/SimulationState.h"

#include <gtest/gtest.h>

#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// Counts so many steps, with a touch in each of them or without.
void pass(TouchCount& count, int steps, bool touches) {
  for (int i = 0; i < steps; ++i) count.afterStep(touches);
}

TEST(TouchCountTest, aTouchThatLastsIsOneButEachOfItsStepsIsCounted) {
  TouchCount count;
  EXPECT_EQ(count.count(), 0U);
  pass(count, 40, true);
  EXPECT_EQ(count.count(), 1U);
  EXPECT_EQ(count.steps(), 40U);
}

TEST(TouchCountTest, theFirstStepMayBeATouch) {
  TouchCount count;
  pass(count, 1, true);
  EXPECT_EQ(count.count(), 1U);
}

TEST(TouchCountTest, touchesOfOneMomentAreOneAndLaterOnesAreOthers) {
  TouchCount count;
  pass(count, 1, true);
  pass(count, 20, false);
  pass(count, 1, true);
  pass(count, 20, false);
  pass(count, 1, true);
  EXPECT_EQ(count.count(), 1U) << "each is soon after the last one";
  pass(count, 30, false);
  pass(count, 1, true);
  EXPECT_EQ(count.count(), 2U);
  EXPECT_EQ(count.steps(), 4U);
}

TEST(TouchCountTest, touchesATenthOfASecondApartAreTwo) {
  const auto touchesApart = [](int steps) {
    TouchCount count;
    pass(count, 1, true);
    pass(count, steps - 1, false);
    pass(count, 1, true);
    return count.count();
  };
  EXPECT_EQ(touchesApart(24), 1U);
  EXPECT_EQ(touchesApart(25), 2U);
}

TEST(TouchCountTest, aMomentGoesOnBehindASnapshot) {
  TouchCount count;
  pass(count, 1, true);
  pass(count, 15, false);
  std::vector<std::uint8_t> bytes;
  StateStream out(bytes);
  count.transfer(out);
  TouchCount restored;
  StateStream in(bytes, StateStream::Trust::kForeign);
  restored.transfer(in);
  EXPECT_TRUE(in.complete());
  pass(restored, 5, false);
  pass(restored, 1, true);
  EXPECT_EQ(restored.count(), 1U);
  EXPECT_EQ(restored.steps(), 2U);
}

TEST(TimedSensorTest, itHasAClockOnlyIfItsSamplesAreTimed) {
  TimedSensor sensor({{{.stddev = 1}}}, "red1/eye");
  EXPECT_FALSE(sensor.clock);
  sensor.set({.delay = 0.1});
  ASSERT_TRUE(sensor.clock);
  EXPECT_GT(sensor.clock->delay(), 0U);
  sensor.set({});
  EXPECT_FALSE(sensor.clock) << "what is set later replaces it";
  EXPECT_EQ(sensor.errors.delay, 0);
}

TEST(TimedSensorTest, itMeasuresAtLeastOnceASecond) {
  EXPECT_EQ(TimedSensor({.rate = 0.2}, "red1/eye").errors.rate, 1);
  EXPECT_EQ(TimedSensor({.rate = 30}, "red1/eye").errors.rate, 30);
  EXPECT_EQ(TimedSensor({}, "red1/eye").errors.rate, 0) << "in each step";
}

TEST(TimedSensorTest, sensorsLoseDifferentSamples) {
  const TimedSensor left({.dropout = 0.5}, "red1/left"), right({.dropout = 0.5}, "red1/right"),
      again({.dropout = 0.5}, "red1/left");
  int different = 0;
  for (std::uint64_t step = 0; step < 100; ++step) {
    const bool isTaken = left.clock->sampleAt(1, step).has_value();
    EXPECT_EQ(again.clock->sampleAt(1, step).has_value(), isTaken);
    if (right.clock->sampleAt(1, step).has_value() != isTaken) ++different;
  }
  EXPECT_GT(different, 20);
}

}  // namespace
}  // namespace simcore
