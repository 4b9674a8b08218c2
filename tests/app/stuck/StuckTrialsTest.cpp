// SPDX-License-Identifier: GPL-3.0-or-later
// Trials whose programs have a module that never returns.
#include <gmock/gmock.h>

#include <sstream>

#include "app/core/platform/ProgramTroubles.h"
#include "app/core/program/Abandoned.h"
#include "app/platforms/simulated/BallTrials.h"
#include "robotcontrol/Hosting.pb.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/stuck/StuckSolution.h"

namespace app {
namespace {

using test::StuckSolution;

/// Its module returns at the end, whatever the test has found.
class StuckTrials : public testing::Test {
 protected:
  StuckTrials() { StuckSolution::prepare(true); }
  ~StuckTrials() override {
    StuckSolution::release();
    EXPECT_TRUE(eventually([] { return abandonedCount() == 0; }));
  }

  /// Exists until what was abandoned is gone.
  std::ostringstream out_;
};

TEST_F(StuckTrials, goOnWithoutTheRobotAndEndWhileItsModuleHangs) {
  const TestFolder folder;
  const auto troubles = std::make_shared<ProgramTroubles>(out_);
  BallTrials trials;
  trials.run = defaultSimulation();
  trials.run.layout = StuckSolution::writeLayout(folder.path());
  trials.run.patience = std::chrono::milliseconds(200);
  trials.run.world.blackout = true;
  trials.listeners.hosting = [troubles](const std::string& robot, robotlink::Instant,
                                        const robotcontrol::HostingStatus& status) {
    troubles->note(robot, status);
  };
  trials.count = 2;
  trials.seconds = 0.2;
  const auto played = trials.play();
  ASSERT_TRUE(played) << robotlink::describe(played.error());
  EXPECT_EQ(played->size(), 2U);
  ASSERT_EQ(troubles->all().size(), 1U);
  EXPECT_THAT(troubles->all().front().text, testing::HasSubstr("stuck-test (hang) of process stuck"));
  EXPECT_EQ(StuckSolution::hanging, 1);
  EXPECT_EQ(abandonedCount(), 1);
}

}  // namespace
}  // namespace app
