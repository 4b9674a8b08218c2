// SPDX-License-Identifier: GPL-3.0-or-later
// All actuators of a simulation can be held, not only those of robots.
#include "app/platforms/simulated/world/HeldActuators.h"

#include <gmock/gmock.h>

#include "app/platforms/simulated/world/WorldObjects.h"
#include "robotcontrol/World.pb.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "tests/TestFolder.h"

using namespace app;
using robotcontrol::WorldObject;

namespace {

const char* const kHall =
    R"(<sdf version="1.9" xmlns:robotcontrol="urn:robotcontrol:sdf"><world name="hall">
<include><uri>model://ground_plane</uri></include>
<include><uri>model://sliding_door</uri><name>gate</name><pose>3 0 0 0 0 0</pose></include>
<model name="cart"><pose>0 0 0.1 0 0 0</pose>
<robotcontrol:guided kind="omni" name="motion"><robotcontrol:maximum_speed>1</robotcontrol:maximum_speed></robotcontrol:guided>
<link name="body"><inertial><mass>2</mass><inertia><ixx>0.02</ixx><iyy>0.02</iyy><izz>0.02</izz></inertia></inertial>
<collision name="c"><geometry><box><size>0.3 0.3 0.2</size></box></geometry></collision></link></model>
</world></sdf>)";

class HeldActuatorsTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto scene = simcore::Scene::load(folder_.write("hall.sdf", kHall));
    ASSERT_TRUE(scene.has_value()) << robotlink::describe(scene.error());
    simulation_ = std::move(simcore::Simulation::create(*scene, {}).value());
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) {
      held_.apply(*simulation_);
      simulation_->step();
    }
  }

  const TestFolder folder_;
  std::unique_ptr<simcore::Simulation> simulation_;
  HeldActuators held_;
};

}  // namespace

TEST_F(HeldActuatorsTest, aGuidedModelMovesWhileItIsHeldAndStopsThen) {
  ASSERT_TRUE(held_.hold(*simulation_, "cart/motion", {0.5, 0, 0}));
  run(250);
  const double moved = simulation_->modelPose("cart")->translation().x();
  EXPECT_GT(moved, 0.2);
  held_.release(*simulation_, "cart/motion");
  run(250);
  const double later = simulation_->modelPose("cart")->translation().x();
  run(250);
  EXPECT_NEAR(simulation_->modelPose("cart")->translation().x(), later, 0.02);
}

TEST_F(HeldActuatorsTest, aDoorStaysOpenWhileItIsHeld) {
  ASSERT_EQ(simulation_->doors().size(), 1U);
  const std::string door = simulation_->doors().front().info.path;
  ASSERT_TRUE(held_.hold(*simulation_, door, {1}));
  run(5000);
  EXPECT_TRUE(simulation_->isDoorOpen(0)) << "20 s are longer than its own time";
  held_.release(*simulation_, door);
  run(5000);
  EXPECT_FALSE(simulation_->isDoorOpen(0));
}

TEST_F(HeldActuatorsTest, valuesAreLimitedAndOthersRefused) {
  ASSERT_TRUE(held_.hold(*simulation_, "cart/motion", {100, 0, 0}));
  EXPECT_LT(held_.all().at("cart/motion").values.front(), 100);
  EXPECT_FALSE(held_.hold(*simulation_, "cart/motion", {1}));
  EXPECT_FALSE(held_.hold(*simulation_, "cart/true_pose", {1}));
  EXPECT_FALSE(held_.hold(*simulation_, "cart/motion", {0, 0, std::nan("")}));
}

TEST_F(HeldActuatorsTest, allOfThemHaveSliders) {
  const auto all = worldObjects(*simulation_);
  for (const auto& port : simulation_->ports()) {
    if (!port.isActuator()) continue;
    const auto object = std::ranges::find(all->objects(), port.info.path, &WorldObject::path);
    ASSERT_NE(object, all->objects().end()) << port.info.path;
    EXPECT_TRUE(object->port().is_actuator()) << port.info.path;
    EXPECT_LT(object->port().minimum(), object->port().maximum()) << port.info.path;
  }
}
