// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/simulated/SimulatedRun.h"

#include <gmock/gmock.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "app/core/program/ProgramSetups.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/simulated/BallTrials.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Solution.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/TableRequest.h"

using namespace app;
using robotlink::Pose2;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

namespace {

RunOptions options(std::uint64_t seed = 1) {
  RunOptions options = defaultSimulation();
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

robotcontrol::Request keyRequestOfRed1(const std::string& key) {
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  return request;
}

}  // namespace

TEST(SimulatedRun, itsLoadingReportsHowFarItIsAndCanBeGivenUp) {
  RunOptions wanted = options();
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
  const std::uint64_t digest = digestAfter(options(3), 2);
  EXPECT_EQ(digestAfter(options(3), 2), digest);
  EXPECT_NE(digestAfter(options(4), 2), digest);
}

TEST(SimulatedRun, aRunThatIsResetPlaysLikeAFreshOne) {
  const auto run = makeRun(options(1));
  play(*run, 1);
  ASSERT_TRUE(run->reset(7).empty());
  play(*run, 1);
  EXPECT_EQ(run->world().digest(), digestAfter(options(7), 1));
}

TEST(SimulatedRun, whatIsAskedForIsPublishedAlsoAfterAReset) {
  Ears ears;
  const auto run = makeRun(options(), ears.listeners());
  play(*run, 0.5);
  EXPECT_FALSE(ears.heard("camera/image"));
  ASSERT_TRUE(run->request(keyRequestOfRed1("package/camera/image")).has_value());
  play(*run, 0.5);
  EXPECT_TRUE(ears.heard("camera/image"));
  ASSERT_TRUE(run->reset(1).empty());
  ears.messages.clear();
  play(*run, 0.5);
  EXPECT_TRUE(ears.heard("camera/image"));
}

namespace {

robotcontrol::Request solutionRequest(const char* task, const char* solution) {
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  return request;
}

/// Parameters of the ball model "last-percept".
std::unique_ptr<google::protobuf::Message> lastPercept() {
  const auto* type = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(
      "robotcontrol.LastPerceptBallParameters");
  return std::unique_ptr<google::protobuf::Message>(
      google::protobuf::MessageFactory::generated_factory()->GetPrototype(type)->New());
}

robotcontrol::Request parameterRequest(double memory) {
  robotcontrol::Request request;
  request.set_robot("red1");
  auto& details = *request.mutable_set_parameters();
  details.set_task("ball-model");
  details.set_solution("last-percept");
  const auto value = lastPercept();
  const auto* field = value->GetDescriptor()->FindFieldByName("memory");
  value->GetReflection()->SetDouble(value.get(), field, memory);
  details.mutable_value()->set_type(value->GetDescriptor()->full_name());
  details.mutable_value()->set_data(value->SerializeAsString());
  return request;
}

/// What a run tells of red1: its newest solution of a task, parameters of its ball model, and whether it has
/// an own color table.
struct Reported {
  std::map<std::string, std::string> solutions;
  double memory = -1;  // s
  bool ownTable = false;
  std::string frames;                      ///< all that its processes told, as bytes
  std::map<std::uint64_t, bool> accepted;  ///< by id, first answers
  std::vector<std::string> tables;         ///< where color tables in use are from
  std::vector<std::string> texts;          ///< on color tables
  SimulatedRun::Listeners listeners() {
    return {[this](const std::string&, const auto& queue) {
              const robotcontrol::DebugQueue wire = toWire(*queue);
              if (!wire.process().empty()) frames += wire.SerializeAsString();
              for (const auto& message : wire.messages()) hear(message);
            },
            {}};
  }
  void hear(const robotcontrol::DebugMessage& message) {
    if (message.has_result()) accepted.emplace(message.result().id(), message.result().accepted());
    for (const auto& task : message.solutions().tasks()) solutions[task.name()] = task.active();
    if (message.path() == "parameters/ball-model/last-percept") {
      const auto value = lastPercept();
      value->ParseFromString(message.parameters().value().data());
      memory = value->GetReflection()->GetDouble(*value, value->GetDescriptor()->FindFieldByName("memory"));
    }
    if (message.path() == "colors/table") ownTable = true;
    if (message.text().name() == "debug/colors") texts.push_back(message.text().message());
    if (message.path() != "tables/colors") return;
    robotcontrol::ColorTable inUse;
    inUse.ParseFromString(message.package().data());
    EXPECT_TRUE(inUse.cells().empty());
    tables.push_back(inUse.source());
  }
};

/// Everything that a person can choose for a program.
std::vector<robotcontrol::Request> choices() {
  std::vector<robotcontrol::Request> all{solutionRequest("ball-model", "last-percept"),
                                         parameterRequest(0.125), tableRequest(),
                                         keyRequestOfRed1("package/colors/table")};
  for (std::size_t i = 0; i < all.size(); ++i) all[i].set_id(i + 1);
  return all;
}

}  // namespace

TEST(SimulatedRun, requestsInAPauseAreAnsweredAtOnceAndTheRunIsTheSameAsWithoutThePause) {
  Reported paused, other;
  const auto looked = makeRun(options(), paused.listeners()),
             unlooked = makeRun(options(), other.listeners());
  for (const bool look : {true, false}) {
    SimulatedRun& run = look ? *looked : *unlooked;
    play(run, 0.5);
    for (const auto& request : choices()) {
      ASSERT_TRUE(run.request(request).has_value());
      if (look) run.publishComingAnswers();
    }
    if (look) run.publishComingAnswers();
    play(run, 0.008);  // In the middle of their way to the processes.
    if (look) run.publishComingAnswers();
    play(run, 0.5);
  }
  for (std::uint64_t id = 1; id <= 4; ++id) EXPECT_TRUE(paused.accepted[id]) << id;
  EXPECT_EQ(looked->world().digest(), unlooked->world().digest());
  EXPECT_EQ(paused.frames.size(), other.frames.size());
  EXPECT_TRUE(paused.frames == other.frames);
}

TEST(SimulatedRun, inAPauseTheTablesAndParametersFollowWhatWasAsked) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  run->publishComingAnswers();
  EXPECT_EQ(reported.solutions["ball-model"], "filtered") << "known before the first step";
  for (const auto& request : choices()) ASSERT_TRUE(run->request(request).has_value());
  run->publishComingAnswers();
  EXPECT_EQ(reported.accepted.size(), 5U) << "the four, and what the run asks for itself";
  EXPECT_EQ(reported.solutions["ball-model"], "last-percept");
  EXPECT_EQ(reported.memory, 0.125);
  EXPECT_EQ(run->world().clock().now(), robotlink::Instant{});
}

TEST(SimulatedRun, whatAPersonChoseSurvivesResetsAndOtherLayouts) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  play(*run, 0.2);
  for (const auto& request : choices()) ASSERT_TRUE(run->request(request).has_value());
  play(*run, 0.5);
  const auto expectAll = [&](const char* after) {
    reported = {};
    play(*run, 0.5);
    EXPECT_EQ(reported.solutions["ball-model"], "last-percept") << after;
    EXPECT_EQ(reported.memory, 0.125) << after;
    EXPECT_TRUE(reported.ownTable) << after;
    EXPECT_EQ(run->lostChoices(), std::vector<std::string>()) << after;
  };
  ASSERT_TRUE(run->setLayout(layoutNamed("parallel")).empty());
  expectAll("layout");
  ASSERT_TRUE(run->reset(1).empty());
  expectAll("reset");
}

TEST(SimulatedRun, theColorTableInUseIsSaidAndSurvivesResetsAndOtherLayouts) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  play(*run, 0.5);
  EXPECT_THAT(std::set(reported.tables.begin(), reported.tables.end()), ElementsAre("built-in"));
  EXPECT_THAT(reported.texts, IsEmpty());
  reported = {};
  ASSERT_TRUE(run->request(tableRequest()).has_value());
  play(*run, 0.5);
  EXPECT_THAT(reported.tables, ElementsAre("/home/me/orange.c64"));
  EXPECT_THAT(reported.texts, ElementsAre("The color table is now /home/me/orange.c64"));
  const auto expectKept = [&](const char* after) {
    reported = {};
    play(*run, 0.5);
    EXPECT_THAT(std::set(reported.tables.begin(), reported.tables.end()), ElementsAre("/home/me/orange.c64"))
        << after;
    EXPECT_THAT(reported.texts, IsEmpty()) << after << ": nothing changed";
  };
  ASSERT_TRUE(run->reset(1).empty());
  expectKept("reset");
  ASSERT_TRUE(run->setLayout(layoutNamed("parallel")).empty());
  expectKept("layout");
  robotcontrol::Request back;
  back.set_robot("red1");
  back.mutable_set_color_table();
  reported = {};
  ASSERT_TRUE(run->request(back).has_value());
  play(*run, 0.5);
  EXPECT_THAT(reported.tables, ElementsAre("built-in"));
  EXPECT_THAT(reported.texts, ElementsAre("The color table is now the built-in one"));
}

TEST(SimulatedRun, aColorTableThatIsGivenBeforeTheFirstFrameIsLoggedToo) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  ASSERT_TRUE(run->request(tableRequest()).has_value());
  play(*run, 0.5);
  EXPECT_THAT(reported.texts, ElementsAre("The color table is now /home/me/orange.c64"));
}

TEST(SimulatedRun, inAPauseTheColorTableThatWasGivenIsSaidAtOnce) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  run->publishComingAnswers();
  EXPECT_THAT(reported.tables, ElementsAre("built-in")) << "known before the first step";
  ASSERT_TRUE(run->request(tableRequest()).has_value());
  run->publishComingAnswers();
  EXPECT_EQ(reported.tables.back(), "/home/me/orange.c64");
}

TEST(SimulatedRun, choicesInAPauseSurviveAResetInTheSamePause) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  for (const auto& request : choices()) ASSERT_TRUE(run->request(request).has_value());
  run->publishComingAnswers();
  ASSERT_TRUE(run->reset(1).empty());
  play(*run, 0.5);
  EXPECT_EQ(reported.solutions["ball-model"], "last-percept");
  EXPECT_EQ(reported.memory, 0.125);
}

TEST(SimulatedRun, whatALayoutCannotFulfillIsSaidAndComesBackWithOneThatCan) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  ASSERT_TRUE(run->request(solutionRequest("self-localisation", "odometry")).has_value());
  play(*run, 0.2);
  ASSERT_TRUE(run->setLayout(layoutNamed("perception")).empty());
  ASSERT_EQ(run->lostChoices().size(), 1U);
  EXPECT_EQ(run->lostChoices()[0],
            "red1 could not keep solution odometry of task self-localisation: "
            "no process of this layout has 'self-localisation'");
  play(*run, 0.2);
  ASSERT_TRUE(run->setLayout(layoutNamed("balanced")).empty());
  EXPECT_TRUE(run->lostChoices().empty());
  play(*run, 0.5);
  EXPECT_EQ(reported.solutions["self-localisation"], "odometry");
}

TEST(SimulatedRun, whatWasRefusedIsNotAskedForAgain) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  auto wrong = solutionRequest("ball-model", "telepathy");
  wrong.set_id(77);
  ASSERT_TRUE(run->request(wrong).has_value());
  play(*run, 0.2);
  EXPECT_EQ(reported.accepted,
            (std::map<std::uint64_t, bool>{{77, false}, {reported.accepted.rbegin()->first, true}}));
  ASSERT_TRUE(run->reset(1).empty());
  EXPECT_TRUE(run->lostChoices().empty());
}

TEST(SimulatedRun, inAPauseTheNewestValueOfOneThingTakesThePlaceOfThoseBefore) {
  Reported reported;
  const auto run = makeRun(options(), reported.listeners());
  for (std::uint64_t id = 1; id <= 3000; ++id) {
    auto request = parameterRequest(0.001 * static_cast<double>(id));
    request.set_id(id);
    ASSERT_TRUE(run->request(request).has_value()) << id;
    run->publishComingAnswers();
  }
  EXPECT_EQ(reported.accepted.size(), 3001U);
  play(*run, 0.5);
  EXPECT_EQ(reported.memory, 3);
}

TEST(SimulatedRun, aLayoutThatCannotBeUsedLeavesTheRunAsItWas) {
  const auto run = makeRun(options());
  const TestFolder folder;
  const auto file = folder / "broken-layout.yaml";
  std::ofstream(file)
      << "version: 1\nname: broken\nprocesses:\n  - name: cognition\n    blocking: [camera/image]\n"
         "    tasks:\n      - segmentation: telepathy\n";
  const robotlink::Errors errors = run->setLayout(file);
  EXPECT_NE(robotlink::describe(errors).find(file.string() + ":7:9: "), std::string::npos)
      << robotlink::describe(errors);
  play(*run, 0.5);
  EXPECT_EQ(run->world().digest(), digestAfter(options(), 0.5));
}

TEST(SimulatedRun, aResetThatCannotBeDoneLeavesTheRunAsItWas) {
  const TestFolder folder;
  const auto file = folder / "soon-broken-layout.yaml";
  RunOptions chosen = options();
  std::filesystem::copy_file(layoutNamed("compact"), file);
  chosen.layout = file;
  const auto run = makeRun(chosen);
  play(*run, 0.8);
  std::ofstream(file) << "version: 1\nname: [broken\n";
  EXPECT_FALSE(run->reset(2).empty());
  play(*run, 0.2);
  EXPECT_EQ(run->world().digest(), digestAfter(options(), 1));
}

TEST(SimulatedRun, allShippedScenesAndMapsPlayWithoutTrouble) {
  EXPECT_GE(shippedScenes().size(), 3U);
  for (const auto& scene : shippedScenes()) {
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
  const auto layouts = layoutsFor(*robot);
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
  RunOptions broken = options();
  broken.layout = folder.write("breaking.yaml",
                               "version: 1\nname: breaking\nhelp: Is broken.\nprocesses:\n"
                               "  - {name: worker, period_ms: 8, tasks: [layout-breaker: break]}\n"
                               "  - {name: debug, debug: true, period_ms: 16}\n");
  Reported reported;
  const auto run = makeRun(broken, reported.listeners());
  play(*run, 0.1);
  layoutToBreak = folder / "breaking.yaml";
  EXPECT_EQ(robotlink::describe(run->reset(1)), "");
  layoutToBreak.clear();
  play(*run, 0.1);
  EXPECT_NE(robotlink::describe(run->reset(1)), "") << "now it is broken from the start";
  play(*run, 0.1);
}

TEST(ProgramSetups, parametersOfProgramsThatBeginLaterAreAdded) {
  robotcontrol::ProgramSetup setup;
  robotlink::SharedDebugQueue queue;
  auto& values = queue.add<robotcontrol::ParameterValues>("parameters/path-planning/grid");
  values.set_task("path-planning");
  values.set_solution("grid");
  values.mutable_value()->set_data("new");
  EXPECT_TRUE(follow(setup, queue.messages.front()));
  ASSERT_EQ(setup.parameters_size(), 1);
  EXPECT_EQ(setup.parameters(0).solution(), "grid");
  EXPECT_FALSE(follow(setup, queue.messages.front())) << "nothing new";
}

TEST(SimulatedRun, aRobotThatDoesNotExistIsRefusedByName) {
  const auto run = makeRun(options());
  robotcontrol::Request request = keyRequestOfRed1("timing/tasks");
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
  trials.run = options();
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
