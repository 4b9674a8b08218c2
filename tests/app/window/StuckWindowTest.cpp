// SPDX-License-Identifier: GPL-3.0-or-later
// The real workbench ends although a module of a robot's program never returns.
#include <gtest/gtest.h>

#include <csignal>

#include "tests/TestFolder.h"
#include "tests/app/StartedProgram.h"
#include "tests/app/Watch.h"

namespace {

TEST(StuckWindow, theWorkbenchEndsAlthoughAModuleNeverReturns) {
  const TestFolder folder;
  const auto here = folder / "here";
  std::filesystem::create_directories(here);
  const auto layout = folder.write("stuck.yaml",
                                   "version: 1\nname: stuck\nhelp: A process that hangs.\nprocesses:\n"
                                   "  - {name: stuck, blocking: [joints/states], tasks: [stuck-test: hang]}\n"
                                   "  - {name: debug, debug: true, period_ms: 16}\n");
  ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
  ::setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
  ::setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1);
  ::setenv("HOME", folder.path().c_str(), 1);
  ::setenv("STUCK_FILE", (here / "stuck").c_str(), 1);
  const Watch watch(here, IN_CREATE);
  StartedProgram workbench(STUCK_ROBOTCONTROL, here, {"--layout", layout.string()});
  ASSERT_TRUE(watch.happens()) << workbench.errors();
  workbench.send(SIGTERM);
  // Otherwise it would never end, and the time limit of the test would.
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
}

}  // namespace
