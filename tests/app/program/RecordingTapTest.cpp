// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/RecordingTap.h"

#include <gmock/gmock.h>

#include <map>

#include "logplayer/file/LogFile.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/process/Sender.h"
#include "tests/TestFolder.h"
#include "tests/app/program/FakeProgram.h"

namespace app {
namespace {

using robotcontrol::ControlRecording;
using robotcontrol::Request;
using test::FakePlatform;
using test::FakeProgram;
using testing::ElementsAre;
using testing::IsEmpty;

class RecordingTapTest : public testing::Test {
 protected:
  RecordingTapTest() {
    platform_.frame = [this] {
      auto state = std::make_shared<robotcontrol::DriveState>();
      state->set_left_speed(++sent_);
      sender_.send(state);
    };
  }

  void attach(FakeProgram& program) { tap_.attach("red1", platform_, program, {}); }
  void control(ControlRecording::Action action, const std::string& only = {}) {
    ControlRecording control;
    control.set_action(action);
    if (action == ControlRecording::START) control.set_path(file_.string());
    if (!only.empty()) control.mutable_selection()->add_include(only);
    ASSERT_TRUE(recorder_.control(control));
  }
  /// A step of the platform in which it sends.
  void step() {
    clock_.advance(std::chrono::milliseconds(8));
    tap_.askForPackages();
    ASSERT_TRUE(platform_.tryBeginFrame());
    platform_.runFrame();
    tap_.endStep();
  }
  /// Ends the recording, and returns how many messages each stream has.
  std::map<std::string, std::uint64_t> written() {
    control(ControlRecording::STOP);
    recorder_.finish();
    std::map<std::string, std::uint64_t> counts;
    const auto log = logplayer::LogFile::open(file_, {});
    EXPECT_TRUE(log) << (log ? "" : log.error().describe());
    if (log)
      for (const auto& stream : (*log)->streams()) counts[stream.path] = stream.count;
    return counts;
  }
  /// The packages that were requested last; empty if none were.
  static std::vector<std::string> asked(const FakeProgram& program) {
    if (program.requests.empty()) return {};
    const auto& packages = program.requests.back().record_packages().packages();
    return {packages.begin(), packages.end()};
  }
  static Request choosing(const std::vector<std::string>& packages) {
    Request request;
    request.set_robot("red1");
    request.mutable_record_packages()->mutable_packages()->Assign(packages.begin(), packages.end());
    return request;
  }

  const TestFolder folder_;
  const std::filesystem::path file_ = folder_ / "tap.mcap";
  robotlink::ManualClock clock_;
  FakePlatform platform_{clock_};
  robotlink::Sender<robotcontrol::DriveState> sender_{platform_, "drive/state", robotlink::Blocking::kNo};
  double sent_ = 0;
  logplayer::Recorder recorder_{{}};
  RecordingTap tap_{recorder_};
};

TEST_F(RecordingTapTest, whatThePlatformSendsIsAFrameOfItsOwn) {
  FakeProgram program(clock_);
  attach(program);
  control(ControlRecording::START);
  for (int i = 0; i < 3; ++i) step();
  const auto counts = written();
  EXPECT_EQ(counts.at("red1/drive/state"), 3U);
  EXPECT_EQ(counts.at("red1/frames/platform"), 3U);
  EXPECT_EQ(counts.at("red1/program"), 1U) << "the setup";
}

TEST_F(RecordingTapTest, onlyTheSetupIsKeptWhileNothingIsRecorded) {
  FakeProgram program(clock_);
  attach(program);
  for (int i = 0; i < 3; ++i) step();
  control(ControlRecording::START);
  step();
  const auto counts = written();
  EXPECT_EQ(counts.at("red1/drive/state"), 1U);
  EXPECT_EQ(counts.at("red1/program"), 1U);
}

TEST_F(RecordingTapTest, packagesForDebuggingAreNotTapped) {
  robotlink::Sender<robotcontrol::DriveState> debug(platform_, "debug/queue", robotlink::Blocking::kNo);
  FakeProgram program(clock_);
  attach(program);
  control(ControlRecording::START);
  platform_.frame = [&] { debug.send(std::make_shared<robotcontrol::DriveState>()); };
  step();
  EXPECT_FALSE(written().contains("red1/debug/queue"));
}

TEST_F(RecordingTapTest, aNewProgramOnTheSamePlatformIsNotTappedTwice) {
  FakeProgram first(clock_), second(clock_);
  attach(first);
  attach(second);
  control(ControlRecording::START);
  step();
  EXPECT_EQ(written().at("red1/drive/state"), 1U);
}

TEST_F(RecordingTapTest, thePackagesOfTheRecorderAreRequestedWhenThatChanges) {
  FakeProgram program(clock_);
  program.yielded = {"ball/model", "percepts/ball"};
  attach(program);
  step();
  EXPECT_THAT(program.recorded, IsEmpty());
  EXPECT_THAT(program.requests, IsEmpty());
  control(ControlRecording::START, "red1/ball/*");
  step();
  EXPECT_THAT(asked(program), ElementsAre("ball/model"));
  EXPECT_EQ(program.requests.back().robot(), "red1");
  step();
  EXPECT_EQ(program.requests.size(), 1U) << "only once";
  control(ControlRecording::STOP);
  step();
  EXPECT_EQ(program.requests.size(), 2U);
  EXPECT_THAT(asked(program), IsEmpty());
}

TEST_F(RecordingTapTest, aProgramThatTakesNoRequestsIsAskedAgain) {
  FakeProgram program(clock_);
  program.yielded = {"ball/model"};
  attach(program);
  control(ControlRecording::START);
  program.isFull = true;
  step();
  EXPECT_THAT(program.requests, IsEmpty());
  program.isFull = false;
  step();
  EXPECT_THAT(asked(program), ElementsAre("ball/model"));
}

TEST_F(RecordingTapTest, aProgramBeginsWithThePackagesOfTheRecorder) {
  FakeProgram program(clock_);
  program.yielded = {"ball/model"};
  control(ControlRecording::START);
  attach(program);
  EXPECT_THAT(program.recorded, ElementsAre("ball/model"));
  step();
  EXPECT_THAT(program.requests, IsEmpty());
}

TEST_F(RecordingTapTest, whatTheUserChoseIsPublishedBesideWhatIsRecorded) {
  FakeProgram program(clock_);
  program.yielded = {"ball/model", "percepts/ball"};
  attach(program);
  control(ControlRecording::START, "red1/ball/*");
  step();
  EXPECT_TRUE(tap_.request("red1", choosing({"percepts/ball"})));
  EXPECT_THAT(asked(program), ElementsAre("ball/model", "percepts/ball"));
  control(ControlRecording::STOP);
  step();
  EXPECT_THAT(asked(program), ElementsAre("percepts/ball")) << "the user's choice stays";
}

TEST_F(RecordingTapTest, requestsAreRecordedIfTheProgramTakesThem) {
  FakeProgram program(clock_);
  attach(program);
  Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name("drawings");
  EXPECT_FALSE(tap_.request("blue1", request)) << "nobody of this name is attached";
  EXPECT_TRUE(tap_.request("red1", request));
  control(ControlRecording::START);
  EXPECT_TRUE(tap_.request("red1", request));
  program.isFull = true;
  EXPECT_FALSE(tap_.request("red1", request));
  step();
  EXPECT_EQ(written().at("red1/requests"), 1U) << "of those during the recording";
}

TEST_F(RecordingTapTest, afterClearNobodyIsAttached) {
  FakeProgram program(clock_);
  attach(program);
  tap_.clear();
  EXPECT_FALSE(tap_.request("red1", choosing({})));
  control(ControlRecording::START);
  step();
  EXPECT_FALSE(written().contains("red1/drive/state"));
}

TEST_F(RecordingTapTest, messagesOfTheWorldAreRecordedAsTheyCome) {
  control(ControlRecording::START);
  auto status = std::make_shared<robotcontrol::DriveState>();
  tap_.world({"weather", clock_.now(), status});
  EXPECT_TRUE(tap_.wants("weather"));
  EXPECT_EQ(written().at("weather"), 1U);
}

}  // namespace
}  // namespace app
