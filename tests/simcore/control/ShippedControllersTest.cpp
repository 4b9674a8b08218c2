// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped controllers, in the shipped scene that shows them.
#include <gmock/gmock.h>

#include <cmath>

#include "simcore/Simulation.h"
#include "simcore/control/Controllers.h"
#include "simcore/world/ViewEvent.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

constexpr int kSecondOfSteps = 250;

class ElevatorSceneTest : public testing::Test {
 protected:
  ElevatorSceneTest() {
    const auto scene =
        Scene::load(std::filesystem::path(ROBOTCONTROL_SOURCE_DIR) / "resources/scenes/elevator.sdf");
    if (!scene) {
      ADD_FAILURE() << robotlink::describe(scene.error());
      return;
    }
    simulation_ = std::move(Simulation::create(*scene, {}).value());
  }

  void pass(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * kSecondOfSteps); ++i) simulation_->step();
  }
  double number(const std::string& path) {
    return simulation_->read(path).value_or(std::vector<double>{std::nan("")}).front();
  }
  void press(const std::string& key) {
    ViewEvent event;
    event.key = key;
    ASSERT_TRUE(simulation_->addEvent(event));
  }
  double heightOf(const std::string& model) { return simulation_->modelPose(model)->translation().z(); }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(ElevatorSceneTest, allOfItsControllersRun) {
  ASSERT_TRUE(simulation_);
  pass(1);
  ASSERT_EQ(simulation_->controllers().size(), 2U);
  for (const ControllerStatus& each : simulation_->controllers())
    EXPECT_TRUE(each.isOn()) << each.path << ": " << each.trouble;
}

TEST_F(ElevatorSceneTest, aKeyCallsTheCabinToAFloorWithWhatIsOnIt) {
  ASSERT_TRUE(simulation_);
  pass(1);
  EXPECT_EQ(number("elevator/elevator/floor"), 0);
  const double before = heightOf("parcel");
  press("3");
  pass(0.1);
  EXPECT_EQ(simulation_->read("elevator/elevator/calls").value().at(2), 1);
  pass(6);
  EXPECT_EQ(number("elevator/elevator/floor"), 2);
  EXPECT_NEAR(number("elevator/rail/position"), 1.6, 0.02);
  EXPECT_NEAR(heightOf("parcel"), before + 1.6, 0.03);
  EXPECT_EQ(simulation_->read("elevator/elevator/calls").value().at(2), 0);
}

TEST_F(ElevatorSceneTest, aClickOnAButtonCallsIt) {
  ASSERT_TRUE(simulation_);
  pass(0.5);
  ViewEvent click;
  click.kind = ViewEvent::Kind::kMousePressed;
  click.button = 1;
  // The button of the second floor is on the front of the shaft's post.
  click.origin = {0.65, -3, 1.0};
  click.direction = {0, 1, 0};
  ASSERT_TRUE(simulation_->addEvent(click));
  simulation_->step();
  ASSERT_EQ(simulation_->events().size(), 1U);
  EXPECT_EQ(simulation_->events()[0].object, "elevator/shaft/button2");
  pass(5);
  EXPECT_EQ(number("elevator/elevator/floor"), 1);
  EXPECT_NEAR(number("elevator/rail/position"), 0.8, 0.02);
}

TEST_F(ElevatorSceneTest, aBallThatHasLeftItsAreaIsPutBack) {
  ASSERT_TRUE(simulation_);
  ASSERT_TRUE(simulation_->placeModel("ball", {6, 0, 0}));
  pass(0.5);
  EXPECT_EQ(number("ball_replacer/count"), 0) << "there is some patience";
  pass(1);
  EXPECT_EQ(number("ball_replacer/count"), 1);
  EXPECT_NEAR(simulation_->modelPose("ball")->translation().head<2>().norm(), 1.5, 0.3);
}

TEST_F(ElevatorSceneTest, aResetPutsAllBack) {
  ASSERT_TRUE(simulation_);
  const auto play = [this] {
    press("2");
    pass(3);
    return simulation_->digest();
  };
  simulation_->reset(3);
  const auto first = play();
  simulation_->reset(3);
  EXPECT_EQ(play(), first);
  EXPECT_EQ(simulation_->port("elevator/elevator/panel")->info.shape[0], 36);
}

}  // namespace
}  // namespace simcore
