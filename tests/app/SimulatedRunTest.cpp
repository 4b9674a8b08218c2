// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/SimulatedRun.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/core/BallTrials.h"
#include "app/core/Workbench.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"

using namespace app;
using robotlink::Pose2;

namespace {

RunOptions options(std::uint64_t seed = 1) {
  RunOptions options = Workbench::defaultOptions();
  options.world.seed = seed;
  return options;
}

std::unique_ptr<SimulatedRun> makeRun(const RunOptions& options, SimulatedRun::Listeners listeners = {}) {
  auto run = SimulatedRun::create(options, std::move(listeners));
  EXPECT_TRUE(run.has_value()) << (run ? "" : robotlink::describe(run.error()));
  return run ? std::move(*run) : nullptr;
}

void play(SimulatedRun& run, double seconds) {
  const robotlink::Instant end = run.world().clock().now() + robotlink::fromSeconds(seconds);
  while (run.world().clock().now() < end) run.step();
}

std::uint64_t digestAfter(const RunOptions& options, double seconds) {
  const auto run = makeRun(options);
  play(*run, seconds);
  return run->world().digest();
}

Pose2 poseOf(SimulatedRun& run, const std::string& model) {
  return robotlink::groundPose(run.world().simulation().modelPose(model).value());
}

/// What a run's programs tell, for looking at it afterwards.
struct Ears {
  std::vector<robotcontrol::DebugMessage> messages;
  std::vector<std::string> troubles;
  SimulatedRun::Listeners listeners() {
    return {[this](const std::string&, const auto& queue) {
              messages.insert(messages.end(), queue->messages().begin(), queue->messages().end());
            },
            [this](const std::string&, const robotlink::Process&, const std::string& text) { troubles.push_back(text); }};
  }
  bool heard(const std::string& path) const {
    return std::any_of(messages.begin(), messages.end(), [&](const auto& message) { return message.path() == path; });
  }
};

robotcontrol::Request keyRequest(const std::string& key) {
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  return request;
}

}  // namespace

TEST(SimulatedRun, theSameSeedGivesTheSameBytesAndAnotherSeedOthers) {
  EXPECT_EQ(digestAfter(options(3), 2), digestAfter(options(3), 2));
  EXPECT_NE(digestAfter(options(3), 2), digestAfter(options(4), 2));
}

TEST(SimulatedRun, aRunThatIsResetPlaysLikeAFreshOne) {
  const auto run = makeRun(options(1));
  play(*run, 1);
  ASSERT_TRUE(run->reset(7).empty());
  play(*run, 1);
  EXPECT_EQ(run->world().digest(), digestAfter(options(7), 1));
}

TEST(SimulatedRun, whatIsAskedForIsToldAndGoesOnAfterAReset) {
  Ears ears;
  const auto run = makeRun(options(), ears.listeners());
  play(*run, 0.5);
  EXPECT_FALSE(ears.heard("camera/image"));
  ASSERT_TRUE(run->request(keyRequest("package/camera/image")).has_value());
  play(*run, 0.5);
  EXPECT_TRUE(ears.heard("camera/image"));
  ASSERT_TRUE(run->reset(1).empty());
  ears.messages.clear();
  play(*run, 0.5);
  EXPECT_TRUE(ears.heard("camera/image"));
}

TEST(SimulatedRun, aLayoutThatCannotBeUsedLeavesTheRunAsItWas) {
  const auto run = makeRun(options());
  const auto file = std::filesystem::path(testing::TempDir()) / "broken-layout.yaml";
  std::ofstream(file) << "version: 1\nname: broken\nprocesses:\n  - name: cognition\n    blocking: [camera/image]\n"
                         "    tasks:\n      - segmentation: telepathy\n";
  const robotlink::Errors errors = run->setLayout(file);
  EXPECT_NE(robotlink::describe(errors).find(file.string() + ":7:9: "), std::string::npos) << robotlink::describe(errors);
  play(*run, 0.5);
  EXPECT_EQ(run->world().digest(), digestAfter(options(), 0.5));
}

TEST(SimulatedRun, aResetThatCannotBeDoneLeavesTheRunAsItWas) {
  const auto file = std::filesystem::path(testing::TempDir()) / "soon-broken-layout.yaml";
  RunOptions chosen = options();
  std::filesystem::copy_file(Workbench::layoutNamed("compact"), file, std::filesystem::copy_options::overwrite_existing);
  chosen.layout = file;
  const auto run = makeRun(chosen);
  play(*run, 0.8);
  std::ofstream(file) << "version: 1\nname: [broken\n";
  EXPECT_FALSE(run->reset(2).empty());
  play(*run, 0.2);
  EXPECT_EQ(run->world().digest(), digestAfter(options(), 1));
}

TEST(SimulatedRun, allShippedScenesAndMapsPlayWithoutTrouble) {
  EXPECT_GE(Workbench::scenes().size(), 3U);
  for (const auto& scene : Workbench::scenes()) {
    Ears ears;
    RunOptions chosen = options();
    chosen.scene = scene;
    const auto run = makeRun(chosen, ears.listeners());
    ASSERT_NE(run, nullptr) << scene;
    play(*run, 1);
    EXPECT_FALSE(run->robots().empty()) << scene;
    EXPECT_TRUE(ears.troubles.empty()) << scene << ": " << ears.troubles.front();
  }
}

TEST(SimulatedRun, allShippedLayoutsPlayWithoutTrouble) {
  const auto robot = robotlink::readRobotDescription(robotlink::resource("robots/ers210.yaml"));
  ASSERT_TRUE(robot) << robotlink::describe(robot.error());
  const auto layouts = Workbench::layoutsFor(*robot);
  EXPECT_GE(layouts.size(), 4U);
  for (const auto& layout : layouts) {
    Ears ears;
    RunOptions chosen = options();
    chosen.layout = layout;
    const auto run = makeRun(chosen, ears.listeners());
    play(*run, 3);
    EXPECT_TRUE(ears.troubles.empty()) << layout << ": " << ears.troubles.front();
  }
}

TEST(SimulatedRun, stopHoldsARobotWhateverItsProgramDoes) {
  const auto run = makeRun(options());
  play(*run, 1);
  robotcontrol::Request stop;
  stop.set_robot("red1");
  stop.mutable_stop()->set_engaged(true);
  ASSERT_TRUE(run->request(stop).has_value());
  play(*run, 1);
  const Pose2 held = poseOf(*run, "red1");
  play(*run, 4);
  EXPECT_LT((poseOf(*run, "red1").translation() - held.translation()).norm(), 0.02);
  EXPECT_EQ(run->stoppedRobots(), std::vector<std::string>{"red1"});
  stop.mutable_stop()->set_engaged(false);
  ASSERT_TRUE(run->request(stop).has_value());
  play(*run, 6);
  EXPECT_GT((poseOf(*run, "red1").translation() - held.translation()).norm() +
                std::abs(robotlink::normalizedAngle(poseOf(*run, "red1").heading - held.heading)),
            0.1);
}

TEST(SimulatedRun, aRobotThatDoesNotExistIsRefusedByName) {
  const auto run = makeRun(options());
  robotcontrol::Request request = keyRequest("timing/tasks");
  request.set_robot("green9");
  const auto done = run->request(request);
  ASSERT_FALSE(done.has_value());
  EXPECT_NE(done.error().text.find("green9"), std::string::npos);
}

TEST(SimulatedRun, threadsPlayToo) {
  RunOptions chosen = options();
  chosen.executor = ExecutorKind::kThreads;
  Ears ears;
  std::atomic<int> frames{0};
  SimulatedRun::Listeners listeners;
  listeners.queue = [&](const std::string&, const auto& queue) { frames += queue->messages_size(); };
  const auto run = makeRun(chosen, std::move(listeners));
  for (int i = 0; i < 125; ++i) {
    run->step();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_GT(frames.load(), 0);
}

TEST(SimulatedRun, theRobotTouchesBallsAroundItButNoneWithoutEyes) {
  BallTrials trials;
  trials.run = options();
  trials.count = 3;
  const auto seeing = trials.play();
  ASSERT_TRUE(seeing.has_value());
  EXPECT_GE(std::count_if(seeing->begin(), seeing->end(), [](const auto& trial) { return trial.touched; }), 2);
  trials.run.world.blackout = true;
  trials.count = 1;
  const auto blind = trials.play();
  ASSERT_TRUE(blind.has_value());
  EXPECT_FALSE(blind->front().touched);
}
