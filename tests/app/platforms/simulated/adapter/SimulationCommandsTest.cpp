// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/adapter/SimulationCommands.h"

#include <gmock/gmock.h>

#include "robotcontrol/World.pb.h"
#include "tests/app/open/AskedWorkbench.h"

namespace app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SimulationCommandsTest : public testing::Test {
 protected:
  test::AskedWorkbench desk_;
};

TEST_F(SimulationCommandsTest, runningLeavesTheSpeedAsItIs) {
  EXPECT_EQ(desk_.run("simulation.start"), "control_simulation { action: START speed: -1 }");
  EXPECT_EQ(desk_.run("simulation.pause"), "control_simulation { action: PAUSE speed: -1 }");
  EXPECT_EQ(desk_.run("simulation.step"), "control_simulation { action: STEP speed: -1 }");
  EXPECT_EQ(desk_.run("simulation.reset"), "control_simulation { action: RESET speed: -1 }");
}

TEST_F(SimulationCommandsTest, theSpeedIsInItsRange) {
  EXPECT_EQ(desk_.run("simulation.speed 0"), "control_simulation { speed: 0 }") << "as fast as possible";
  EXPECT_EQ(desk_.run("simulation.speed 100"), "control_simulation { speed: 100 }");
  for (const char* speed : {"-1", "100.1"}) {
    EXPECT_THAT(desk_.run("simulation.speed " + std::string(speed)),
                HasSubstr("the speed must be between 0 and 100 times real time"))
        << speed;
  }
}

TEST_F(SimulationCommandsTest, snapshotsAreNamesOrFiles) {
  EXPECT_EQ(desk_.run("simulation.snapshot"), "control_snapshots { name: \"snapshot\" }");
  EXPECT_EQ(desk_.run("simulation.snapshot before.kick"), "control_snapshots { name: \"before.kick\" }");
  EXPECT_EQ(desk_.run("simulation.restore before --programs on"),
            "control_snapshots { action: RESTORE name: \"before\" programs: true }");
  EXPECT_EQ(desk_.run("simulation.restore /tmp/a.snapshot"),
            "control_snapshots { action: RESTORE file: \"/tmp/a.snapshot\" }");
  EXPECT_EQ(desk_.run("simulation.snapshot folder/a"),
            "control_snapshots { file: \"" + std::filesystem::absolute("folder/a").string() + "\" }")
      << "whoever writes it may have another folder";
  EXPECT_EQ(desk_.run("simulation.snapshot a.snapshot"),
            "control_snapshots { file: \"" + std::filesystem::absolute("a.snapshot").string() + "\" }");
}

TEST_F(SimulationCommandsTest, snapshotsAreForgottenByTheirNamesOrAll) {
  EXPECT_EQ(desk_.run("simulation.forget"), "control_snapshots { action: FORGET }");
  EXPECT_EQ(desk_.run("simulation.forget before"), "control_snapshots { action: FORGET name: \"before\" }");
  EXPECT_EQ(desk_.run("simulation.cancel"), "control_snapshots { action: CANCEL }");
  EXPECT_THAT(desk_.offered("simulation.restore"), IsEmpty());
  robotcontrol::SimulationStatus status;
  status.add_snapshots()->set_name("before");
  status.add_snapshots()->set_name("after");
  desk_.publish("simulation", status);
  EXPECT_THAT(desk_.offered("simulation.restore"), ElementsAre("before", "after"));
  EXPECT_THAT(desk_.offered("simulation.forget", {"before"}), IsEmpty());
}

TEST_F(SimulationCommandsTest, goingBackNeedsATime) {
  EXPECT_EQ(desk_.run("simulation.rewind"), "control_snapshots { action: REWIND seconds: 1 }");
  for (const char* seconds : {"0", "-1"}) {
    EXPECT_THAT(desk_.run("simulation.rewind " + std::string(seconds)),
                testing::StartsWith("simulation.snapshot: "))
        << seconds;
  }
}

TEST_F(SimulationCommandsTest, aKeyIsPressedAndReleased) {
  EXPECT_EQ(desk_.run("simulation.key Space"),
            "send_event { view: \"command\" key: \"Space\" }; "
            "send_event { kind: KEY_RELEASED view: \"command\" key: \"Space\" }");
}

TEST_F(SimulationCommandsTest, aKeyThatNoKeyboardHasIsRefused) {
  EXPECT_THAT(desk_.run("simulation.key Spce"), testing::HasSubstr("did you mean 'Space'?"));
  EXPECT_THAT(desk_.run("simulation.key blah"),
              testing::StartsWith("simulation.key: there is no key 'blah'"));
  EXPECT_THAT(desk_.asked, IsEmpty());
  for (const char* key : {"A", "7", "ä", "Left"}) {
    desk_.asked.clear();
    desk_.run("simulation.key " + std::string(key));
    EXPECT_EQ(desk_.asked.size(), 2U) << key;
  }
}

TEST_F(SimulationCommandsTest, aClickGoesAlongARay) {
  desk_.run("simulation.click 1 2 3 1 2 0.5");
  ASSERT_EQ(desk_.asked.size(), 2U);
  const auto& pressed = desk_.asked[0].send_event();
  EXPECT_EQ(pressed.kind(), robotcontrol::ViewEvent::MOUSE_PRESSED);
  EXPECT_EQ(pressed.button(), 1);
  EXPECT_EQ(pressed.origin().z(), 3);
  EXPECT_EQ(pressed.direction().x(), 0);
  EXPECT_EQ(pressed.direction().z(), -2.5);
  EXPECT_EQ(desk_.asked[1].send_event().kind(), robotcontrol::ViewEvent::MOUSE_RELEASED);
}

TEST_F(SimulationCommandsTest, doorsLightsAndSensorsAreSet) {
  EXPECT_EQ(desk_.run("simulation.door gate/hinge/door open"),
            "move_door { door: \"gate/hinge/door\" open: true }");
  EXPECT_EQ(desk_.run("simulation.door gate/hinge/door close"), "move_door { door: \"gate/hinge/door\" }");
  EXPECT_EQ(desk_.run("simulation.light 0.5 -0.25"), "set_lighting { brightness: 0.5 warmth: -0.25 }");
  EXPECT_EQ(desk_.run("simulation.sensor-errors red1/psd --noise 0.1 --rate 5"),
            "set_sensor_errors { sensor: \"red1/psd\" noise: 0.1 rate: 5 }");
  EXPECT_EQ(desk_.run("simulation.sensor-errors red1/psd --drift 0.01 --drift_time 0 --precision 0.1"),
            "set_sensor_errors { sensor: \"red1/psd\" drift: 0.01 drift_time: 0 precision: 0.1 }");
  EXPECT_EQ(desk_.run("simulation.sensor-errors red1/psd"), "set_sensor_errors { sensor: \"red1/psd\" }");
}

TEST_F(SimulationCommandsTest, noiseIsThatOfASimulation) {
  EXPECT_EQ(desk_.run("simulation.noise off"), "simulation.none: there is no simulation; open a scene first");
  desk_.workbench.open(test::fakeOpening(test::fakePlatform("rover"), std::make_shared<test::FeedNotes>()));
  ASSERT_TRUE(test::tickUntil(desk_.workbench, [this] { return !desk_.workbench.loading(); }));
  EXPECT_EQ(desk_.run("simulation.noise off"), "simulation.none: there is no simulation; open a scene first");
}

}  // namespace
}  // namespace app
