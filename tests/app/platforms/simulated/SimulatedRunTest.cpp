// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SimulatedRun.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "app/core/program/ShippedFiles.h"
#include "app/platforms/simulated/BallTrials.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Solution.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/Requests.h"
#include "tests/app/SimulatedRuns.h"

using namespace app;
using namespace app::test;
using robotlink::Pose2;

namespace {

std::uint64_t digestAfter(const RunOptions& options, double seconds) {
  const auto run = makeRun(options);
  play(*run, seconds);
  return run->world().digest();
}

Pose2 poseOf(SimulatedRun& run, const std::string& model) {
  return robotlink::groundPose(run.world().simulation().modelPose(model).value());
}

/// What a run publishes and reports.
struct Ears {
  std::vector<robotcontrol::DebugMessage> messages;
  std::vector<std::string> troubles;
  SimulatedRun::Listeners listeners() {
    return {[this](const std::string&, const auto& queue) {
              const robotcontrol::DebugQueue wire = toWire(*queue);
              messages.insert(messages.end(), wire.messages().begin(), wire.messages().end());
            },
            [this](const std::string&, const robotlink::Process&, const std::string& text) {
              troubles.push_back(text);
            }};
  }
  bool heard(const std::string& path) const {
    return std::any_of(messages.begin(), messages.end(),
                       [&](const auto& message) { return message.path() == path; });
  }
};

}  // namespace

TEST(SimulatedRun, itsLoadingReportsHowFarItIsAndCanBeGivenUp) {
  RunOptions wanted = simulationOptions();
  double reached = -1;
  wanted.progress = [&](double share) {
    reached = share;
    return true;
  };
  const auto run = makeRun(wanted);
  EXPECT_GT(reached, 0.5);
  wanted.progress = [](double) { return false; };
  const auto none = SimulatedRun::create(wanted, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().front().id, "scene.given-up");
}

TEST(SimulatedRun, theSameSeedGivesTheSameBytesAndAnotherSeedOthers) {
  const std::uint64_t digest = digestAfter(simulationOptions(3), 2);
  EXPECT_EQ(digestAfter(simulationOptions(3), 2), digest);
  EXPECT_NE(digestAfter(simulationOptions(4), 2), digest);
}

TEST(SimulatedRun, anyNumberOfThreadsGivesTheSameBytesAndMessages) {
  RunOptions options = simulationOptions(5);
  options.robots = simcore::RobotsToAdd{.model = "ers210", .count = 3};
  options.classImages = true;
  std::vector<std::uint64_t> digests;
  std::vector<std::vector<std::string>> told;
  for (const int threads : {1, 2, 3, 8}) {
    options.world.threads = threads;
    const auto thisThread = std::this_thread::get_id();
    auto& messages = told.emplace_back();
    SimulatedRun::Listeners listeners;
    listeners.queue = [&](const std::string& robot, const auto& queue) {
      EXPECT_EQ(std::this_thread::get_id(), thisThread);
      messages.push_back(robot + toWire(*queue).SerializeAsString());
    };
    const auto run = makeRun(options, listeners);
    EXPECT_EQ(run->world().options().threads, threads);
    for (const std::string& robot : run->robots()) {
      for (const char* package : {"camera/image", "oracle/classes", "percepts/ball", "models/pose"})
        ASSERT_TRUE(run->request(keyRequest(robot, std::string("package/") + package)).has_value());
    }
    play(*run, 0.6);
    digests.push_back(run->world().digest());
  }
  EXPECT_GT(told.front().size(), 4U * 10U);
  for (std::size_t i = 1; i < digests.size(); ++i) {
    EXPECT_EQ(digests[i], digests[0]);
    EXPECT_TRUE(told[i] == told[0]);
  }
}

TEST(SimulatedRun, aRunThatIsResetPlaysLikeAFreshOne) {
  const auto run = makeRun(simulationOptions(1));
  play(*run, 1);
  ASSERT_TRUE(run->reset(7).empty());
  play(*run, 1);
  EXPECT_EQ(run->world().digest(), digestAfter(simulationOptions(7), 1));
}

TEST(SimulatedRun, whatIsAskedForIsPublishedAlsoAfterAReset) {
  Ears ears;
  const auto run = makeRun(simulationOptions(), ears.listeners());
  play(*run, 0.5);
  EXPECT_FALSE(ears.heard("camera/image"));
  ASSERT_TRUE(run->request(keyRequest("red1", "package/camera/image")).has_value());
  play(*run, 0.5);
  EXPECT_TRUE(ears.heard("camera/image"));
  ASSERT_TRUE(run->reset(1).empty());
  ears.messages.clear();
  play(*run, 0.5);
  EXPECT_TRUE(ears.heard("camera/image"));
}

TEST(SimulatedRun, aLayoutThatCannotBeUsedLeavesTheRunAsItWas) {
  const auto run = makeRun(simulationOptions());
  const TestFolder folder;
  const auto file = folder / "broken-layout.yaml";
  std::ofstream(file)
      << "version: 1\nname: broken\nprocesses:\n  - name: cognition\n    blocking: [camera/image]\n"
         "    tasks:\n      - segmentation: telepathy\n";
  const robotlink::Errors errors = run->setLayout(file);
  EXPECT_NE(robotlink::describe(errors).find(file.string() + ":7:9: "), std::string::npos)
      << robotlink::describe(errors);
  play(*run, 0.5);
  EXPECT_EQ(run->world().digest(), digestAfter(simulationOptions(), 0.5));
}

TEST(SimulatedRun, aResetThatCannotBeDoneLeavesTheRunAsItWas) {
  const TestFolder folder;
  const auto file = folder / "soon-broken-layout.yaml";
  RunOptions chosen = simulationOptions();
  std::filesystem::copy_file(layoutNamed("compact"), file);
  chosen.layout = file;
  const auto run = makeRun(chosen);
  play(*run, 0.8);
  std::ofstream(file) << "version: 1\nname: [broken\n";
  EXPECT_FALSE(run->reset(2).empty());
  play(*run, 0.2);
  EXPECT_EQ(run->world().digest(), digestAfter(simulationOptions(), 1));
}

TEST(SimulatedRun, allShippedScenesAndMapsPlayWithoutTrouble) {
  EXPECT_GE(shippedScenes().size(), 3U);
  for (const auto& scene : shippedScenes()) {
    Ears ears;
    RunOptions chosen = simulationOptions();
    chosen.scene = scene;
    const auto run = makeRun(chosen, ears.listeners());
    ASSERT_NE(run, nullptr) << scene;
    play(*run, 1);
    EXPECT_FALSE(run->world().simulation().bodyPoses().empty()) << scene;
    EXPECT_TRUE(ears.troubles.empty()) << scene << ": " << ears.troubles.front();
  }
}

TEST(SimulatedRun, allShippedLayoutsPlayWithoutTrouble) {
  const auto robot = robotlink::readRobotDescription(robotlink::resource("robots/ers210.yaml"));
  ASSERT_TRUE(robot) << robotlink::describe(robot.error());
  const auto layouts = layoutsFor(*robot);
  EXPECT_GE(layouts.size(), 4U);
  for (const auto& layout : layouts) {
    Ears ears;
    RunOptions chosen = simulationOptions();
    chosen.layout = layout;
    const auto run = makeRun(chosen, ears.listeners());
    play(*run, 3);
    EXPECT_TRUE(ears.troubles.empty()) << layout << ": " << ears.troubles.front();
  }
}

TEST(SimulatedRun, stopHoldsARobotWhateverItsProgramDoes) {
  const auto run = makeRun(simulationOptions());
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

namespace {

/// The layout that is broken when a program was made; empty: none.
std::filesystem::path layoutToBreak;

/// Breaks its own layout, as an editor that saves at this moment.
class BreaksItsLayout final : public robotlink::Solution {
 public:
  explicit BreaksItsLayout(robotlink::SolutionContext&) {
    if (!layoutToBreak.empty()) std::ofstream(layoutToBreak) << "broken: [";
  }
  void execute() override {}
};
const robotlink::SolutionRegistration kBreaksItsLayout =
    robotlink::SolutionBuilder<BreaksItsLayout>("layout-breaker", "break", "Breaks its layout.");

}  // namespace

TEST(SimulatedRun, aLayoutThatIsBrokenInTheMiddleOfAResetLeavesTheProgramsThatCouldBeMade) {
  const TestFolder folder;
  RunOptions broken = simulationOptions();
  broken.layout = folder.write("breaking.yaml",
                               "version: 1\nname: breaking\nhelp: Is broken.\nprocesses:\n"
                               "  - {name: worker, period_ms: 8, tasks: [layout-breaker: break]}\n"
                               "  - {name: debug, debug: true, period_ms: 16}\n");
  const auto run = makeRun(broken);
  play(*run, 0.1);
  layoutToBreak = folder / "breaking.yaml";
  EXPECT_EQ(robotlink::describe(run->reset(1)), "");
  layoutToBreak.clear();
  play(*run, 0.1);
  EXPECT_NE(robotlink::describe(run->reset(1)), "") << "now it is broken from the start";
  play(*run, 0.1);
}

TEST(SimulatedRun, aRobotThatDoesNotExistIsRefusedByName) {
  const auto run = makeRun(simulationOptions());
  robotcontrol::Request request = keyRequest("red1", "timing/tasks");
  request.set_robot("green9");
  const auto done = run->request(request);
  ASSERT_FALSE(done.has_value());
  EXPECT_NE(done.error().text.find("green9"), std::string::npos);
}

TEST(SimulatedRun, threadsPlayToo) {
  RunOptions chosen = simulationOptions();
  chosen.hosting.threads = true;
  std::atomic<int> frames{0};
  SimulatedRun::Listeners listeners;
  listeners.queue = [&](const std::string&, const auto& queue) {
    frames += static_cast<int>(queue->messages.size());
  };
  const auto run = makeRun(chosen, std::move(listeners));
  for (int i = 0; i < 125; ++i) run->step();
  EXPECT_TRUE(eventually([&] {
    run->step();
    return frames > 0;
  }));
}

TEST(SlowSimulatedRun, theRobotTouchesBallsAroundItButNoneWithoutEyes) {
  BallTrials trials;
  trials.run = simulationOptions();
  trials.count = 3;
  const auto seeing = trials.play();
  ASSERT_TRUE(seeing.has_value());
  EXPECT_GE(std::count_if(seeing->begin(), seeing->end(), [](const auto& trial) { return trial.touched; }),
            2);
  trials.run.world.blackout = true;
  trials.count = 1;
  const auto blind = trials.play();
  ASSERT_TRUE(blind.has_value());
  EXPECT_FALSE(blind->front().touched);
}
