// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/ManualControl.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

using State = ManualControl::State;

TaskEntry behaviorTask(const char* active, const char* why = nullptr, const char* name = "behavior") {
  TaskEntry task;
  task.name = name;
  task.active = active;
  task.standard = "soccer";
  task.solutions.push_back({"soccer", {}, {}, false});
  task.solutions.push_back({ManualControl::kObey, {}, QString::fromUtf8(why), false});
  return task;
}

TEST(ManualControl, isTakenAndGivenBackToWhatRanBefore) {
  ManualControl control;
  EXPECT_EQ(control.state(), State::kUnknown);
  EXPECT_EQ(control.begin(true), "");
  control.update({behaviorTask("dance")});
  EXPECT_EQ(control.state(), State::kFree);
  EXPECT_EQ(control.task(), "behavior");
  EXPECT_EQ(control.begin(true), "obey");
  EXPECT_EQ(control.state(), State::kSwitching);
  control.update({behaviorTask("dance")});
  EXPECT_EQ(control.state(), State::kSwitching) << "not confirmed yet";
  control.update({behaviorTask("obey")});
  EXPECT_EQ(control.state(), State::kTaken);
  EXPECT_EQ(control.begin(true), "") << "nothing would change";
  EXPECT_EQ(control.begin(false), "dance");
}

TEST(ManualControl, whoFoundItTakenGivesItBackToTheDefault) {
  ManualControl control;
  control.update({behaviorTask("obey")});
  EXPECT_EQ(control.state(), State::kTaken);
  EXPECT_EQ(control.begin(false), "soccer");
}

TEST(ManualControl, saysWhyItCannotBeTaken) {
  ManualControl control;
  control.update({behaviorTask("soccer", "no motors")});
  EXPECT_EQ(control.state(), State::kUnavailable);
  EXPECT_EQ(control.text().toStdString(), "Cannot be taken over: no motors");
  EXPECT_EQ(control.begin(true), "");
  TaskEntry without = behaviorTask("soccer");
  without.solutions.pop_back();
  control.update({without});
  EXPECT_EQ(control.state(), State::kUnavailable);
  control.update({});
  EXPECT_EQ(control.state(), State::kUnknown);
}

TEST(ManualControl, aRefusalLeavesTheRobotToItself) {
  ManualControl control;
  control.update({behaviorTask("soccer")});
  control.begin(true);
  control.refused(QStringLiteral("it is busy"));
  EXPECT_EQ(control.state(), State::kFree);
  EXPECT_EQ(control.text().toStdString(), "Refused: it is busy");
}

TEST(ManualControl, findsTheTaskThatObeysWhateverItsName) {
  ManualControl control;
  TaskEntry first;
  first.name = "ball-percept";
  control.update({first, behaviorTask("soccer", nullptr, "driving")});
  EXPECT_EQ(control.task(), "driving");
}

}  // namespace
}  // namespace widgets
