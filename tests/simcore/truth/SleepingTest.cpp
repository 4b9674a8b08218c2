// SPDX-License-Identifier: GPL-3.0-or-later
// What rests is not computed, and wakes when something happens to it; links that are fixed to each other are
// one body.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "robotlink/base/threads/ThreadPool.h"
#include "simcore/physics/shapes/LumpedLink.h"
#include "tests/simcore/truth/Bodies.h"

namespace simcore::truth {
namespace {

constexpr double kEdge = 0.1, kMass = 1;

std::string cubeAt(const std::string& name, double x, double z) {
  const Vector3 size = Vector3::Constant(kEdge);
  return model(name, std::to_string(x) + " 0 " + std::to_string(z) + " 0 0 0",
               inertial(kMass, momentsOfBox(kMass, size)) + solid(box(size)));
}

/// Boxes on each other; their names begin with `name`.
std::string stackAt(const std::string& name, double x, int boxes) {
  std::string stack;
  for (int i = 0; i < boxes; ++i) stack += cubeAt(name + std::to_string(i), x, kEdge * (0.5 + i));
  return stack;
}

int sleepersOf(const Physics& physics, int models) {
  int count = 0;
  for (int i = 0; i < models; ++i) count += physics.isAsleep(i) ? 1 : 0;
  return count;
}

TEST(Sleeping, aStackFallsAsleepAndKeepsWhatItTouches) {
  Bodies bodies(ground() + stackAt("box", 0, 3));
  Physics& physics = bodies.physics();
  bodies.run(4);
  ASSERT_EQ(sleepersOf(physics, 4), 3);
  const std::uint64_t digest = physics.digest();
  physics.readContacts(true);
  bodies.run(1);
  EXPECT_EQ(physics.digest(), digest);
  EXPECT_TRUE(physics.touched(std::size_t{0}, 0));
  EXPECT_TRUE(physics.touched(1, 2));
  EXPECT_FALSE(physics.touched(1, 3));
  EXPECT_TRUE(physics.touchedObstacle(3));
  // The forces were kept when it fell asleep, though nobody read them.
  Vector3 onLowest = Vector3::Zero();
  for (const Physics::Contact& contact : physics.contacts()) {
    if (contact.firstModel == 0 || contact.secondModel == 0)
      onLowest += contact.firstModel == 0 ? Vector3(-contact.force) : contact.force;
  }
  EXPECT_NEAR(onLowest.z(), 3 * kMass * 9.81, 1.5);
}

TEST(Sleeping, aForceWakesTheWholeStack) {
  Bodies bodies(ground() + stackAt("box", 0, 3) + cubeAt("other", 2, kEdge / 2));
  bodies.run(4);
  Physics& physics = bodies.physics();
  ASSERT_EQ(sleepersOf(physics, 5), 4);
  physics.addForce(1, {200, 0, 0}, bodies.motion("box1").position);
  EXPECT_EQ(sleepersOf(physics, 5), 1);
  bodies.step();
  EXPECT_GT(bodies.motion("box1").velocity.x(), 0.1);
  // Nothing falls through the ground on its way.
  EXPECT_NEAR(bodies.motion("box0").position.z(), kEdge / 2, 1e-3);
}

TEST(Sleeping, whatIsHitWakes) {
  Bodies bodies(
      ground() + stackAt("box", 0, 3) +
      model("shot", "-1 0 0.15 0 0 0", inertial(2, momentsOfSphere(2, 0.05)) + solid(sphere(0.05))));
  bodies.run(1.5);
  ASSERT_EQ(sleepersOf(bodies.physics(), 5), 3);
  bodies.physics().moveModel(4, Pose3(Eigen::Translation3d(0, 0, 0.15 - bodies.motion("shot").position.z())));
  bodies.throwModel("shot", {6, 0, 0});
  bodies.run(0.4);
  EXPECT_EQ(sleepersOf(bodies.physics(), 5), 0);
  EXPECT_GT((bodies.motion("box1").position - Vector3(0, 0, 0.15)).norm(), 0.05);
}

TEST(Sleeping, whatStandsOnSomethingThatIsTakenAwayFalls) {
  Bodies bodies(ground() + stackAt("box", 0, 2));
  bodies.run(4);
  ASSERT_EQ(sleepersOf(bodies.physics(), 3), 2);
  bodies.physics().moveModel(1, Pose3(Eigen::Translation3d(1, 0, 0)));
  bodies.run(1);
  EXPECT_NEAR(bodies.motion("box1").position.z(), kEdge / 2, 1e-3);
}

TEST(Sleeping, whatIsJointedOrRollsOrSlidesStaysAwake) {
  Bodies bodies(ground() +
                model("ball", "0 0 0.05 0 0 0", inertial(1, momentsOfSphere(1, 0.05)) + solid(sphere(0.05))) +
                model("arm", "3 0 1 0 0 0", inertial(1, Vector3::Constant(0.01), {0, 0, -0.1}),
                      jointToWorld("revolute", "<axis><xyz>0 1 0</xyz></axis>")) +
                model("slider", "5 0 0.05 0 0 0",
                      inertial(1, momentsOfBox(1, Vector3::Constant(kEdge))) +
                          solid(box(Vector3::Constant(kEdge)), 0)));
  bodies.throwModel("slider", {0.002, 0, 0});
  bodies.run(2);
  EXPECT_EQ(sleepersOf(bodies.physics(), 4), 0);
}

/// A table whose four legs servos hold, and how far these have turned.
struct HeldTable {
  std::unique_ptr<Simulation> simulation;
  explicit HeldTable(SimulationOptions options = {.seed = 1, .noise = false})
      : simulation(simulationOf(ground() + inWorld(), options)) {}
  static std::string inWorld() {
    const Vector3 top(0.3, 0.2, 0.05);
    std::string legs;
    for (int i = 0; i < 4; ++i) {
      const std::string name = "leg" + std::to_string(i);
      legs += "<link name='" + name + "'><pose>" + (i < 2 ? "0.12" : "-0.12") + " " +
              (i % 2 == 0 ? "0.08" : "-0.08") + " -0.075 0 0 0</pose>" +
              inertial(0.1, Vector3::Constant(2e-4)) + "<collision name='foot'><pose>0 0 -0.05 0 0 0</pose>" +
              sphere(0.02) + "</collision></link><joint name='hip" + std::to_string(i) +
              "' type='revolute'><pose>0 0 0.05 0 0 0</pose><parent>body</parent><child>" + name +
              "</child><axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>1</upper><effort>4</effort>"
              "<velocity>5</velocity></limit></axis><robotcontrol:servo/></joint>";
    }
    return model("table", "0 0 0.146 0 0 0", inertial(1.5, momentsOfBox(1.5, top)) + solid(box(top)), legs);
  }
  void request(double angle) const {
    for (int i = 0; i < 4; ++i)
      ASSERT_TRUE(simulation->write("table/hip" + std::to_string(i) + "/request", std::vector{angle}));
  }
  /// Whether nothing moves in a step, to the last bit.
  bool isAtRest() const {
    const std::vector<Pose3> before(simulation->bodyPoses().begin(), simulation->bodyPoses().end());
    simulation->step();
    const auto after = simulation->bodyPoses();
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i].matrix() != after[i].matrix()) return false;
    return true;
  }
};

TEST(Sleeping, whatServosHoldSleepsUntilTheyAreAskedForSomethingElse) {
  const HeldTable table;
  table.request(0.1);
  advance(*table.simulation, 3);
  ASSERT_TRUE(table.isAtRest());
  const double load = table.simulation->servoTorque(0);
  table.request(0.1);
  advance(*table.simulation, 1);
  EXPECT_TRUE(table.isAtRest()) << "they are asked for the same";
  EXPECT_EQ(table.simulation->servoTorque(0), load) << "they hold it as before";
  table.request(0.3);
  advance(*table.simulation, 1);
  EXPECT_NEAR(read(*table.simulation, "table/hip0/position"), 0.3, 0.02);
  // Servos that go limp let it sink.
  const double height = table.simulation->modelPose("table")->translation().z();
  for (std::size_t i = 0; i < 4; ++i) table.simulation->setTorqueLimit(i, 0);
  ASSERT_TRUE(table.simulation->push("table", {0.5, 0, 0}, {0, 0, 0}, 0.2));
  advance(*table.simulation, 2);
  EXPECT_LT(table.simulation->modelPose("table")->translation().z(), height - 0.01);
}

TEST(Sleeping, aSlowlyMovingServoIsFollowed) {
  const HeldTable table;
  advance(*table.simulation, 2);
  for (int i = 0; i <= 2500; ++i) {
    table.request(0.02 * i / 2500);
    table.simulation->step();
    EXPECT_NEAR(read(*table.simulation, "table/hip0/position"), 0.02 * i / 2500, 0.003) << i;
  }
}

TEST(Sleeping, aRobotThatSleepsGoesOnFromASnapshot) {
  const HeldTable table, other;
  table.request(0.1);
  advance(*table.simulation, 3);
  ASSERT_TRUE(table.isAtRest());
  ASSERT_TRUE(other.simulation->restore(table.simulation->snapshot()));
  for (int i = 0; i < 400; ++i) {
    if (i == 100) {
      table.request(0.15);
      other.request(0.15);
    }
    table.simulation->step();
    other.simulation->step();
    ASSERT_EQ(table.simulation->digest(), other.simulation->digest()) << i;
    ASSERT_EQ(table.simulation->servoTorque(2), other.simulation->servoTorque(2)) << i;
  }
  EXPECT_EQ(table.simulation->snapshot().state, other.simulation->snapshot().state);
}

TEST(Sleeping, aSceneChoosesThatNothingSleeps) {
  Bodies bodies("<robotcontrol:sleeping>false</robotcontrol:sleeping>" + ground() + stackAt("box", 0, 1));
  bodies.run(4);
  EXPECT_EQ(sleepersOf(bodies.physics(), 2), 0);
}

std::string manyStacks() {
  std::string stacks = ground();
  for (int i = 0; i < 12; ++i) stacks += stackAt("s" + std::to_string(i) + "_", 0.5 * i, 1 + i % 4);
  return stacks;
}

/// Runs until most sleep, throws what is left over onto one stack, and goes on.
std::vector<std::uint64_t> digestsOfRun(Simulation& simulation, int steps) {
  std::vector<std::uint64_t> digests;
  for (int i = 0; i < steps; ++i) {
    if (i == 600) {
      EXPECT_TRUE(simulation.throwModel("s0_0", {2, 0, 0.5}, {0, 3, 0}));
    }
    simulation.step();
    digests.push_back(simulation.digest());
  }
  return digests;
}

TEST(Sleeping, anyNumberOfThreadsGivesTheSameBytes) {
  std::vector<std::vector<std::uint64_t>> all;
  for (const int threads : {1, 2, 3}) {
    const auto simulation =
        simulationOf(manyStacks(), {.seed = 2, .pool = std::make_shared<robotlink::ThreadPool>(threads)});
    all.push_back(digestsOfRun(*simulation, 1200));
  }
  EXPECT_EQ(all[0], all[1]);
  EXPECT_EQ(all[0], all[2]);
}

TEST(Sleeping, whatSleepsGoesOnFromASnapshot) {
  const auto scene = sceneOf(manyStacks());
  auto simulation = std::move(Simulation::create(scene, {.seed = 2}).value());
  auto other = std::move(Simulation::create(scene, {.seed = 2}).value());
  // Some have just begun to rest.
  for (const int at : {90, 130, 500}) {
    while (simulation->steps() < static_cast<std::uint64_t>(at)) simulation->step();
    ASSERT_TRUE(other->restore(simulation->snapshot()));
    for (int i = 0; i < 200; ++i) {
      simulation->step();
      other->step();
      ASSERT_EQ(simulation->digest(), other->digest()) << at << " + " << i;
    }
    ASSERT_EQ(simulation->snapshot().state, other->snapshot().state);
  }
  ASSERT_TRUE(simulation->throwModel("s0_0", {2, 0, 0.5}, {0, 3, 0}));
  ASSERT_TRUE(other->throwModel("s0_0", {2, 0, 0.5}, {0, 3, 0}));
  for (int i = 0; i < 300; ++i) {
    simulation->step();
    other->step();
    ASSERT_EQ(simulation->digest(), other->digest()) << i;
  }
}

std::string fixedTo(const std::string& parent, const std::string& child, const std::string& pose,
                    const std::string& inLink) {
  return "<link name='" + child + "'><pose>" + pose + "</pose>" + inLink + "</link><joint name='weld_" +
         child + "' type='fixed'><parent>" + parent + "</parent><child>" + child + "</child></joint>";
}

TEST(FixedLinks, areOneBodyWhoseSolidsAreEachTheirLinks) {
  // A dumbbell that lies on its two balls.
  const std::string ball = inertial(1, momentsOfSphere(1, 0.1)) + solid(sphere(0.1));
  Bodies bodies(ground() +
                model("bell", "0 0 0.1 0 0 0", ball, fixedTo("body", "end", "0.5 0 0 0 0 1", ball)));
  Physics& physics = bodies.physics();
  ASSERT_EQ(physics.bodyCount(), 2U);
  EXPECT_EQ(physics.carrierOf(1), 0U);
  EXPECT_DOUBLE_EQ(physics.massOf(1), 2);
  bodies.run(1);
  EXPECT_TRUE(physics.touched(std::size_t{0}, 0));
  EXPECT_TRUE(physics.touched(std::size_t{1}, 0));
  EXPECT_NEAR((physics.linkInWorld(1).translation() - Vector3(0.5, 0, 0.1)).norm(), 0, 1e-4);
  EXPECT_NEAR(bodies.motion("bell").position.x(), 0.25, 1e-4);
  const Pose3 apart = physics.linkInWorld(0).inverse() * physics.linkInWorld(1);
  bodies.throwModel("bell", {1, 0, 3}, {2, 1, 5});
  bodies.run(2);
  const Pose3 still = physics.linkInWorld(0).inverse() * physics.linkInWorld(1);
  EXPECT_LT((apart.matrix() - still.matrix()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(FixedLinks, stayApartIfTheyMoveDifferentlyOrAnotherJointConnectsThem) {
  const std::string mass = inertial(1, Vector3::Constant(0.01));
  const auto partsOf = [&](const std::string& inModel) {
    const auto scene = sceneOf(model("m", "0 0 1 0 0 0", mass, inModel));
    return rigidParts(*scene->contents().world.models[0].type);
  };
  const std::string chain =
      fixedTo("body", "a", "0.1 0 0 0 0 0", mass) + fixedTo("a", "b", "0.2 0 0 0 0 0", mass);
  EXPECT_EQ(partsOf(chain), (std::vector{0, 0, 0}));
  EXPECT_EQ(partsOf(fixedTo("body", "a", "0.1 0 0 0 0 0",
                            mass + "<velocity_decay><linear>1</linear></velocity_decay>")),
            (std::vector{0, 1}));
  EXPECT_EQ(partsOf(fixedTo("body", "a", "0.1 0 0 0 0 0", mass + "<gravity>false</gravity>")),
            (std::vector{0, 1}));
  EXPECT_EQ(partsOf(chain + "<joint name='twice' type='ball'><parent>body</parent><child>b</child></joint>"),
            (std::vector{0, 1, 2}));
}

}  // namespace
}  // namespace simcore::truth
