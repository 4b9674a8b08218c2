// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "app/core/Workbench.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "foxglove/Grid.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/commands/CommandCatalog.h"
#include "robotlink/session/KeyPresets.h"
#include "tests/TestFolder.h"
#include "tests/app/TickUntil.h"

using namespace app;

namespace {

class RobotCommandsTest : public testing::Test {
 protected:
  std::string refusal(const std::string& command, const std::vector<robotlink::CommandTable::Value>& values) {
    const auto done = workbench_.commands().run(command, values);
    return done ? std::string() : done.error().id;
  }
  const std::vector<robotlink::CommandTable::Command> ofWindow_ = robotlink::windowCatalog();
  const std::vector<robotlink::CommandTable::Command> ofControl_ = robotlink::controlCatalog();
  const std::vector<robotlink::CommandTable::Command> ofColors_ = robotlink::colorCatalog();
  const TestFolder home_;
  Workbench workbench_{home_.path()};
};

}  // namespace

TEST_F(RobotCommandsTest, withoutARobotNothingCanBeAskedOfIt) {
  EXPECT_EQ(refusal("robot.goal", {1.0, 2.0}), "robot.none");
  EXPECT_EQ(refusal("robot.motors", {true}), "robot.none");
  EXPECT_EQ(refusal("robot.select", {std::string("nobody")}), "robot.unknown");
}

TEST_F(RobotCommandsTest, aGripperAndOutputsAreMovedByPacketsForTheBase) {
  EXPECT_EQ(refusal("robot.gripper", {std::string("open")}), "robot.none");
  auto& session = workbench_.session();
  session.setRobots({"p3dx1"});
  std::string packet;
  session.setRequestSink([&](const auto& request) {
    packet = request.control_drive().packets_size() == 1 ? request.control_drive().packets(0) : "";
  });
  const auto bytesOf = [&](const std::string& line) {
    packet.clear();
    const auto done = workbench_.commands().runLine(line);
    return done ? packet : done.error().id;
  };
  // FA FB, length, command, its argument with its sign, and the checksum.
  EXPECT_EQ(bytesOf("robot.gripper open").substr(0, 7), std::string("\xFA\xFB\x06\x21\x3B\x01\x00", 7));
  EXPECT_EQ(bytesOf("robot.gripper halt").substr(0, 7), std::string("\xFA\xFB\x06\x21\x3B\x0F\x00", 7));
  EXPECT_EQ(bytesOf("robot.output 3 true").substr(0, 7), std::string("\xFA\xFB\x06\x1E\x3B\x08\x08", 7));
  EXPECT_EQ(bytesOf("robot.output 3 false").substr(0, 7), std::string("\xFA\xFB\x06\x1E\x3B\x00\x08", 7));
  EXPECT_EQ(bytesOf("robot.output 8 true"), "robot.output");
  EXPECT_EQ(bytesOf("robot.output 1.5 true"), "robot.output");
  session.setRequestSink({});
}

TEST_F(RobotCommandsTest, aMapIsSavedOnceItIsThere) {
  EXPECT_EQ(refusal("robot.save-map", {(home_ / "made.map").string()}), "robot.none");
  auto& session = workbench_.session();
  session.setRobots({"p3at1"});
  std::string key;
  session.setRequestSink([&](const auto& request) { key = request.set_key().name(); });
  EXPECT_EQ(refusal("robot.save-map", {(home_ / "made.map").string()}), "robot.no-map");
  EXPECT_EQ(key, "package/models/map") << "the robot is asked to publish it";
  session.setRequestSink({});

  auto grid = std::make_shared<foxglove::Grid>();
  grid->set_column_count(2);
  grid->mutable_cell_size()->set_x(0.05);
  grid->mutable_cell_size()->set_y(0.05);
  grid->mutable_pose()->mutable_orientation()->set_w(1);
  grid->set_row_stride(2);
  grid->set_cell_stride(1);
  grid->add_fields()->set_name("occupancy");
  grid->mutable_fields(0)->set_type(foxglove::PackedElementField::INT8);
  grid->set_data(std::string("\x00\xFF\x64\x00", 4));
  auto pose = std::make_shared<robotcontrol::RobotPose>();
  pose->mutable_robot_in_field()->set_x(2);
  const robotlink::Instant now{std::chrono::seconds(1)};
  session.push({"p3at1/models/map", now, grid});
  session.push({"p3at1/models/pose", now, pose});
  session.tick();
  EXPECT_EQ(refusal("robot.save-map", {(home_ / "made.map").string()}), "");
  const auto map = robotlink::GroundMap::load(home_ / "made.map");
  ASSERT_TRUE(map) << robotlink::describe(map.error());
  ASSERT_EQ(map->points.size(), 1U);
  EXPECT_EQ(map->resolution, 0.05);
  ASSERT_NE(map->find(robotlink::GroundMap::Place::Kind::kHome), nullptr);
  EXPECT_EQ(map->find(robotlink::GroundMap::Place::Kind::kHome)->pose.x, 2);
}

TEST_F(RobotCommandsTest, onlyWhatNeedsTheWindowWaitsForIt) {
  const auto& commands = workbench_.commands();
  for (const auto* rows : {&ofWindow_, &ofControl_, &ofColors_}) {
    for (const auto& row : *rows) EXPECT_FALSE(commands.isAttached(row.name)) << row.name;
  }
  EXPECT_EQ(commands.unattached().size(), ofWindow_.size() + ofControl_.size() + ofColors_.size());
}

TEST_F(RobotCommandsTest, aKeysModeIsOneOfFive) {
  for (const char* mode : {"off", "always", "n 3", "every 3", "every-ms 40"}) {
    EXPECT_EQ(refusal("robot.key", {std::string("driving/goal"), std::string(mode)}), "robot.none") << mode;
  }
  for (const char* mode : {"", "on", "n", "n x", "every -1", "always 3", "every-ms 123456789"}) {
    EXPECT_EQ(refusal("robot.key", {std::string("driving/goal"), std::string(mode)}), "robot.key") << mode;
  }
}

TEST_F(RobotCommandsTest, aKeyAndASolutionAreSetInTheSelectedRobotInAnotherOneOrInAll) {
  auto& session = workbench_.session();
  std::vector<std::string> asked;
  session.setRobots({"red1", "red2", "blue1"});
  session.setRequestSink([&](const auto& request) { asked.push_back(request.robot()); });
  const auto run = [&](const std::string& line) {
    asked.clear();
    const auto done = workbench_.commands().runLine(line);
    return done ? std::string() : done.error().text;
  };
  EXPECT_EQ(run("robot.key a/b always"), "");
  EXPECT_EQ(asked, std::vector<std::string>{"red1"});
  EXPECT_EQ(run("robot.key a/b --robot red2"), "");
  EXPECT_EQ(asked, std::vector<std::string>{"red2"});
  EXPECT_EQ(run("robot.key a/b off --robot=all"), "");
  EXPECT_EQ(asked, (std::vector<std::string>{"red1", "red2", "blue1"}));
  EXPECT_EQ(run("robot.solution driving halt --robot all"), "");
  EXPECT_EQ(asked, (std::vector<std::string>{"red1", "red2", "blue1"}));
  EXPECT_NE(run("robot.solution driving halt --robot blue2").find("did you mean"), std::string::npos);
  EXPECT_TRUE(asked.empty());
  auto objects = std::make_shared<robotcontrol::WorldObjects>();
  for (const auto& [name, team] :
       {std::pair("red1", "red"), std::pair("red2", "red"), std::pair("blue1", "blue")}) {
    auto& robot = *objects->add_objects();
    robot.set_path(name);
    robot.add_properties()->set_name("team");
    robot.mutable_properties(0)->set_text(team);
  }
  session.push({"objects", robotlink::Instant{std::chrono::seconds(1)}, objects});
  session.tick();
  EXPECT_EQ(run("robot.solution driving halt --robot red"), "");
  EXPECT_EQ(asked, (std::vector<std::string>{"red1", "red2"}));
  EXPECT_NE(run("robot.solution driving halt --robot rde").find("no robot or team rde"), std::string::npos);
  session.setRequestSink({});
}

TEST_F(RobotCommandsTest, theSolutionThatIsUsedCannotRunInTheShadow) {
  auto& session = workbench_.session();
  std::vector<std::string> asked;
  session.setRobots({"red1", "red2"});
  session.setRequestSink([&](const auto& request) { asked.push_back(request.robot()); });
  for (const auto& [robot, active] : {std::pair("red1", "kalman"), std::pair("red2", "particles")}) {
    auto table = std::make_shared<robotcontrol::SolutionTable>();
    table->add_tasks()->set_name("ball-model");
    table->mutable_tasks(0)->set_active(active);
    session.push(
        {std::string(robot) + "/tables/solutions", robotlink::Instant{std::chrono::seconds(1)}, table});
  }
  session.tick();
  const auto& commands = workbench_.commands();
  const auto refused = commands.runLine("robot.shadow ball-model kalman");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, "robot.shadow");
  EXPECT_TRUE(asked.empty());
  EXPECT_TRUE(commands.runLine("robot.shadow ball-model kalman --on false"));
  EXPECT_TRUE(commands.runLine("robot.shadow ball-model particles"));
  EXPECT_TRUE(commands.runLine("robot.shadow ball-model kalman --robot all")) << "red2 uses another one";
  EXPECT_EQ(asked, (std::vector<std::string>{"red1", "red1", "red1", "red2"}));
  session.setRequestSink({});
}

TEST_F(RobotCommandsTest, aPackageIsSentOnceHeldOrReleased) {
  using robotcontrol::SetPackage;
  auto& session = workbench_.session();
  std::vector<robotcontrol::Request> asked;
  session.setRobots({"red1", "red2"});
  session.setRequestSink([&](const auto& request) { asked.push_back(request); });
  const auto& commands = workbench_.commands();
  ASSERT_TRUE(commands.runLine("robot.package models/ball hold '{\"known\": true}'"));
  EXPECT_EQ(asked.back().robot(), "red1");
  EXPECT_EQ(asked.back().set_package().package(), "models/ball");
  EXPECT_EQ(asked.back().set_package().mode(), SetPackage::HOLD);
  EXPECT_EQ(asked.back().set_package().value().type(), "robotcontrol.BallModel");
  ASSERT_TRUE(commands.runLine("robot.package models/ball release --robot all"));
  ASSERT_EQ(asked.size(), 3U);
  EXPECT_EQ(asked.back().robot(), "red2");
  EXPECT_EQ(asked.back().set_package().mode(), SetPackage::RELEASE);
  const auto wrong =
      commands.runLine("robot.package models/ball once '{\"position_in_robot\": {\"x\": \"far\"}}'");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().text.find("position_in_robot.x"), std::string::npos) << wrong.error().text;
  EXPECT_FALSE(commands.runLine("robot.package models/bal once"));
  EXPECT_EQ(asked.size(), 3U);
  session.setRequestSink({});
}

TEST_F(RobotCommandsTest, whereProgramsRunIsChosenForOneRobotOrAll) {
  using robotcontrol::HostProgram;
  EXPECT_EQ(refusal("robot.host", {std::string("inside")}), "robot.none");
  EXPECT_EQ(refusal("robot.start-again", {std::string("all")}), "robot.none");
  auto& session = workbench_.session();
  robotcontrol::Request asked;
  int count = 0;
  session.setRobots({"red1", "red2"});
  session.setRequestSink([&](const auto& request) {
    asked = request;
    ++count;
  });
  const auto& commands = workbench_.commands();
  ASSERT_TRUE(commands.runLine("robot.host own-process"));
  EXPECT_EQ(asked.robot(), "red1");
  EXPECT_EQ(asked.host_program().where(), HostProgram::OWN_PROCESS);
  ASSERT_TRUE(commands.runLine("robot.host inside --robot all"));
  EXPECT_EQ(asked.robot(), "");
  EXPECT_EQ(asked.host_program().where(), HostProgram::IN_WORKBENCH);
  ASSERT_TRUE(commands.runLine("robot.host threads"));
  EXPECT_EQ(asked.robot(), "");
  EXPECT_EQ(asked.host_program().executor(), HostProgram::THREADS);
  EXPECT_EQ(asked.host_program().where(), HostProgram::UNCHANGED);
  EXPECT_EQ(refusal("robot.host", {std::string("lockstep"), std::string("red2")}), "robot.host");
  ASSERT_TRUE(commands.runLine("robot.start-again --robot red2"));
  EXPECT_EQ(asked.robot(), "red2");
  EXPECT_TRUE(asked.host_program().start_again());
  EXPECT_EQ(count, 4);
  session.setRequestSink({});
}

TEST_F(RobotCommandsTest, aSetUpThatMakesNoSenseIsRefusedAtOnce) {
  const std::string scene = "pioneer", kind = "p3at", both = "both";
  EXPECT_EQ(refusal("simulation.setup", {scene, kind, 101.0, false, 0.0, false, both}), "simulation.setup");
  EXPECT_EQ(refusal("simulation.setup", {scene, kind, 10.0, false, 65530.0, false, both}),
            "simulation.setup");
  EXPECT_EQ(refusal("simulation.setup", {scene, kind, 1.0, false, 0.0, false, std::string("green")}),
            "simulation.setup");
}

TEST_F(RobotCommandsTest, aPioneerOfTheShippedSceneIsAskedByCommands) {
  std::string errors;
  workbench_.onErrors([&](const robotlink::Errors& reported) { errors += robotlink::describe(reported); });
  ASSERT_TRUE(workbench_.commands().run("simulation.setup", {std::string("pioneer"), std::string("p3at"), 0.0,
                                                             true, 0.0, false, std::string("both")}));
  ASSERT_TRUE(test::tickUntil(workbench_, [&] { return workbench_.loaded() != nullptr || !errors.empty(); }));
  ASSERT_EQ(errors, "");
  ASSERT_TRUE(workbench_.commands().run("simulation.start"));
  ASSERT_TRUE(workbench_.commands().run("robot.solution", {std::string("driving"), std::string("halt")}));
  const auto* table = static_cast<const robotcontrol::SolutionTable*>(nullptr);
  EXPECT_TRUE(test::tickUntil(workbench_, [&] {
    table = workbench_.session().store().latestAs<robotcontrol::SolutionTable>(
        "p3at1/tables/solutions", workbench_.session().timeline().newest());
    if (table == nullptr) return false;
    for (const auto& task : table->tasks()) {
      if (task.name() == "driving" && task.active() == "halt") return true;
    }
    return false;
  }));
  EXPECT_EQ(errors, "");
}

TEST_F(RobotCommandsTest, noiseIsSwitchedByOpeningTheSimulationAgain) {
  EXPECT_EQ(refusal("simulation.noise", {false}), "simulation.none");
  workbench_.open(SimulationFeed::opening(defaultSimulation()));
  ASSERT_TRUE(test::tickUntil(workbench_, [&] { return workbench_.loaded() != nullptr; }));
  const auto saysSo = [&] {
    const auto* stream = workbench_.session().store().find("red1/log");
    return stream != nullptr && std::ranges::any_of(stream->messages, [](const auto& message) {
             const auto* log = dynamic_cast<const foxglove::Log*>(message.value.get());
             return log != nullptr && log->message().find("no noise") != std::string::npos;
           });
  };
  ASSERT_TRUE(workbench_.commands().runLine("simulation.noise off"));
  EXPECT_TRUE(test::tickUntil(workbench_, [&] { return !workbench_.loading() && saysSo(); }));
  ASSERT_TRUE(workbench_.commands().runLine("simulation.noise on"));
  EXPECT_TRUE(test::tickUntil(workbench_, [&] { return !workbench_.loading() && !saysSo(); }));
  EXPECT_EQ(workbench_.loaded()->name(), "field2002");
}

TEST_F(RobotCommandsTest, keysThatAreBeingSwitchedOnAreNotLostToTheNextStart) {
  const auto keptImage = [&] {
    const auto kept = robotlink::KeyPresets(home_.path() / "session").load("red1");
    if (!kept) return false;
    return std::ranges::any_of(kept->keys(),
                               [](const auto& key) { return key.name() == "package/camera/image"; });
  };
  workbench_.open(SimulationFeed::opening(defaultSimulation()));
  // Keys are kept in each tick, as if the user quit or opened another scene then.
  bool wasKept = false, wasLost = false;
  EXPECT_TRUE(test::tickUntil(workbench_, [&] {
    EXPECT_TRUE(workbench_.keepKeys());
    const bool exists = std::filesystem::exists(home_.path() / "session" / "red1.keys.json");
    wasKept = keptImage();
    wasLost = wasLost || (exists && !wasKept);
    return wasKept || wasLost;
  }));
  EXPECT_FALSE(wasLost);
}

TEST_F(RobotCommandsTest, whatAProgramWasAskedIsAnsweredEvenIfItsPlatformIsClosed) {
  workbench_.open(SimulationFeed::opening(defaultSimulation()));
  ASSERT_TRUE(test::tickUntil(workbench_, [&] { return workbench_.loaded() != nullptr; }));
  ASSERT_TRUE(workbench_.commands().run("simulation.start"));
  int answers = 0;
  constexpr int kRequests = 20;
  for (int i = 0; i < kRequests; ++i) {
    robotcontrol::Request request;
    request.set_robot("red1");
    request.mutable_set_key()->set_name("package/camera/image");
    request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    workbench_.session().request(request, [&](const auto&) { ++answers; });
  }
  workbench_.close();
  EXPECT_TRUE(test::tickUntil(workbench_, [&] { return answers == kRequests; })) << answers;
}

TEST_F(RobotCommandsTest, loadingEndsHoweverManyLayoutsWereAskedForAtOnce) {
  int refused = 0;
  workbench_.onErrors([&](const robotlink::Errors&) { ++refused; });
  for (int i = 0; i < 100; ++i) workbench_.setLayout("/no/such/layout.yaml");
  // Requests are answered in their turn: all layouts were tried by then, and nobody ticked the workbench.
  bool answered = false;
  robotcontrol::Request request;
  request.mutable_control_simulation();
  workbench_.session().request(request, [&](const auto&) { answered = true; });
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!answered && std::chrono::steady_clock::now() < end) {
    workbench_.session().tick();
    std::this_thread::yield();
  }
  ASSERT_TRUE(answered);
  EXPECT_TRUE(workbench_.loading());
  workbench_.tick();
  EXPECT_FALSE(workbench_.loading());
  EXPECT_EQ(refused, 100);
}
