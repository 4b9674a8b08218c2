// SPDX-License-Identifier: GPL-3.0-or-later
// Vehicles that a person drives by hand, as scene.hold and the sliders of the scene tree do.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/platforms/simulated/world/HeldActuators.h"
#include "app/platforms/simulated/world/WorldObjects.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"

namespace {

std::unique_ptr<simcore::Simulation> vehicles() {
  const auto scene = simcore::Scene::load(robotlink::resource("scenes/vehicles.sdf"));
  EXPECT_TRUE(scene) << (scene ? "" : robotlink::describe(scene.error()));
  return scene ? std::move(simcore::Simulation::create(*scene, {}).value()) : nullptr;
}

}  // namespace

TEST(HeldGuides, aVehicleIsDrivenUntilItIsReleased) {
  const auto simulation = vehicles();
  ASSERT_NE(simulation, nullptr);
  app::HeldActuators held;
  ASSERT_TRUE(held.hold(*simulation, "car/drive", {0.5, 0.1}));
  const auto drive = [&](int steps) {
    const double before = simulation->modelPose("car")->translation().x();
    for (int i = 0; i < steps; ++i) {
      held.apply(*simulation);
      simulation->step();
    }
    return simulation->modelPose("car")->translation().x() - before;
  };
  EXPECT_GT(drive(250), 0.3);
  held.release(*simulation, "car/drive");
  drive(250);
  EXPECT_LT(drive(100), 0.01) << "it has stopped";
}

TEST(HeldGuides, whatDoesNotFitIsRefused) {
  const auto simulation = vehicles();
  ASSERT_NE(simulation, nullptr);
  app::HeldActuators held;
  const auto few = held.hold(*simulation, "omni/drive", {0.5});
  ASSERT_FALSE(few);
  EXPECT_NE(few.error().text.find("takes 3 values, not 1"), std::string::npos) << few.error().text;
  const auto unknown = held.hold(*simulation, "omni/drvie", {0.5, 0, 0});
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().text.find("omni/drive"), std::string::npos) << "it suggests the right name";
}

TEST(HeldGuides, eachValueIsClampedToItsOwnRange) {
  const auto simulation = vehicles();
  ASSERT_NE(simulation, nullptr);
  app::HeldActuators held;
  ASSERT_TRUE(held.hold(*simulation, "car/drive", {100, -100}));
  const simcore::GuidedMotion& motion = simulation->guides()[simulation->port("car/drive")->index].motion;
  EXPECT_EQ(held.all().at("car/drive").values,
            (std::vector<double>{motion.maximumSpeed, -motion.maximumSteering}));
  const auto all = app::worldObjects(*simulation);
  const auto drive = std::ranges::find(all->objects(), "car/drive", &robotcontrol::WorldObject::path);
  ASSERT_NE(drive, all->objects().end());
  const auto maximum = std::ranges::find(drive->properties(), "maximum", &robotcontrol::WorldProperty::name);
  ASSERT_NE(maximum, drive->properties().end());
  EXPECT_EQ(maximum->values(0), motion.maximumSpeed);
  EXPECT_EQ(maximum->values(1), motion.maximumSteering);
  EXPECT_EQ(maximum->unit(), "m/s, rad");
}
