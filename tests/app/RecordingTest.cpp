// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of simulated robots, as their platforms, programs and requests make them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "app/core/Recording.h"
#include "app/core/program/RecordingTap.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "tests/Eventually.h"
#include "tests/logplayer/RecordedMessages.h"

using namespace app;
using logplayer::tests::ReadLog;
using logplayer::tests::TestFolder;
using robotcontrol::ControlRecording;
using robotcontrol::ProgramSetup;
using robotcontrol::Request;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

class RecordingTest : public ::testing::Test {
 protected:
  /// The file is "a.mcap", unless it is started later.
  void make(bool recordFromTheStart, ExecutorKind executor = ExecutorKind::kLockstep) {
    RunOptions options = defaultSimulation();
    options.hosting.threads = executor == ExecutorKind::kThreads;
    recorder = std::make_unique<logplayer::Recorder>(logplayer::Recorder::Options{});
    if (recordFromTheStart) start("a.mcap");
    SimulatedRun::Listeners listeners;
    listeners.queue = [this](const std::string&, const auto& queue) {
      reported += toWire(*queue).ByteSizeLong();
      if (queue->process == "cognition") ++thoughts;
      for (const auto& message : queue->messages) models += message.path == "models/ball" ? 1 : 0;
    };
    auto made = SimulatedRun::create(options, std::move(listeners), recorder.get());
    ASSERT_TRUE(made.has_value());
    run = std::move(*made);
  }
  ~RecordingTest() override { run.reset(); }

  void start(const std::string& name) {
    ControlRecording control;
    control.set_action(ControlRecording::START);
    control.set_path(folder / name);
    ASSERT_TRUE(recorder->control(control).has_value());
  }
  ReadLog stop(const std::string& name = "a.mcap") {
    ControlRecording control;
    control.set_action(ControlRecording::STOP);
    EXPECT_TRUE(recorder->control(control).has_value());
    recorder->finish();
    return logplayer::tests::readLog(folder / name);
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) run->step();
  }
  static Request select(const std::string& task, const std::string& solution) {
    Request request;
    request.set_robot("red1");
    request.mutable_select_solution()->set_task(task);
    request.mutable_select_solution()->set_solution(solution);
    return request;
  }

  TestFolder folder;
  std::unique_ptr<logplayer::Recorder> recorder;
  std::unique_ptr<SimulatedRun> run;
  std::atomic<std::size_t> reported{0};
  std::atomic<int> thoughts{0};  // queues of frames of cognition
  std::atomic<int> models{0};    // of the ball
};

template <typename T>
T parsed(const ReadLog::Entry& entry) {
  T value;
  EXPECT_TRUE(value.ParseFromString(entry.data)) << entry.path;
  return value;
}

std::vector<ReadLog::Entry> on(const ReadLog& log, const std::string& path) {
  std::vector<ReadLog::Entry> result;
  std::copy_if(log.entries.begin(), log.entries.end(), std::back_inserter(result),
               [&](const auto& entry) { return entry.path == path; });
  return result;
}

/// Frames that lack their end, or whose end is not last.
std::vector<std::string> brokenFrames(const ReadLog& log) {
  std::vector<std::string> broken;
  std::map<std::string, std::uint32_t> open;  // process: frame
  for (const auto& entry : log.entries) {
    if (entry.frame == 0) continue;
    const bool ends = entry.type == "robotcontrol.FrameInfo";
    const auto [at, isNew] = open.try_emplace(entry.process, entry.frame);
    if (at->second != entry.frame)
      broken.push_back(entry.process + " " + std::to_string(entry.frame) + " " + entry.path);
    if (ends) open.erase(at);
  }
  for (const auto& [process, frame] : open)
    broken.push_back(process + " " + std::to_string(frame) + " has no end");
  return broken;
}

}  // namespace

TEST_F(RecordingTest, aLogShowsTheWorldAsTheSimulationDid) {
  make(true);
  ASSERT_TRUE(run);
  steps(60);
  const ReadLog log = stop();
  for (const char* latched : {"scene", "solids", "objects"}) EXPECT_GE(log.count(latched), 1U) << latched;
  // 30 times a second, and measured from the step on after which somebody wants them.
  EXPECT_EQ(log.count("transforms"), 15U);
  EXPECT_EQ(log.count("forces"), 14U);
  const auto forces = std::ranges::find(log.entries, "forces", &ReadLog::Entry::path);
  ASSERT_NE(forces, log.entries.end());
  robotcontrol::WorldForces value;
  ASSERT_TRUE(value.ParseFromString(forces->data));
  EXPECT_GT(value.joints_size(), 0);
  EXPECT_GT(value.contacts_size(), 0);
}

TEST_F(RecordingTest, whoDoesNotRecordMeasuresNoForces) {
  make(false);
  ASSERT_TRUE(run);
  steps(20);
  EXPECT_TRUE(run->world().simulation().forces().contacts.empty());
}

TEST_F(RecordingTest, everyStepOfThePlatformIsAFrameAtFullRate) {
  make(true);
  steps(250);
  const ReadLog log = stop();
  const auto ends = on(log, "red1/frames/platform");
  ASSERT_EQ(ends.size(), 250U);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    EXPECT_EQ(ends[i].frame, i + 1);
    EXPECT_EQ(ends[i].time, robotlink::Instant(std::chrono::milliseconds(8 * (i + 1))));
  }
  for (const char* path : {"red1/joints/states", "red1/body/sensors", "red1/oracle/world"})
    EXPECT_EQ(log.count(path), 250U) << path;
  EXPECT_EQ(log.count("red1/camera/image"), 50U);
  EXPECT_EQ(log.count("scene"), 1U);
  EXPECT_NEAR(static_cast<double>(log.count("transforms")), 250.0 / 4, 1);
  EXPECT_THAT(brokenFrames(log), ElementsAre());
}

TEST_F(RecordingTest, whatTheTasksYieldIsThereFromTheFirstFrameThoughNobodyAskedForIt) {
  make(true);
  steps(125);
  const ReadLog log = stop();
  EXPECT_EQ(log.count("red1/joints/request"), log.count("red1/frames/motion"));
  for (const char* path : {"red1/percepts/ball", "red1/models/ball", "red1/models/pose",
                           "red1/behavior/motion", "red1/motion/status"}) {
    const auto entries = on(log, path);
    ASSERT_FALSE(entries.empty()) << path;
    EXPECT_LE(entries.front().time, robotlink::Instant(std::chrono::milliseconds(50))) << path;
  }
}

TEST_F(RecordingTest, recordingChangesNothingAndIsTheSameEveryTime) {
  std::vector<ReadLog> logs;
  std::set<std::uint64_t> digests;
  for (int i = 0; i < 3; ++i) {
    make(i > 0);
    steps(125);
    digests.insert(run->world().digest());
    if (i > 0) logs.push_back(stop());
    run.reset();
    std::filesystem::remove(folder / "a.mcap");
  }
  EXPECT_EQ(digests.size(), 1U);
  ASSERT_GT(logs[0].entries.size(), 1000U);
  EXPECT_TRUE(logs[0].entries == logs[1].entries);
}

TEST_F(RecordingTest, aRecordingThatBeginsInTheGameHasAllThatHolds) {
  make(false);
  steps(125);
  start("a.mcap");
  steps(25);
  const ReadLog log = stop();
  std::set<std::string> held;
  for (const auto& entry : log.entries) {
    EXPECT_GE(entry.time, robotlink::Instant(std::chrono::milliseconds(960)))
        << entry.path;  // queues are on their way
    if (entry.frame == 0) held.insert(entry.path);
  }
  for (const char* path :
       {"scene", "red1/program", "red1/tables/keys", "red1/tables/solutions", "red1/tables/processes"}) {
    EXPECT_TRUE(held.contains(path)) << path;
  }
  EXPECT_GT(log.count("red1/models/ball"), 0U);
  EXPECT_THAT(brokenFrames(log), ElementsAre());
}

TEST_F(RecordingTest, whenItEndsTheProgramPublishesNoMoreThanBefore) {
  make(false);
  steps(125);
  reported = 0;
  steps(125);
  const std::size_t before = reported;
  start("a.mcap");
  steps(125);
  (void)stop();
  steps(25);
  reported = 0;
  steps(125);
  EXPECT_NEAR(static_cast<double>(reported), static_cast<double>(before), 0.05 * static_cast<double>(before));
}

TEST_F(RecordingTest, packagesThatTheUserAsksForAreThereBesideThoseOfTheRecordingAndAfterAReset) {
  make(true);
  Request request;
  request.set_robot("red1");
  request.mutable_record_packages()->add_packages("models/ball");
  steps(50);
  ASSERT_TRUE(run->request(request).has_value());
  steps(50);
  const ReadLog log = stop();
  for (const char* path : {"red1/models/ball", "red1/models/pose"}) {
    const auto entries = on(log, path);
    ASSERT_FALSE(entries.empty()) << path;
    EXPECT_GE(entries.back().time, robotlink::Instant(std::chrono::milliseconds(700))) << path;
  }
  const auto published = [this] {
    models = 0;
    steps(50);
    return models > 0;
  };
  EXPECT_TRUE(published()) << "also while nothing is recorded";
  ASSERT_TRUE(run->reset(1).empty());
  EXPECT_TRUE(published()) << "and by the next program";
  request.mutable_record_packages()->clear_packages();
  ASSERT_TRUE(run->request(request).has_value());
  steps(2);
  EXPECT_FALSE(published());
}

TEST_F(RecordingTest, theSetUpSaysWhatTheProgramIsMadeOf) {
  make(true);
  steps(10);
  const auto setups = on(stop(), "red1/program");
  ASSERT_EQ(setups.size(), 1U);
  const auto setup = parsed<ProgramSetup>(setups[0]);
  EXPECT_EQ(setup.robot(), "red1");
  EXPECT_EQ(setup.team(), "red");
  EXPECT_EQ(setup.executor(), "lockstep");
  EXPECT_EQ(setup.layout().name(), "layouts/compact.yaml");
  EXPECT_EQ(setup.description().name(), "robots/ers210.yaml");
  EXPECT_EQ(setup.field().name(), "fields/2002.yaml");
  EXPECT_THAT(setup.layout().text(), HasSubstr("ball-percept"));
  EXPECT_EQ(setup.solutions_size(), 0);
  EXPECT_GT(setup.parameters_size(), 5);
  EXPECT_THAT(setup.offered(),
              ::testing::IsSupersetOf({"camera/image", "joints/states", "oracle/world", "remote/motion"}));
}

TEST_F(RecordingTest, requestsAreRecordedWhenTheyAreHandedInAndTheSetUpFollowsThem) {
  make(true);
  steps(50);
  ASSERT_TRUE(run->request(select("ball-percept", "circle-fit")).has_value());
  steps(50);
  ASSERT_TRUE(run->request(select("ball-percept", "region")).has_value());
  Request parameters;
  parameters.set_robot("red1");
  parameters.mutable_get_parameters()->set_task("ball-percept");
  ASSERT_TRUE(run->request(parameters).has_value());
  steps(50);
  const ReadLog log = stop();
  const auto requests = on(log, "red1/requests");
  ASSERT_EQ(requests.size(), 4U);  // the first asks for the tables
  EXPECT_EQ(requests[1].time, robotlink::Instant(std::chrono::milliseconds(400)));
  EXPECT_EQ(parsed<Request>(requests[1]).select_solution().solution(), "circle-fit");
  EXPECT_EQ(requests[2].time, robotlink::Instant(std::chrono::milliseconds(800)));
  const auto setups = on(log, "red1/program");
  ASSERT_EQ(setups.size(), 3U);  // asking for parameters changes nothing
  const auto changed = parsed<ProgramSetup>(setups[1]);
  ASSERT_EQ(changed.solutions_size(), 1);
  EXPECT_EQ(changed.solutions(0).solution(), "circle-fit");
  EXPECT_GE(setups[1].time, requests[1].time);
  EXPECT_EQ(parsed<ProgramSetup>(setups[2]).solutions_size(), 0);
}

TEST_F(RecordingTest, parametersThatAreSetAreInTheSetUp) {
  make(true);
  steps(5);
  const auto values = parsed<ProgramSetup>(on(stop(), "red1/program").at(0)).parameters(0);
  std::filesystem::remove(folder / "a.mcap");
  start("a.mcap");
  Request request;
  request.set_robot("red1");
  auto& details = *request.mutable_set_parameters();
  details.set_task(values.task());
  details.set_solution(values.solution());
  details.mutable_value()->set_type(values.value().type());  // all as its type has them
  ASSERT_TRUE(run->request(request).has_value());
  steps(25);
  const auto setups = on(stop(), "red1/program");
  ASSERT_EQ(setups.size(), 2U) << values.task() << "/" << values.solution();
  EXPECT_NE(parsed<ProgramSetup>(setups[0]).parameters(0).value().data(), "");
  EXPECT_EQ(parsed<ProgramSetup>(setups[1]).parameters(0).value().data(), "");
}

TEST_F(RecordingTest, theColorTableInForceIsPartOfALogThatBeginsLater) {
  make(false);
  Request request;
  request.set_robot("red1");
  auto& table = *request.mutable_set_color_table()->mutable_table();
  table.add_class_names("orange");
  table.set_cells(std::string(262'144, '\1'));
  ASSERT_TRUE(run->request(request).has_value());
  steps(10);
  start("a.mcap");
  steps(10);
  const auto tables = on(stop(), "red1/colors/table");
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(parsed<robotcontrol::ColorTable>(tables[0]).cells(), table.cells());
}

TEST_F(RecordingTest, aDebugKeyTriggersThatTheLastSecondsAreSaved) {
  make(false);
  ControlRecording control;
  control.set_keep_last(0.5);
  control.set_trigger("red1/drawings/image/ball-percept/*");
  ASSERT_TRUE(recorder->control(control).has_value());
  recorder->setFolder(folder.path());
  steps(125);
  recorder->finish();
  EXPECT_THAT(folder.files(), ElementsAre());
  Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name("ball-percept/disc");
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  ASSERT_TRUE(run->request(request).has_value());
  steps(40);
  recorder->finish();
  ASSERT_EQ(folder.files().size(), 1U);
  const ReadLog log = logplayer::tests::readLog(folder / folder.files()[0]);
  EXPECT_TRUE(log.complete);
  EXPECT_NEAR(static_cast<double>(log.count("red1/joints/states")), 63, 3);
  EXPECT_EQ(log.count("red1/program"), 1U);
  EXPECT_GT(log.count("red1/drawings/image/ball-percept/disc"), 0U);
}

TEST_F(RecordingTest, anotherLayoutGoesOnInTheSameFileAndAResetInANewOne) {
  make(true);
  steps(50);
  ASSERT_TRUE(run->setLayout(robotlink::resource("layouts/parallel.yaml")).empty());
  steps(50);
  ASSERT_TRUE(run->reset(1).empty());
  steps(50);
  const ReadLog first = stop();
  const ReadLog second = logplayer::tests::readLog(folder / "a-2.mcap");
  const auto setups = on(first, "red1/program");
  ASSERT_EQ(setups.size(), 2U);
  EXPECT_EQ(parsed<ProgramSetup>(setups[1]).layout().name(), "layouts/parallel.yaml");
  EXPECT_EQ(setups[1].time, robotlink::Instant(std::chrono::milliseconds(400)));
  EXPECT_EQ(first.count("red1/frames/platform"), 100U);
  EXPECT_EQ(second.count("red1/frames/platform"), 50U);
  EXPECT_EQ(second.count("scene"), 1U);
  ASSERT_EQ(second.count("red1/program"), 1U);
  EXPECT_EQ(parsed<ProgramSetup>(on(second, "red1/program")[0]).layout().name(), "layouts/parallel.yaml");
  EXPECT_GT(second.count("red1/models/ball"), 0U);
  EXPECT_EQ(second.entries.front().time, robotlink::Instant());
}

TEST(DocumentsFolder, isOneThatExists) {
  const TestFolder home;
  const char* homeBefore = std::getenv("HOME");
  const char* configBefore = std::getenv("XDG_CONFIG_HOME");
  const std::string oldHome = homeBefore != nullptr ? homeBefore : "",
                    oldConfig = configBefore != nullptr ? configBefore : "";
  ::setenv("HOME", home.path().c_str(), 1);
  ::setenv("XDG_CONFIG_HOME", home.path().c_str(), 1);
  home.write("user-dirs.dirs", "XDG_DOCUMENTS_DIR=\"$HOME/Papiere\"\n");
  EXPECT_EQ(documentsFolder(), home.path());
  std::filesystem::create_directory(home / "Documents");
  EXPECT_EQ(documentsFolder(), home / "Documents");
  std::filesystem::create_directory(home / "Papiere");
  EXPECT_EQ(documentsFolder(), home / "Papiere");
  homeBefore != nullptr ? ::setenv("HOME", oldHome.c_str(), 1) : ::unsetenv("HOME");
  configBefore != nullptr ? ::setenv("XDG_CONFIG_HOME", oldConfig.c_str(), 1) : ::unsetenv("XDG_CONFIG_HOME");
}

TEST_F(RecordingTest, threadsAreRecordedInWholeFramesToo) {
  make(true, ExecutorKind::kThreads);
  // Threads have their own pace, and the debug process runs when the platform's time moves on.
  std::size_t count = 50;
  steps(50);
  ASSERT_TRUE(eventually([&] {
    steps(1);
    ++count;
    return thoughts > 0;
  }));
  steps(50);
  const ReadLog log = stop();
  EXPECT_EQ(log.count("red1/frames/platform"), count + 50);
  EXPECT_EQ(log.count("red1/joints/states"), count + 50);
  EXPECT_GT(log.count("red1/models/ball"), 0U);
  EXPECT_THAT(brokenFrames(log), ElementsAre());
}
