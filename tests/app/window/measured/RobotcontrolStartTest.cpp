// SPDX-License-Identifier: GPL-3.0-or-later
// How long the real workbench takes to show its window with the layout of the last time.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <sstream>

#include "tests/TestFolder.h"
#include "tests/app/StartedProgram.h"
#include "tests/app/Watch.h"

namespace {

/// The processor time of a process that was not waited for yet, or of one of its threads ("task/123"), in s.
double cpuSecondsOf(pid_t process, const std::string& thread = {}) {
  std::ifstream file(std::filesystem::path("/proc") / std::to_string(process) / thread / "stat");
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::istringstream fields(text.substr(text.rfind(')') + 1));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;  // up to utime and stime, see proc(5)
  double user = 0, system = 0;
  EXPECT_TRUE(fields >> user >> system);
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

class RobotcontrolStart : public testing::Test {
 protected:
  static void SetUpTestSuite() { ::setenv("QT_QPA_PLATFORM", "offscreen", 1); }
  void SetUp() override {
    std::filesystem::create_directories(here_);
    std::filesystem::create_directories(home_);
    std::filesystem::permissions(home_, std::filesystem::perms::owner_all);  // as Qt demands it
    ::setenv("XDG_CONFIG_HOME", home_.c_str(), 1);
    ::setenv("XDG_RUNTIME_DIR", home_.c_str(), 1);
    ::setenv("HOME", home_.c_str(), 1);
  }
  /// A user shows some views and quits.
  void arrange() const {
    const Watch arranged(here_, IN_CREATE);
    StartedProgram first(ROBOTCONTROL, here_,
                         {"--command", "view.show plots", "--command", "view.show joints", "--command",
                          "screenshot window arranged.png"});
    ASSERT_TRUE(arranged.happens());
    first.send(SIGTERM);
    ASSERT_EQ(first.wait(), 0) << first.errors();
    ASSERT_TRUE(std::filesystem::exists(home_ / "robotcontrol" / "window.json"));
  }

  const TestFolder folder_;
  const std::filesystem::path here_ = folder_ / "here", home_ = folder_ / "home";
};

}  // namespace

/// The picture of the window is taken by the first events of the program, so that everything in the window
/// was painted when its file appears. Scenes are loaded in other threads meanwhile.
TEST_F(RobotcontrolStart, theWindowIsPaintedWithTheLastLayoutWithinASecond) {
  constexpr int kStarts = 5;
  constexpr double kLimit = 1;  // s
  ASSERT_NO_FATAL_FAILURE(arrange());
  for (int i = 0; i < kStarts; ++i) {
    const Watch pictures(here_, IN_CREATE);
    const auto begin = std::chrono::steady_clock::now();
    const std::string picture = (here_ / ("window" + std::to_string(i) + ".png")).string();
    StartedProgram workbench(ROBOTCONTROL, here_, {"--screenshot", picture, "--after", "0"});
    ASSERT_TRUE(pictures.happens());
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    const double window = cpuSecondsOf(workbench.pid(), "task/" + std::to_string(workbench.pid()));
    const double all = cpuSecondsOf(workbench.pid());
    std::printf("window painted after %.2f s; processor time %.2f s, of all threads %.2f s\n", wall.count(),
                window, all);
    std::fflush(stdout);
    EXPECT_GT(window, 0);
    EXPECT_LT(window, kLimit);
    EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  }
}
