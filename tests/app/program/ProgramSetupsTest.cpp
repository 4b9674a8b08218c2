// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramSetups.h"

#include <gtest/gtest.h>

#include "robotlink/debugging/SharedDebugQueue.h"

TEST(ProgramSetups, parametersOfProgramsThatBeginLaterAreAdded) {
  robotcontrol::ProgramSetup setup;
  robotlink::SharedDebugQueue queue;
  auto& values = queue.add<robotcontrol::ParameterValues>("parameters/path-planning/grid");
  values.set_file("/home/me/grid.textproto");
  values.set_task("path-planning");
  values.set_solution("grid");
  values.mutable_value()->set_data("new");
  EXPECT_TRUE(app::follow(setup, queue.messages.front()));
  ASSERT_EQ(setup.parameters_size(), 1);
  EXPECT_EQ(setup.parameters(0).solution(), "grid");
  EXPECT_EQ(setup.parameters(0).file(), "") << "it names a folder of whoever recorded";
  EXPECT_FALSE(app::follow(setup, queue.messages.front())) << "nothing new";
}
