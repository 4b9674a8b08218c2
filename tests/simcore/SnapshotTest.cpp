// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots and going back: from then on everything is as it was, to the last bit.
#include "simcore/Snapshot.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "robotlink/base/Resources.h"
#include "tests/simcore/SensorScenes.h"

namespace simcore {
namespace {

using testing::HasSubstr;

constexpr int kBefore = 130, kAfter = 320;

/// Commands all actuators by the number of the step only.
void commandSome(Simulation& simulation) {
  const auto step = static_cast<double>(simulation.steps());
  for (const Port& port : simulation.ports()) {
    if (!port.isActuator()) continue;
    const std::size_t size = port.info.shape.empty() ? 1 : static_cast<std::size_t>(port.info.shape[0]);
    std::vector<double> values(size);
    for (std::size_t i = 0; i < size; ++i)
      values[i] = 0.4 * std::sin(0.02 * step + static_cast<double>(i) + static_cast<double>(port.index));
    if (port.kind == Port::Kind::kDoor) values[0] = simulation.steps() % 100 < 50 ? 1 : 0;
    ASSERT_TRUE(simulation.write(port.info.path, values)) << port.info.path;
  }
}

/// What can be seen of a simulation: its digest, and everything that can be read.
std::vector<double> viewOf(Simulation& simulation) {
  const std::uint64_t digest = simulation.digest();
  std::vector<double> view{static_cast<double>(digest >> 32U), static_cast<double>(digest & 0xFFFFFFFFU)};
  for (const Port& port : simulation.ports()) {
    if (port.kind == Port::Kind::kCamera) continue;
    const auto values = simulation.read(port.info.path);
    if (values) view.insert(view.end(), values->begin(), values->end());
  }
  return view;
}

void play(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    commandSome(simulation);
    simulation.step();
  }
}

/// Plays on, and compares with what was seen before.
void expectSameFuture(Simulation& simulation, const std::vector<std::vector<double>>& seen) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    ASSERT_EQ(viewOf(simulation), seen[i]) << "step " << i << " after the snapshot";
    commandSome(simulation);
    simulation.step();
  }
}

std::vector<std::vector<double>> future(Simulation& simulation, int steps) {
  std::vector<std::vector<double>> seen;
  for (int i = 0; i < steps; ++i) {
    seen.push_back(viewOf(simulation));
    commandSome(simulation);
    simulation.step();
  }
  return seen;
}

using Maker = std::function<std::unique_ptr<Simulation>()>;

/// Takes a snapshot in the middle, and returns to it: in the same simulation, in another one that was never
/// stepped, in one that has gone another way, and from the bytes of a file.
void expectToGoOn(const Maker& make, const std::function<void(Simulation&)>& disturb = {}) {
  const auto simulation = make();
  ASSERT_TRUE(simulation);
  play(*simulation, kBefore);
  if (disturb) disturb(*simulation);
  const Snapshot snapshot = simulation->snapshot();
  const auto seen = future(*simulation, kAfter);
  ASSERT_TRUE(simulation->restore(snapshot));
  expectSameFuture(*simulation, seen);
  const auto fresh = make();
  ASSERT_TRUE(fresh->restore(snapshot));
  expectSameFuture(*fresh, seen);
  const auto other = make();
  other->reset(77);
  play(*other, 40);
  const auto decoded = Snapshot::decode(snapshot.encode(), "a file");
  ASSERT_TRUE(decoded);
  const auto restored = other->restore(*decoded);
  ASSERT_TRUE(restored) << restored.error().text;
  expectSameFuture(*other, seen);
}

Maker scene(const std::string& file, SimulationOptions options = {}, int robots = 0) {
  return [=] {
    RobotsToAdd added;
    added.count = robots;
    auto loaded = Scene::load(robotlink::resource("scenes/" + file), added);
    EXPECT_TRUE(loaded) << file;
    return loaded ? std::move(Simulation::create(*loaded, options).value()) : nullptr;
  };
}

TEST(Snapshots, theSoccerFieldGoesOn) {
  expectToGoOn(scene("field2002.sdf"), [](Simulation& simulation) {
    // Bodies that were put elsewhere by hand, so that ODE has them in another order.
    ASSERT_TRUE(simulation.placeModel("ball", {0.3, 0.5, 0}));
    for (int i = 0; i < 3; ++i) simulation.step();
    ASSERT_TRUE(simulation.placeModel("red1", {-0.9, -0.6, 1}));
  });
}

TEST(Snapshots, pioneersGoOnWithForcesAndByTheirOdometry) {
  expectToGoOn(scene("pioneer.sdf"));
  expectToGoOn(scene("pioneer.sdf", {.kinematic = true}));
}

TEST(Snapshots, aMapWithItsGridGoesOn) {
  expectToGoOn(scene("house.map", {}, 3));
  expectToGoOn(scene("house.map", {.seed = 5, .noise = true, .kinematic = true}, 2));
}

/// A cart with each kind of sensor, and models with each kind of joint, motor and guided motion around it.
std::unique_ptr<Simulation> everything() {
  const std::string inertia =
      "<inertial><mass>0.3</mass><inertia><ixx>0.002</ixx><iyy>0.002</iyy><izz>0.002</izz></inertia></"
      "inertial>";
  const auto link = [&](const std::string& name, const std::string& pose) {
    return "<link name='" + name + "'><pose>" + pose + "</pose>" + inertia +
           "<collision "
           "name='c'><geometry><sphere><radius>0.04</radius></sphere></geometry></collision></link>";
  };
  const auto axis = [](const char* which, const char* xyz, const char* limits = "-1</lower><upper>1") {
    return std::string("<") + which + "><xyz>" + xyz + "</xyz><limit><lower>" + limits +
           "</upper><effort>4</effort><velocity>3</velocity></limit><dynamics><damping>0.01</damping>"
           "<friction>0.002</friction></dynamics></" +
           which + ">";
  };
  const auto joint = [](const std::string& name, const std::string& type, const std::string& parent,
                        const std::string& child, const std::string& rest) {
    return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" + child +
           "</child>" + rest + "</joint>";
  };
  const std::string noise =
      "<noise type='gaussian'><mean>0</mean><stddev>0.02</stddev><bias_mean>0.01</bias_mean>"
      "<bias_stddev>0.01</bias_stddev><dynamic_bias_stddev>0.02</dynamic_bias_stddev>"
      "<dynamic_bias_correlation_time>2</dynamic_bias_correlation_time></noise>";
  const auto three = [&](const std::string& element) {
    return "<" + element + "><x>" + noise + "</x><y>" + noise + "</y><z>" + noise + "</z></" + element + ">";
  };
  const std::string scan =
      "<scan><horizontal><samples>9</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></"
      "scan>"
      "<range><min>0.05</min><max>5</max></range>";
  const auto custom = [](const std::string& name, const std::string& contents) {
    return "<sensor name='" + name + "' type='custom'><pose>0.1 0 0.1 0 0 0</pose>" + contents + "</sensor>";
  };
  const std::string sensors =
      "<sensor name='imu' type='imu'><imu>" + three("angular_velocity") + three("linear_acceleration") +
      "</imu></sensor><sensor name='compass' type='magnetometer'/><sensor name='gps' type='navsat'/>"
      "<sensor name='height' type='altimeter'/><sensor name='eye' type='lidar'><pose>0 0 0.3 0 0 "
      "0</pose><lidar>" +
      scan + noise + "</lidar></sensor>" + custom("odometry", "<robotcontrol:odometry/>") +
      custom("whisker", "<robotcontrol:whisker>0.4</robotcontrol:whisker>") +
      custom("foot", "<robotcontrol:switch/>");
  const std::string parts =
      link("a", "0 0 0.3 0 0 0") + link("b", "0.2 0 0.3 0 0 0") + link("c", "-0.2 0 0.3 0 0 0") +
      link("d", "0 0.2 0.3 0 0 0") + link("e", "0 -0.2 0.3 0 0 0") +
      joint("turn", "revolute", "base", "a",
            axis("axis", "0 1 0") +
                "<robotcontrol:servo><robotcontrol:p>3</robotcontrol:p><robotcontrol:i>2"
                "</robotcontrol:i><robotcontrol:delay>0.05</robotcontrol:delay>"
                "</robotcontrol:servo><robotcontrol:speed_sensor/><robotcontrol:load_sensor/>") +
      joint("slide", "prismatic", "base", "b",
            axis("axis", "0 0 1", "-0.1</lower><upper>0.2") + "<robotcontrol:servo/>") +
      joint("free", "ball", "base", "c", "") +
      joint("cardan", "universal", "base", "d", axis("axis", "1 0 0") + axis("axis2", "0 1 0")) +
      joint("swing", "revolute", "base", "e", axis("axis", "1 0 0"));
  const auto guided = [&](const std::string& name, const std::string& kind, const std::string& pose) {
    return "<model name='" + name + "'><pose>" + pose + "</pose>" + link("body", "0 0 0.05 0 0 0") +
           "<robotcontrol:guided kind='" + kind + "'/></model>";
  };
  const std::string gate =
      "<model name='gate'><pose>0 3 0 0 0 0</pose>" + link("frame", "0 0 1 0 0 0") +
      joint("ground", "fixed", "world", "frame", "") + link("leaf", "0 1 1 0 0 0") +
      joint("rail", "prismatic", "frame", "leaf",
            "<axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>1.2</upper><effort>200</effort><velocity>2"
            "</velocity></limit></axis><robotcontrol:servo/><robotcontrol:door><robotcontrol:open>1"
            "</robotcontrol:open><robotcontrol:seconds>0.2</robotcontrol:seconds></robotcontrol:door>") +
      "</model>";
  auto simulation =
      cartWith(sensors, parts,
               gate + guided("fly", "free", "1 1 0.5 0 0 0") + guided("omni", "omni", "1 -1 0 0 0 0") +
                   "<model name='block'><pose>0.35 0 0.06 0 0 0</pose>" + link("l", "0 0 0 0 0 0") +
                   "</model>" + solidAt("wall", "1.5 0 0.25 0 0 0", "0.2 2 0.5"),
               {.seed = 3});
  if (!simulation) return nullptr;
  // Delay, rate and lost samples of several kinds.
  EXPECT_TRUE(simulation->setSensorErrors(
      "cart/eye", {{{.stddev = 0.01, .driftStddev = 0.02, .driftTime = 1}}, 0.06, 20, 0.2}));
  EXPECT_TRUE(simulation->setSensorErrors("cart/gps", {{{.stddev = 0.1}}, 0.1, 30, 0.1}));
  return simulation;
}

TEST(Snapshots, eachKindOfSensorJointAndActuatorGoesOn) {
  expectToGoOn(&everything, [](Simulation& simulation) {
    ASSERT_TRUE(simulation.pin("cart/link:c", true));
    ASSERT_TRUE(simulation.drag("block", {0, 0, 0.02}, {0.4, 0.3, 0.3}));
    ASSERT_TRUE(simulation.push("cart", {3, 1, 0}, {0.1, 0, 0}, 0.5));
    simulation.step();
  });
}

TEST(Snapshots, whetherForcesAreReadChangesNothing) {
  const auto read = everything(), unread = everything();
  ASSERT_TRUE(read && unread);
  read->readForces(true);
  play(*read, 100);
  play(*unread, 100);
  EXPECT_EQ(read->digest(), unread->digest());
}

TEST(Snapshots, takingOneDisturbsNothing) {
  const auto watched = everything(), alone = everything();
  ASSERT_TRUE(watched && alone);
  for (int i = 0; i < 100; ++i) {
    (void)watched->snapshot();
    play(*watched, 1);
    play(*alone, 1);
  }
  EXPECT_EQ(viewOf(*watched), viewOf(*alone));
}

TEST(Snapshots, oneGoesBackToAnyStepOfThePast) {
  const auto simulation = everything();
  ASSERT_TRUE(simulation);
  simulation->keepForRewind(std::size_t{64} << 20U);
  std::vector<std::vector<double>> seen;
  for (int i = 0; i < 600; ++i) {
    seen.push_back(viewOf(*simulation));
    if (i == 300) {
      ASSERT_TRUE(simulation->throwModel("block", {0, 1, 2}, {3, 0, 0}));
    }
    if (i == 310) {
      ASSERT_TRUE(simulation->placeModel("omni", {2.5, -1, 0.5}));
    }
    if (i == 320) {
      ASSERT_TRUE(simulation->setSensorErrors("cart/foot", {{{.stddev = 0.2}}}));
    }
    play(*simulation, 1);
  }
  EXPECT_EQ(simulation->rewindableFrom(), 0U);
  for (const std::size_t step : {590U, 513U, 500U, 333U, 301U, 250U, 7U, 0U}) {
    ASSERT_TRUE(simulation->rewindTo(step));
    EXPECT_EQ(simulation->steps(), step);
    EXPECT_EQ(viewOf(*simulation), seen[step]) << step;
  }
  // And forwards again from there.
  ASSERT_FALSE(simulation->rewindTo(1));
  expectSameFuture(*simulation, {seen.begin(), seen.begin() + 250});
}

TEST(Snapshots, thePastIsBoundedByItsBytes) {
  const auto simulation = everything();
  ASSERT_TRUE(simulation);
  simulation->keepForRewind(200'000);
  play(*simulation, 3000);
  EXPECT_GT(simulation->rewindableFrom(), 0U);
  ASSERT_TRUE(simulation->rewindTo(simulation->rewindableFrom()));
  simulation->keepForRewind(0);
  EXPECT_FALSE(simulation->rewindTo(simulation->steps()));
}

TEST(Snapshots, thoseOfOtherScenesAndVersionsAreRefusedWithBothNames) {
  const auto soccer = scene("field2002.sdf")();
  const auto pioneer = scene("pioneer.sdf")();
  const std::uint64_t digest = pioneer->digest();
  const auto refused = pioneer->restore(soccer->snapshot());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("field2002.sdf"));
  EXPECT_THAT(refused.error().text, HasSubstr("pioneer.sdf"));
  EXPECT_EQ(pioneer->digest(), digest);
  auto bytes = soccer->snapshot().encode();
  bytes[8] = 9;
  const auto version = Snapshot::decode(bytes, "old.snapshot");
  ASSERT_FALSE(version);
  EXPECT_THAT(version.error().text, HasSubstr("version 9"));
  EXPECT_THAT(version.error().text, HasSubstr("version " + std::to_string(Snapshot::kVersion)));
}

TEST(Snapshots, damagedFilesAreRefusedAndChangeNothing) {
  const auto simulation = everything();
  ASSERT_TRUE(simulation);
  play(*simulation, 20);
  const auto seen = viewOf(*simulation);
  const Snapshot snapshot = simulation->snapshot();
  const auto bytes = snapshot.encode();
  EXPECT_FALSE(Snapshot::decode({}, "empty"));
  EXPECT_FALSE(Snapshot::decode(std::span(bytes).first(bytes.size() - 1), "short"));
  auto flipped = bytes;
  flipped[flipped.size() / 2] ^= 4U;
  EXPECT_FALSE(Snapshot::decode(flipped, "flipped"));
  // What a checksum does not find: states that were made up.
  for (std::size_t size = 0; size < snapshot.state.size(); size += 97) {
    Snapshot cut = snapshot;
    cut.isForeign = true;
    cut.state.resize(size);
    EXPECT_FALSE(simulation->restore(cut)) << size;
  }
  Snapshot numbers = snapshot;
  numbers.isForeign = true;
  std::fill(numbers.state.begin() + 17, numbers.state.begin() + 200, std::uint8_t{0xFF});
  EXPECT_FALSE(simulation->restore(numbers)) << "not a number";
  EXPECT_EQ(viewOf(*simulation), seen);
}

TEST(Snapshots, filesAreWrittenAndRead) {
  const SceneFolder folder;
  const auto simulation = everything();
  ASSERT_TRUE(simulation);
  Snapshot snapshot = simulation->snapshot();
  snapshot.parts["more"] = {1, 2, 3};
  const auto file = folder.write("a.snapshot", "");
  ASSERT_TRUE(snapshot.write(file));
  const auto read = Snapshot::read(file);
  ASSERT_TRUE(read) << read.error().text;
  EXPECT_EQ(read->parts, snapshot.parts);
  EXPECT_EQ(read->state, snapshot.state);
  EXPECT_FALSE(Snapshot::read(folder.write("b.snapshot", "something else")));
}

}  // namespace
}  // namespace simcore
