// SPDX-License-Identifier: GPL-3.0-or-later
// Real signals end the real workbench: its recording is complete, and nothing else is left.
#include <gmock/gmock.h>

#include <csignal>

#include "logplayer/file/LogFile.h"
#include "tests/TestFolder.h"
#include "tests/app/StartedProgram.h"
#include "tests/app/Watch.h"

namespace {

using testing::Not;
using testing::SizeIs;

class WorkbenchSignals : public testing::TestWithParam<int> {
 protected:
  static void SetUpTestSuite() { ::setenv("QT_QPA_PLATFORM", "offscreen", 1); }
  void SetUp() override {
    std::filesystem::create_directories(here_);
    std::filesystem::create_directories(home_);
    ::setenv("XDG_CONFIG_HOME", home_.c_str(), 1);
    ::setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);  // its socket is not what tests wait for
    ::setenv("HOME", home_.c_str(), 1);
  }

  /// The workbench with the field, and with what it is told at the start.
  StartedProgram started(const std::vector<std::string>& commands) const {
    std::vector<std::string> arguments;
    for (const std::string& command : commands) {
      arguments.emplace_back("--command");
      arguments.push_back(command);
    }
    return {ROBOTCONTROL, here_, arguments};
  }
  std::vector<std::filesystem::path> left() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(here_)) files.push_back(entry.path());
    return files;
  }
  static void expectComplete(const std::filesystem::path& file) {
    const auto log = logplayer::LogFile::open(file, {});
    ASSERT_TRUE(log) << file << ": " << log.error().describe();
    EXPECT_TRUE((*log)->complete()) << file;
    EXPECT_THAT((*log)->damage(), SizeIs(0)) << file;
    EXPECT_THAT((*log)->streams(), Not(SizeIs(0))) << file;
  }

  const TestFolder folder_;
  const std::filesystem::path here_ = folder_ / "here", home_ = folder_ / "home";
};

TEST_P(WorkbenchSignals, aRecordingIsComplete) {
  const Watch watch(here_, IN_MODIFY);
  StartedProgram workbench = started({"recording.start-file " + (here_ / "out.mcap").string()});
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(watch.happens());  // some of it is written
  workbench.send(GetParam());
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  ASSERT_THAT(left(), SizeIs(1));
  expectComplete(here_ / "out.mcap");
}

TEST_P(WorkbenchSignals, whatIsOnlyKeptInMemoryLeavesNothing) {
  const Watch watch(here_, IN_CREATE);
  StartedProgram workbench =
      started({"recording.folder " + here_.string(), "recording.keep 30",
               "recording.start-file " + (home_ / "begun.mcap").string(), "recording.stop"});
  const Watch begun(home_, IN_CREATE);
  ASSERT_TRUE(begun.happens());  // it runs
  workbench.send(GetParam());
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  EXPECT_THAT(left(), SizeIs(0));
}

TEST_P(WorkbenchSignals, theLastSecondsThatAreBeingSavedAreComplete) {
  const Watch watch(here_, IN_CREATE);
  StartedProgram workbench =
      started({"recording.folder " + here_.string(), "recording.keep 30", "recording.trigger red1/camera/*"});
  ASSERT_TRUE(watch.happens());  // the first image has them saved
  workbench.send(GetParam());
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  for (const auto& file : left()) expectComplete(file);
}

INSTANTIATE_TEST_SUITE_P(All, WorkbenchSignals, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& tested) { return std::string(sigabbrev_np(tested.param)); });

// A terminal that is closed and a session that ends may both say so.
TEST_F(WorkbenchSignals, signalsOfSeveralKindsAreNoHurry) {
  const Watch watch(here_, IN_MODIFY);
  StartedProgram workbench = started({"recording.start-file " + (here_ / "out.mcap").string()});
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(watch.happens());
  for (const int signal : {SIGHUP, SIGTERM, SIGINT}) workbench.send(signal);
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  expectComplete(here_ / "out.mcap");
}

}  // namespace
