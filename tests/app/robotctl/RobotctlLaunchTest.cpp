// SPDX-License-Identifier: GPL-3.0-or-later
// robotctl launch and robotctl run --program as their users start them, with a simulated Pioneer.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>

#include "tests/Eventually.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

using testing::HasSubstr;

/// robotctl as a child; all that it prints in order.
class Launched {
 public:
  explicit Launched(std::vector<std::string> arguments) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    arguments.insert(arguments.begin(), ROBOTCTL);
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(ends[1], 1);
      ::dup2(ends[1], 2);
      ::execv(words[0], words.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    output_ = ends[0];
  }
  ~Launched() {
    if (process_ > 0) {
      send(SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
    ::close(output_);
  }
  Launched(const Launched&) = delete;
  Launched& operator=(const Launched&) = delete;

  /// Waits for a line with this text after those that were found; empty if none comes.
  std::string lineWith(const std::string& text) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
      const auto newline = pending_.find('\n');
      if (newline == std::string::npos) {
        if (!readMore()) break;
        continue;
      }
      const std::string line = pending_.substr(0, newline);
      pending_.erase(0, newline + 1);
      all_ += line + "\n";
      if (line.find(text) != std::string::npos) return line;
    }
    return {};
  }
  void send(int signal) const { ::kill(process_, signal); }
  /// Waits for its end; its exit status. One that neither ends nor says anything for a minute is killed.
  int finish() {
    while (readMore()) {
    }
    if (isSilent_) send(SIGKILL);
    all_ += std::exchange(pending_, {});
    int status = -1;
    ::waitpid(std::exchange(process_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  const std::string& all() const { return all_; }

 private:
  bool readMore() {
    pollfd ready{output_, POLLIN, 0};
    char bytes[4096];
    isSilent_ = ::poll(&ready, 1, 60'000) <= 0;
    if (isSilent_) return false;
    const auto count = ::read(output_, bytes, sizeof bytes);
    if (count > 0) pending_.append(bytes, static_cast<std::size_t>(count));
    return count > 0;
  }

  pid_t process_ = 0;
  int output_ = -1;
  std::string pending_, all_;
  bool isSilent_ = false;
};

std::string domain() {
  return std::to_string(1 + ::getpid() % 200);
}

pid_t processIn(const std::string& line) {
  const std::string before = "as process ";
  return std::stoi(line.substr(line.find(before) + before.size()));
}

class RobotctlLaunchTest : public testing::Test {
 protected:
  void SetUp() override {
    const std::string line = world_.lineWith("p3at1 listens at tcp://127.0.0.1:");
    ASSERT_FALSE(line.empty()) << world_.all();
    robot_ = line.substr(line.find("tcp://"));
  }
  Launched world_{{"sim", ROBOTCONTROL_SOURCE_DIR "/resources/scenes/pioneer.sdf", "--arcos", "0"}};
  std::string robot_;
};

TEST_F(RobotctlLaunchTest, aProgramThatIsKilledIsNamedTheOthersGoOnAndItRejoins) {
  Launched launched(
      {"launch", "pioneer-programs", "--platform", robot_, "--dds-domain", domain(), "--texts"});
  const std::string plan = launched.lineWith("Program plan runs as process");
  ASSERT_FALSE(plan.empty()) << launched.all();
  ASSERT_FALSE(launched.lineWith("Program plan runs.").empty()) << launched.all();
  ::kill(processIn(plan), SIGKILL);
  const std::string ended = launched.lineWith("Program plan was ended by signal 9");
  EXPECT_THAT(ended, HasSubstr("the others continue. To restart it: robotctl run"));
  ASSERT_FALSE(launched.lineWith("Program plan is no longer running").empty()) << launched.all();
  Launched again({"run", "--layout", "pioneer-programs", "--program", "plan", "--local", "--platform", robot_,
                  "--dds-domain", domain()});
  EXPECT_FALSE(launched.lineWith("Program plan runs again.").empty()) << launched.all();
  EXPECT_FALSE(again.lineWith("The program with the platform runs.").empty()) << again.all();
  launched.send(SIGINT);
  EXPECT_EQ(130, launched.finish()) << "as one of its programs had crashed: " << launched.all();
  EXPECT_THAT(launched.all(), HasSubstr("drive: "));
  again.send(SIGINT);
  EXPECT_EQ(0, again.finish()) << again.all();
}

TEST_F(RobotctlLaunchTest, theProgramsEndWithTheirLauncher) {
  Launched launched({"launch", "pioneer-programs", "--platform", robot_, "--dds-domain", domain()});
  const pid_t drive = processIn(launched.lineWith("Program drive runs as process"));
  const pid_t plan = processIn(launched.lineWith("Program plan runs as process"));
  ASSERT_FALSE(launched.lineWith("Packages between programs go over the loopback interface").empty());
  launched.send(SIGKILL);
  // Their parent is then whoever takes care of orphans, which may take its time to look.
  const auto hasEnded = [](pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string number, name, state;
    file >> number >> name >> state;
    return !file || state == "Z";
  };
  EXPECT_TRUE(eventually([&] { return hasEnded(drive) && hasEnded(plan); }));
}

/// A robot with a camera, of which only the body is in the scene.
TEST(RobotctlLaunchCameraTest, theBodyOfACameraRobotIsDrivenByTwoProgramsAndStandsWhileOneIsMissing) {
  Launched body({"platform", "field2002", "--listen", "0"});
  const std::string line = body.lineWith(" at ws://");
  ASSERT_FALSE(line.empty()) << body.all();
  const std::string url = line.substr(line.find("ws://"));
  Launched launched({"launch", "ers210-programs", "--platform", url, "--dds-domain", domain(), "--texts"});
  const std::string think = launched.lineWith("Program think runs as process");
  ASSERT_FALSE(think.empty()) << launched.all();
  ASSERT_FALSE(launched.lineWith("Program think runs.").empty()) << launched.all();
  const std::vector<std::string> words{"run",          "--layout", "ers210-programs", "--program",
                                       "think",        "--local",  "--platform",      url,
                                       "--dds-domain", domain()};
  Launched second(words);
  EXPECT_EQ(1, second.finish());
  EXPECT_THAT(second.all(), HasSubstr("program think of red1 runs already, as process " +
                                      std::to_string(processIn(think)) + " on "));
  Launched states({"watch", url, "--csv", "red1/body/state"});
  const auto goesOn = [&] { return !states.lineWith(",false,false,").empty(); };
  const auto stands = [&] { return !states.lineWith(",false,true,").empty(); };
  EXPECT_THAT(states.lineWith("time,"), HasSubstr(",stop_engaged,stands,"));
  ASSERT_TRUE(goesOn()) << states.all();
  ::kill(processIn(think), SIGKILL);
  EXPECT_TRUE(stands()) << "it does not go on by what was decided last: " << states.all();
  ASSERT_FALSE(launched.lineWith("Program think is no longer running").empty()) << launched.all();
  Launched again(words);
  EXPECT_FALSE(launched.lineWith("Program think runs again.").empty()) << launched.all() << again.all();
  EXPECT_FALSE(again.lineWith("The program with the platform runs.").empty()) << again.all();
  EXPECT_TRUE(goesOn()) << states.all();
  again.send(SIGINT);
  EXPECT_EQ(0, again.finish()) << again.all();
  launched.send(SIGINT);
  launched.finish();
  EXPECT_THAT(launched.all(), HasSubstr("move: commands"));
}

TEST(RobotctlLaunchErrorsTest, wrongProgramsAndLayoutsAreRefusedWithTheirPlace) {
  const auto folder = std::filesystem::temp_directory_path() / ("launch" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto unknown =
      runRobotctl(folder, "run --layout pioneer-programs --platform tcp://localhost:1 --program plans");
  EXPECT_EQ(1, unknown.status);
  EXPECT_THAT(unknown.errors, HasSubstr("pioneer-programs.yaml: layout pioneer-programs has no program "
                                        "'plans'; did you mean 'plan'?"));
  const auto none = runRobotctl(folder, "launch pioneer --platform tcp://localhost:1");
  EXPECT_EQ(1, none.status);
  EXPECT_THAT(none.errors, HasSubstr("pioneer.yaml: layout pioneer names no programs"));
  std::string text = textOf(ROBOTCONTROL_SOURCE_DIR "/resources/layouts/pioneer-programs.yaml");
  for (const std::string name : {"drive", "plan"}) {
    const std::string line = "  - name: " + name + "\n    processes";
    const auto at = text.find(line);
    ASSERT_NE(std::string::npos, at);
    text.replace(at, line.size(), "  - name: " + name + "\n    host: 203.0.113.254\n    processes");
  }
  std::ofstream(folder / "far.yaml") << text;
  const auto far = runRobotctl(folder, "run --layout far.yaml --platform tcp://localhost:1 --program plan");
  EXPECT_EQ(1, far.status);
  EXPECT_THAT(far.errors,
              HasSubstr("program plan belongs to 203.0.113.254: no network interface of this machine has it; "
                        "start it there, or all programs here with --local"));
  EXPECT_THAT(far.errors, HasSubstr("far.yaml:"));
  std::filesystem::remove_all(folder);
}

}  // namespace
