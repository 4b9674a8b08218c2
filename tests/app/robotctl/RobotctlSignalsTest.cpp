// SPDX-License-Identifier: GPL-3.0-or-later
// Real signals end real programs: promptly, with complete files or none.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <vector>

#include "logplayer/file/LogFile.h"
#include "tests/app/StartedProgram.h"
#include "tests/app/Watch.h"
#include "tests/app/robotctl/RobotctlRun.h"
#include "tests/logplayer/SampleLog.h"

namespace {

using logplayer::SampleLog;
using logplayer::TestFolder;
using testing::HasSubstr;
using testing::Not;

/// robotctl, started in a folder.
class Program : public StartedProgram {
 public:
  Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments, int ignored = 0)
      : StartedProgram(ROBOTCTL, folder, arguments, {.ignored = ignored}) {}
};

class Signals : public testing::TestWithParam<int> {
 protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<TestFolder>();
    SampleLog log;
    log.frames = 40'000;
    log.write(*shared_ / "a.mcap");
    log.start = std::chrono::hours(1);
    log.robot = "red2";
    log.write(*shared_ / "b.mcap");
  }
  static void TearDownTestSuite() { shared_.reset(); }
  void SetUp() override { std::filesystem::create_directory(here_); }
  void TearDown() override { std::filesystem::remove_all(here_); }

  /// What is left in the folder.
  std::string left() const {
    std::string names;
    for (const auto& entry : std::filesystem::directory_iterator(here_))
      names += entry.path().filename().string() + " ";
    return names;
  }
  static bool isComplete(const std::filesystem::path& file) {
    const auto log = logplayer::LogFile::open(file, {});
    return log && (*log)->complete() && (*log)->damage().empty();
  }

  static std::unique_ptr<TestFolder> shared_;
  const std::filesystem::path here_ = *shared_ / "here";
};

std::unique_ptr<TestFolder> Signals::shared_;

TEST_P(Signals, whatWritesAFileLeavesNothingOfIt) {
  const std::vector<std::vector<std::string>> commands{
      {"log", "cut", "../a.mcap", "out.mcap"},
      {"log", "repair", "../a.mcap", "out.mcap"},
      {"log", "filter", "../a.mcap", "out.mcap", "--exclude", "red1/log"},
      {"log", "merge", "../a.mcap", "../b.mcap", "out.mcap"},
      {"log", "export", "../a.mcap", "--csv", "red1/models/ball", "out.csv"},
      {"log", "export", "../a.mcap", "--texts", "--output", "out.txt"}};
  for (const auto& command : commands) {
    const Watch watch(here_, IN_CREATE);
    Program program(here_, command);
    ASSERT_TRUE(watch.happens()) << command[1];
    program.send(GetParam());
    EXPECT_EQ(program.wait(), 128 + GetParam()) << command[1];
    EXPECT_EQ(left(), "") << command[1];
  }
}

TEST_P(Signals, aSimulationThatIsRecordedClosesItsFile) {
  const Watch watch(here_, IN_MODIFY);
  Program program(here_,
                  {"sim", kScene, "--seconds", "1000", "--speed", "1", "--json", "--record", "out.mcap"});
  // While the scene is loaded there is nothing to keep yet.
  std::error_code none;
  while (std::filesystem::file_size(here_ / "out.mcap", none) < 10'000 || none) ASSERT_TRUE(watch.happens());
  program.send(GetParam());
  EXPECT_EQ(program.wait(), 128 + GetParam());
  EXPECT_THAT(program.text(), HasSubstr("simulated_seconds"));
  EXPECT_TRUE(isComplete(here_ / "out.mcap"));
}

TEST_P(Signals, aSlowSimulationThatIsRecordedClosesItsFile) {
  // It waits for eight seconds before its second step.
  const Watch watch(here_, IN_MODIFY);
  Program program(here_, {"sim", kScene, "--speed", "0.001", "--json", "--record", "out.mcap"});
  std::error_code none;
  while (std::filesystem::file_size(here_ / "out.mcap", none) < 1000 || none) ASSERT_TRUE(watch.happens());
  program.send(GetParam());
  EXPECT_EQ(program.wait(), 128 + GetParam());
  EXPECT_THAT(program.text(), HasSubstr("simulated_seconds"));
  EXPECT_TRUE(isComplete(here_ / "out.mcap"));
}

TEST_P(Signals, aReplayThatIsRecordedClosesItsFile) {
  ASSERT_EQ(Program(here_, {"sim", kScene, "--seconds", "5", "--record", "../game.mcap"}).wait(), 0);
  const Watch watch(here_, IN_CREATE);
  Program program(here_, {"run", "--platform", "log:../game.mcap", "--package", "percepts/ball=recomputed",
                          "--record", "out.mcap"});
  ASSERT_TRUE(watch.happens());
  program.send(GetParam());
  EXPECT_EQ(program.wait(), 128 + GetParam());
  EXPECT_TRUE(isComplete(here_ / "out.mcap"));
  std::filesystem::remove(here_ / "../game.mcap");
}

TEST_P(Signals, theNextOfSeveralFilesIsNotLookedAt) {
  for (const char* command : {"info", "verify"}) {
    const Watch watch(*shared_ / "a.mcap", IN_OPEN);
    Program program(here_, {"log", command, "../a.mcap", "../b.mcap", "../a.mcap"});
    ASSERT_TRUE(watch.happens());
    program.send(GetParam());
    EXPECT_EQ(program.wait(), 128 + GetParam());
    EXPECT_THAT(program.text(), Not(HasSubstr("b.mcap")));
  }
}

TEST_P(Signals, whoReadsNothingOfTheOutputDoesNotHoldItUp) {
  const Watch watch(*shared_ / "a.mcap", IN_OPEN);
  Program program(here_, {"log", "export", "../a.mcap", "--csv", "red1/models/ball", "-"});
  ASSERT_TRUE(watch.happens());
  program.send(GetParam());
  EXPECT_EQ(program.waitUnread(), 128 + GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, Signals, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& tested) { return std::string(sigabbrev_np(tested.param)); });

using OtherSignals = Signals;

TEST_F(OtherSignals, whatWasToBeIgnoredIsIgnored) {
  const Watch watch(here_, IN_CREATE);
  Program program(here_, {"log", "cut", "../a.mcap", "out.mcap"}, SIGHUP);
  ASSERT_TRUE(watch.happens());
  program.send(SIGHUP);
  EXPECT_EQ(program.wait(), 0);
  EXPECT_TRUE(isComplete(here_ / "out.mcap"));
}

TEST_F(OtherSignals, trialsEndWithThoseThatWerePlayed) {
  const auto errors = *shared_ / "errors";
  std::ofstream(errors).close();
  const Watch watch(errors, IN_MODIFY);
  Program program(here_, {"sim", kScene, "--trials", "100000", "--seconds", "0.1"});
  do ASSERT_TRUE(watch.happens());
  while (std::filesystem::file_size(errors) == 0);  // its beginning is a change, too
  program.send(SIGTERM);
  EXPECT_EQ(program.wait(), 128 + SIGTERM);
  EXPECT_THAT(program.text(), HasSubstr("touched the ball"));
}

TEST_F(OtherSignals, whereNothingIsToBeClosedTheProgramEndsAtOnce) {
  // It waits for a writer of a pipe that has a name.
  ASSERT_EQ(::mkfifo((here_ / "pipe.yaml").c_str(), 0600), 0);
  const Watch watch(here_, IN_OPEN);
  Program program(here_, {"layout", "check", "pipe.yaml"});
  const int writer = ::open((here_ / "pipe.yaml").c_str(), O_WRONLY | O_CLOEXEC);  // opened by both: it reads
  ASSERT_GE(writer, 0);
  program.send(SIGTERM);
  EXPECT_EQ(program.wait(), 128 + SIGTERM);
  ::close(writer);
}

TEST_F(OtherSignals, aReaderThatEndsFirstIsNoError) {
  const std::string command =
      std::string("cd '") + here_.string() + "' && " + ROBOTCTL +
      " log export ../a.mcap --csv red1/models/ball - 2>../errors | head -n 1 >/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(textOf(*shared_ / "errors"), "");
}

TEST_F(OtherSignals, outputThatDoesNotArriveIsAnError) {
  for (const char* arguments : {"--help", "--version", "log info a.mcap", "log info --json a.mcap",
                                "log verify a.mcap", "log export a.mcap --csv red1/models/ball -",
                                "log export a.mcap --texts", "log cut a.mcap here/out.mcap --to 1"}) {
    const std::string command = std::string("cd '") + shared_->path().string() + "' && " + ROBOTCTL + " " +
                                arguments + " >/dev/full 2>errors";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1) << arguments;
    EXPECT_THAT(textOf(*shared_ / "errors"), HasSubstr("cannot write to standard output")) << arguments;
  }
}

}  // namespace
