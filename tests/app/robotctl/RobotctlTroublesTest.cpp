// SPDX-License-Identifier: GPL-3.0-or-later
// Programs of robots that end or hang in a simulation that goes on.
#include <gmock/gmock.h>

#include <cctype>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/StartedProgram.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The process that another one has started; 0: none.
pid_t childOf(pid_t parent) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (std::isdigit(static_cast<unsigned char>(name.front())) == 0) continue;
    const std::string stat = textOf(entry.path() / "stat");
    // "4711 (robotctl) S 4700 ..."; the name in parentheses may be anything.
    const std::size_t end = stat.rfind(')');
    if (end == std::string::npos || stat.size() < end + 4) continue;
    if (std::stol(stat.substr(end + 4)) == parent) return static_cast<pid_t>(std::stol(name));
  }
  return 0;
}

/// A simulation with a robot whose program runs in a process of its own.
class RobotctlTroubles : public testing::Test {
 protected:
  RobotctlTroubles() { std::filesystem::create_directory(folder_ / "here"); }
  /// Starts it, sends that process a signal when `begun` was printed, and waits for the end of the
  /// simulation.
  void play(std::vector<std::string> arguments, const std::string& begun, int signal) {
    arguments.insert(arguments.begin(), {"sim", kScene, "--own-process", "red1", "--patience", "0.5"});
    StartedProgram program(ROBOTCTL, folder_ / "here", arguments);
    ASSERT_TRUE(eventually([&] { return program.errors().find(begun) != std::string::npos; }))
        << program.errors();
    const pid_t child = childOf(program.pid());
    ASSERT_NE(child, 0);
    ASSERT_EQ(::kill(child, signal), 0);
    status_ = program.wait();
    text_ = program.text();
    errors_ = program.errors();
  }

  const TestFolder folder_;
  int status_ = -1;
  std::string text_, errors_;
};

TEST_F(RobotctlTroubles, aProgramThatEndsIsALossThatIsNamed) {
  play({"--speed", "1", "--seconds", "2", "--progress", "--json"}, " s\n", SIGKILL);
  EXPECT_EQ(status_, 3);
  EXPECT_THAT(errors_, HasSubstr("red1: The program of red1 was killed"));
  const auto troubles = json::parse(text_)["troubles"];
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_EQ(troubles[0]["robot"], "red1");
  EXPECT_THAT(troubles[0]["text"], HasSubstr("was killed"));
}

TEST_F(RobotctlTroubles, aProgramThatHangsIsNamedAndTheGameGoesOn) {
  play({"--speed", "1", "--seconds", "2", "--progress", "--json"}, " s\n", SIGSTOP);
  EXPECT_EQ(status_, 3);
  EXPECT_THAT(errors_, HasSubstr("red1: The program of red1 has not answered for"));
  EXPECT_EQ(json::parse(text_)["troubles"].size(), 1U);
}

TEST_F(RobotctlTroubles, theConsoleOfOneThatIsServedNamesItToo) {
  play({"--listen", "127.0.0.1:0", "--seconds", "2"}, " at ws:", SIGKILL);
  EXPECT_EQ(status_, 3);
  EXPECT_THAT(errors_, HasSubstr("red1: The program of red1 was killed"));
}

TEST(RobotctlTrials, withoutTroubleThereIsNone) {
  const TestFolder folder;
  const auto outcome = runRobotctl(folder.path(), "sim " + kScene + " --trials 1 --seconds 0.1 --json");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(json::parse(outcome.out)["troubles"], json::array());
}

}  // namespace
