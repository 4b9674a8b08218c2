// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SimulationFeed.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "app/core/Workbench.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "tests/app/TickUntil.h"

using namespace app;
using robotcontrol::SimulationStatus;

namespace {

/// A workbench that is ticked until something holds.
class SimulationFeedTest : public testing::Test {
 protected:
  SimulationFeedTest()
      : workbench(std::filesystem::path(testing::TempDir()) / ("workbench-" + std::to_string(::getpid()))) {
    workbench.onErrors([this](const robotlink::Errors& e) { errors = e; });
    workbench.open(SimulationFeed::opening(defaultSimulation()));
    EXPECT_TRUE(waitFor([this] { return workbench.loaded() != nullptr && status() != nullptr; }));
  }

  template <typename Condition>
  bool waitFor(Condition condition) {
    return app::test::tickUntil(workbench, condition);
  }
  const SimulationStatus* status() {
    return workbench.session().store().latestAs<SimulationStatus>("simulation",
                                                                  workbench.session().timeline().newest());
  }
  void run(const char* line) {
    const auto done = workbench.commands().runLine(line);
    EXPECT_TRUE(done.has_value()) << line << ": " << (done ? "" : done.error().describe());
  }

  Workbench workbench;
  robotlink::Errors errors;
};

}  // namespace

TEST_F(SimulationFeedTest, aLoadedSceneWaitsAtItsStart) {
  EXPECT_FALSE(status()->running());
  EXPECT_EQ(status()->steps(), 0U);
  const auto* scene = workbench.session().store().latest("scene", workbench.session().timeline().newest());
  ASSERT_NE(scene, nullptr);
  EXPECT_GT(dynamic_cast<const foxglove::SceneUpdate&>(*scene->value).entities_size(), 20);
  EXPECT_EQ(workbench.session().robots(), std::vector<std::string>{"red1"});
}

TEST_F(SimulationFeedTest, aStepIsEightMillisecondsAndResetGoesBack) {
  run("simulation.step");
  EXPECT_TRUE(waitFor([this] { return status()->steps() == 2; }));
  EXPECT_NEAR(status()->time(), 0.008, 1e-9);
  run("simulation.reset");
  EXPECT_TRUE(waitFor([this] { return status()->steps() == 0; }));
}

TEST_F(SimulationFeedTest, itRunsAtTheChosenSpeedUntilItIsPaused) {
  run("simulation.speed 0.5");
  const auto start = std::chrono::steady_clock::now();
  run("simulation.start");
  ASSERT_TRUE(waitFor([this] { return status()->time() > 0.4; }));
  const double real = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LE(status()->time(), 0.5 * real + 0.05)
      << "it is never ahead of its speed, however busy the machine is";
  run("simulation.pause");
  ASSERT_TRUE(waitFor([this] { return !status()->running(); }));
  const auto steps = status()->steps();
  run("simulation.light 0.5 0");
  ASSERT_TRUE(waitFor([this] { return status()->brightness() == 0.5; }))
      << "what is asked in the pause is done";
  EXPECT_EQ(status()->steps(), steps);
}

TEST_F(SimulationFeedTest, theLightIsChangedAndKeptByAReset) {
  run("simulation.light 0.5 -0.25");
  ASSERT_TRUE(waitFor([this] { return status()->brightness() == 0.5; }));
  EXPECT_EQ(status()->warmth(), -0.25);
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 2; }));
  run("simulation.reset");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 0; }));
  EXPECT_EQ(status()->brightness(), 0.5);
  run("simulation.light 99 0");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_NE(robotlink::describe(errors).find("the brightness must be between 0 and 10"), std::string::npos);
}

TEST_F(SimulationFeedTest, keysAndClicksThatNoControllerHearsAreRefused) {
  for (const char* line : {"simulation.key A", "simulation.click 0 0 5 0 0 0"}) {
    errors.clear();
    run(line);
    ASSERT_TRUE(waitFor([this] { return !errors.empty(); })) << line;
    EXPECT_NE(robotlink::describe(errors).find("no controller"), std::string::npos);
  }
}

TEST_F(SimulationFeedTest, aSensorGetsOtherErrorsWhileItRuns) {
  run("simulation.sensor-errors red1/headPan/position --noise 0.1 --delay 0.05");
  run("simulation.sensor-errors red1/camera/image --noise 3");
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 2; }));
  EXPECT_TRUE(errors.empty()) << robotlink::describe(errors);
  run("simulation.sensor-errors red1/headPan/position --drift 0.1 --precision 0.01");
  run("simulation.step");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 4; }));
  EXPECT_TRUE(errors.empty()) << robotlink::describe(errors);
  run("simulation.sensor-errors red1/headPan/position --delay 7");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_NE(robotlink::describe(errors).find("a delay must be between 0 and 1 s"), std::string::npos);
  errors.clear();
  run("simulation.sensor-errors red1/nose");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_NE(robotlink::describe(errors).find("there is no sensor 'red1/nose'"), std::string::npos);
  errors.clear();
  run("simulation.door red1/nose open");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_NE(robotlink::describe(errors).find("there is no door 'red1/nose'"), std::string::npos);
}

TEST_F(SimulationFeedTest, numbersThatARequestLeavesOutStayAsTheyAre) {
  run("simulation.speed 2");
  run("simulation.light 0.5 0");
  robotcontrol::Request reset, light;
  reset.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::RESET);
  light.mutable_set_lighting()->set_warmth(0.25);
  workbench.session().request(reset);
  workbench.session().request(light);
  ASSERT_TRUE(waitFor([this] { return status()->warmth() == 0.25; }));
  EXPECT_EQ(status()->brightness(), 0.5);
  EXPECT_EQ(status()->requested_speed(), 2);
}

TEST_F(SimulationFeedTest, aBrokenSceneIsReportedAndTheOldOneGoesOn) {
  run("simulation.start");
  run("simulation.open /no/such/scene.sdf");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_NE(robotlink::describe(errors).find("/no/such/scene.sdf"), std::string::npos);
  const double time = status()->time();
  EXPECT_TRUE(waitFor([&] { return status()->time() > time; }));
}

TEST_F(SimulationFeedTest, portsAreReadAndHeldWhileTheSimulationIsPaused) {
  const auto readings = [this] {
    return workbench.session().store().latestAs<robotcontrol::PortReadings>(
        "ports", workbench.session().timeline().newest());
  };
  EXPECT_EQ(readings(), nullptr) << "nobody has asked";
  robotcontrol::Request request;
  request.mutable_read_ports()->add_ports("red1/accelerometer");
  workbench.session().request(request);
  ASSERT_TRUE(waitFor([&] { return readings() != nullptr && readings()->readings_size() == 1; }));
  EXPECT_EQ(readings()->readings(0).values_size(), 3);
  run("scene.hold red1/headPan/request 0.25");
  ASSERT_TRUE(waitFor([&] { return readings()->held_size() == 1; }));
  EXPECT_EQ(readings()->held(0).values(0), 0.25);
  run("simulation.reset");
  EXPECT_TRUE(waitFor([&] { return readings() != nullptr && readings()->held_size() == 0; }));
}

TEST_F(SimulationFeedTest, anActuatorThatIsNotThereIsNamed) {
  ASSERT_TRUE(waitFor([this] {
    return workbench.session().store().latest("objects", workbench.session().timeline().newest()) != nullptr;
  }));
  EXPECT_FALSE(workbench.commands().runLine("scene.hold red1/headPam/request 0.25"));
}

TEST_F(SimulationFeedTest, aModelIsPlacedWhileTheSimulationIsPaused) {
  robotcontrol::Request request;
  request.mutable_place_model()->set_model("ball");
  request.mutable_place_model()->mutable_pose_in_field()->set_x(0.5);
  request.mutable_place_model()->mutable_pose_in_field()->set_y(-0.5);
  bool accepted = false;
  workbench.session().request(request, [&](const auto& result) { accepted = result.accepted(); });
  EXPECT_TRUE(waitFor([&] { return accepted; }));
}

TEST_F(SimulationFeedTest, whatCannotBeDoneIsRefusedWithAReason) {
  EXPECT_FALSE(workbench.commands().runLine("simulation.speed -3").has_value());
  EXPECT_FALSE(workbench.commands().runLine("robot.select nobody").has_value());
  std::string reason;
  robotcontrol::Request request;
  request.mutable_place_model()->set_model("moon");
  workbench.session().request(request, [&](const auto& result) { reason = result.reason(); });
  EXPECT_TRUE(waitFor([&] { return !reason.empty(); }));
}

TEST_F(SimulationFeedTest, robotsAndPortsAreCountedInWholeNumbers) {
  const auto reason = [this](const std::string& robots, const std::string& port) {
    const auto done = workbench.commands().runLine("simulation.setup field2002 ers210 " + robots + " false " +
                                                   port + " false both");
    return done ? std::string() : done.error().text;
  };
  EXPECT_EQ(reason("1.5", "0"), "the number of robots must be a whole number between 0 and 100");
  EXPECT_EQ(reason("101", "0"), "the number of robots must be a whole number between 0 and 100");
  EXPECT_EQ(reason("1", "8101.5"),
            "the first port must be a whole number between 1 and 65435, or 0 for none");
  EXPECT_EQ(reason("0", "0"), "");
  EXPECT_TRUE(waitFor([this] { return !workbench.loading(); }));
}

TEST_F(SimulationFeedTest, aPausedRobotPublishesItsTablesAndAnswersRequests) {
  const auto* solutions =
      workbench.session().store().latest("red1/tables/solutions", workbench.session().timeline().newest());
  const auto* keys =
      workbench.session().store().latest("red1/tables/keys", workbench.session().timeline().newest());
  EXPECT_NE(solutions, nullptr) << "before the first step";
  EXPECT_NE(keys, nullptr);
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_get_parameters()->set_task("ball-percept");
  request.mutable_get_parameters()->set_solution("region");
  bool accepted = false, seen = false;
  workbench.session().request(request, [&](const auto& result) {
    accepted = result.accepted();
    seen = workbench.session().store().find("red1/parameters/ball-percept/region") != nullptr;
  });
  ASSERT_TRUE(waitFor([&] { return accepted; }));
  EXPECT_TRUE(seen) << "who is answered sees the values";
  request.mutable_get_parameters()->set_solution("telepathy");
  std::string reason;
  workbench.session().request(request, [&](const auto& result) { reason = result.reason(); });
  ASSERT_TRUE(waitFor([&] { return !reason.empty(); }));
  EXPECT_EQ(status()->steps(), 0U) << "and no time has passed";
}

TEST_F(SimulationFeedTest, whatALayoutCannotFulfillIsSaid) {
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_select_solution()->set_task("self-localisation");
  request.mutable_select_solution()->set_solution("odometry");
  bool accepted = false;
  workbench.session().request(request, [&](const auto& result) { accepted = result.accepted(); });
  ASSERT_TRUE(waitFor([&] { return accepted; }));
  run("layout.open perception");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_NE(
      robotlink::describe(errors).find("red1 could not keep solution odometry of task self-localisation"),
      std::string::npos);
}

TEST_F(SimulationFeedTest, startThatIsPressedWhileAnotherSceneLoadsStartsThatScene) {
  run("simulation.open pioneer");
  run("simulation.start");
  ASSERT_TRUE(waitFor([this] { return !workbench.loading(); }));
  EXPECT_EQ(workbench.loaded()->title, "pioneer");
  EXPECT_TRUE(waitFor([this] { return status() != nullptr && status()->running() && status()->time() > 0; }));
}
