// SPDX-License-Identifier: GPL-3.0-or-later
// Joints: their stops and slides, what is joined to one body, and models in models.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "simcore/world/ModelGeometry.h"
#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

using robotlink::kPi;

std::string axis(const std::string& xyz, const std::string& limits, const std::string& name = "axis") {
  return "<" + name + "><xyz>" + xyz + "</xyz><limit>" + limits + "</limit></" + name + ">";
}

constexpr const char* kLimits = "<lower>-0.5</lower><upper>0.7</upper>";

/// A rod of 1 kg whose center is 0.3 m beside its joint.
std::string rodBeside(const std::string& type, const std::string& joint, const std::string& more = "") {
  return model("rod", "0 0 2 0 0 0", inertial(1, Vector3::Constant(0.005), {0.3, 0, 0}),
               jointToWorld(type, joint, more));
}

TEST(JointTruth, stopsHoldWhatFallsOnThem) {
  // About y, the rod falls to +0.7; about -y, to -0.5.
  for (const auto& [sign, stop] : {std::pair{1, 0.7}, std::pair{-1, -0.5}}) {
    const auto simulation = simulationOf(rodBeside("revolute", axis(fmt::format("0 {} 0", sign), kLimits)));
    double beyond = 0;
    for (int i = 0; i < 1000; ++i) {
      simulation->step();
      beyond = largerOf(beyond, std::abs(read(*simulation, "rod/joint/position")) - std::abs(stop));
    }
    compare({"stop of a revolute joint, overshoot at the impact", "less than a step's turn", 0, 0.03, "rad"},
            largerOf(0.0, beyond));
    compare({"stop of a revolute joint, angle at rest", "the limit", stop, 0.002, "rad"},
            read(*simulation, "rod/joint/position"));
  }
}

TEST(JointTruth, stopsOfASlideHoldWhatFallsOnThem) {
  const auto simulation = simulationOf(rodBeside("prismatic", axis("0 0 1", kLimits)));
  double beyond = 0;
  for (int i = 0; i < 1000; ++i) {
    simulation->step();
    beyond = largerOf(beyond, -0.5 - read(*simulation, "rod/joint/position"));
  }
  compare({"stop of a slide, overshoot at the impact", "less than a step's way", 0, 0.015, "m"},
          largerOf(0.0, beyond));
  compare({"stop of a slide, place at rest", "the limit", -0.5, 1e-3, "m"},
          read(*simulation, "rod/joint/position"));
}

TEST(JointTruth, aStrongMotorDoesNotPushThroughAStop) {
  const auto simulation = simulationOf(rodBeside(
      "revolute", axis("0 0 1", std::string(kLimits) + "<effort>50</effort><velocity>20</velocity>"),
      "<robotcontrol:servo><robotcontrol:control>torque</robotcontrol:control></robotcontrol:servo>"));
  simulation->requestAngle(0, 50);
  double most = 0, mean = 0;
  constexpr int kSteps = 500, kLast = 100;
  for (int i = 0; i < kSteps; ++i) {
    simulation->step();
    const double angle = read(*simulation, "rod/joint/position");
    most = largerOf(most, angle);
    // Where it is pushed against the stop, it trembles.
    if (i >= kSteps - kLast) mean += angle / kLast;
  }
  compare(
      {"stop against a motor of 50 N m, overshoot", "less than a step's turn", 0, 20 * kStepSeconds, "rad"},
      largerOf(0.0, most - 0.7));
  compare({"stop against a motor of 50 N m, mean angle of 0.4 s", "the limit", 0.7, 0.01, "rad"}, mean);
}

TEST(JointTruth, bothAxesOfAUniversalJointHaveStops) {
  // The first axis is x of the world, the second y of the rod; the rod hangs from it and is swung about both.
  const std::string joint = axis("1 0 0", "<lower>-0.2</lower><upper>0.3</upper>") +
                            axis("0 1 0", "<lower>-0.4</lower><upper>0.25</upper>", "axis2");
  const auto swung = [&](const Vector3& turning) {
    Bodies bodies(model("rod", "0 0 2 0 0 0", inertial(1, Vector3::Constant(0.005), {0, 0, -0.3}),
                        jointToWorld("universal", joint)));
    bodies.throwModel("rod", Vector3::Zero(), Vector3::Zero());
    const Vector3 arm(0, 0, -0.3);
    bodies.throwModel("rod", turning.cross(arm), turning);
    Vector3 most = Vector3::Zero(), least = Vector3::Zero();
    for (int i = 0; i < 500; ++i) {
      bodies.step();
      const Eigen::Matrix3d rotation = bodies.motion("rod").rotation.toRotationMatrix();
      // Turned by a about x and then by b about its own y, the rod points along -z of that.
      const Vector3 up = rotation.col(2);
      const Vector3 angles(std::atan2(-up.y(), up.z()), std::asin(std::clamp(up.x(), -1.0, 1.0)), 0);
      most = most.cwiseMax(angles);
      least = least.cwiseMin(angles);
    }
    return std::pair{least, most};
  };
  const auto [least, most] = swung({5, 0, 0});
  compare({"stop of a universal joint, first axis", "the limit", 0.3, 0.02, "rad"}, most.x());
  EXPECT_GT(least.x(), -0.22);
  EXPECT_LT(std::max(-least.y(), most.y()), 0.02) << "the other axis does not turn";
  const auto [leastOther, mostOther] = swung({0, 5, 0});
  compare({"stop of a universal joint, second axis", "the limit", 0.25, 0.02, "rad"}, mostOther.y());
  EXPECT_GT(leastOther.y(), -0.42);
  EXPECT_LT(std::max(-leastOther.x(), mostOther.x()), 0.02);
}

TEST(JointTruth, continuousJointsTurnOnAndBallJointsTurnFreely) {
  Bodies wheel("<gravity>0 0 0</gravity>" +
               model("rod", "0 0 2 0 0 0", inertial(1, Vector3::Constant(0.01)),
                     jointToWorld("continuous", "<axis><xyz>0 0 1</xyz></axis>")));
  wheel.throwModel("rod", Vector3::Zero(), {0, 0, 3});
  wheel.run(10);
  compare({"continuous joint, speed after five turns", "constant", 3, 1e-4, "rad/s"},
          wheel.motion("rod").angularVelocity.z());
  Bodies ball("<gravity>0 0 0</gravity>" +
              model("rod", "0 0 2 0 0 0", inertial(1, Vector3::Constant(0.01)), jointToWorld("ball", "")));
  ball.throwModel("rod", Vector3::Zero(), {1, 2, 3});
  ball.run(10);
  compare({"ball joint, turning of a sphere after 10 s", "constant", 0, 1e-3, "rad/s"},
          (ball.motion("rod").angularVelocity - Vector3(1, 2, 3)).norm());
}

TEST(JointTruth, aSlideFallsAlongItsAxis) {
  const double slope = 0.5;
  Bodies bodies(rodBeside("prismatic", axis(numbers({std::cos(slope), 0, -std::sin(slope)}),
                                            "<lower>-10</lower><upper>10</upper>")));
  bodies.run(1);
  const auto rod = bodies.motion("rod");
  compare({"slide under gravity, speed after 1 s", "g sin a t", kGravity * std::sin(slope), 1e-3, "m/s"},
          rod.velocity.norm());
  compare({"slide under gravity, turning", "0", 0, 1e-3, "rad/s"}, rod.angularVelocity.norm());
  const Vector3 way = rod.position - Vector3(0.3, 0, 2);
  compare({"slide under gravity, way across its axis", "0", 0, 1e-3, "m"},
          std::abs(way.x() * std::sin(slope) + way.z() * std::cos(slope)));
}

TEST(JointTruth, dampingAndFrictionOfAJointBrakeIt) {
  const auto spun = [](const std::string& dynamics) {
    Bodies bodies("<gravity>0 0 0</gravity>" +
                  model("rod", "0 0 2 0 0 0", inertial(1, Vector3::Constant(0.01)),
                        jointToWorld("continuous",
                                     "<axis><xyz>0 0 1</xyz><dynamics>" + dynamics + "</dynamics></axis>")));
    bodies.throwModel("rod", Vector3::Zero(), {0, 0, 3});
    bodies.run(1);
    return bodies.motion("rod").angularVelocity.z();
  };
  compare({"damping of a joint, speed after 1 s", "w exp(-d t / I)", 3 * std::exp(-1.0), 0.01, "rad/s"},
          spun("<damping>0.01</damping>"));
  compare({"friction of a joint, speed after 1 s", "w - f t / I", 3 - 2.0, 0.01, "rad/s"},
          spun("<friction>0.02</friction>"));
}

TEST(JointTruth, whatIsFixedSwingsAsOneBody) {
  // A rod with a ball at its end, as two links that are fixed to each other.
  const double rodMass = 0.5, ballMass = 1.5, length = 0.8, radius = 0.1;
  const std::string ball =
      "<link name='ball'><pose>0 0 -0.8 0 0 0</pose>" +
      inertial(ballMass, momentsOfSphere(ballMass, radius)) +
      "</link><joint name='weld' type='fixed'><parent>body</parent><child>ball</child></joint>";
  Bodies bodies(model("pendulum", "0 0 2 0 0.1 0",
                      inertial(rodMass, momentsOfCylinder(rodMass, 0.01, length), {0, 0, -length / 2}),
                      ball + jointToWorld("revolute", "<axis><xyz>0 1 0</xyz></axis>")));
  const double inertia = momentsOfCylinder(rodMass, 0.01, length).x() + rodMass * length * length / 4 +
                         momentsOfSphere(ballMass, radius).x() + ballMass * length * length;
  const double lever = rodMass * length / 2 + ballMass * length;
  const double expected = 2 * kPi * std::sqrt(inertia / (kGravity * lever)) * (1 + 0.01 / 16);
  double before = -1, first = 0, last = 0, gap = 0;
  int passages = 0;
  while (bodies.time() < 20) {
    bodies.step();
    const double x = bodies.motion("pendulum").position.x();
    if (before < 0 && x >= 0 && bodies.time() > 0.1) {
      last = bodies.time() - kStepSeconds * x / (x - before);
      if (passages++ == 0) first = last;
    }
    before = x;
    const Vector3 between =
        bodies.physics().linkInWorld(1).translation() - bodies.physics().linkInWorld(0).translation();
    gap = largerOf(gap, std::abs(between.norm() - length));
  }
  compare({"two fixed links, period as a pendulum", "2 pi sqrt(I / (m g l)), I by the parallel axis theorem",
           expected, 0.005 * expected, "s"},
          (last - first) / (passages - 1));
  compare({"two fixed links, change of their distance", "0", 0, 1e-9, "m"}, gap);
}

TEST(JointTruth, aHangingModelRestsWithItsCenterOfMassBelow) {
  // Two masses at (0, -0.4) and (0.3, -0.2): the center of mass is below the joint after a turn.
  const std::string other =
      "<link name='other'><pose>0.3 0 -0.2 0 0 0</pose>" + inertial(2, Vector3::Constant(0.002)) +
      "</link><joint name='weld' type='fixed'><parent>body</parent><child>other</child></joint>";
  const auto simulation = simulationOf(model(
      "mobile", "0 0 2 0 0 0", inertial(1, Vector3::Constant(0.002), {0, 0, -0.4}),
      other + jointToWorld("revolute",
                           "<axis><xyz>0 1 0</xyz><dynamics><damping>0.8</damping></dynamics></axis>")));
  advance(*simulation, 20);
  const auto bodies = simulation->bodyPoses();
  compare({"two fixed links at rest, change of their places to each other", "0", 0, 1e-9, "m"},
          (bodies[1].inverse() * bodies[2].translation() - Vector3(0.3, 0, -0.2)).norm());
  compare({"hinge that carries two links, gap", "0", 0, 0.004, "m"},
          (bodies[1].translation() - Vector3(0, 0, 2)).norm());
  const double x = (2 * 0.3) / 3, z = (0.4 + 2 * 0.2) / 3;
  compare(
      {"center of mass of two links, angle at which they hang", "atan(x / z)", std::atan2(x, z), 0.01, "rad"},
      read(*simulation, "mobile/joint/position"));
}

TEST(JointTruth, wheelsAndTheirCarrierWeighAsOneBody) {
  const Vector3 moments = momentsOfBox(3, {0.3, 0.2, 0.1});
  const auto scene = sceneOf(model("box", "0 0 1 0.3 0.4 0.5", inertial(3, moments, {0.1, 0.2, 0.3})));
  ASSERT_TRUE(scene);
  Physics physics(scene->contents().world);
  compare({"mass of a model", "that of its links", 3, 1e-12, "kg"}, physics.massOf(0));
  const Vector3 center =
      Pose3(Eigen::Translation3d(0, 0, 1) * Eigen::AngleAxisd(0.5, Vector3::UnitZ()) *
            Eigen::AngleAxisd(0.4, Vector3::UnitY()) * Eigen::AngleAxisd(0.3, Vector3::UnitX())) *
      Vector3(0.1, 0.2, 0.3);
  compare({"center of mass in the world", "T p", 0, 1e-12, "m"}, (physics.firstCenter(0) - center).norm());
}

TEST(JointTruth, aMeshIsAsLargeAsItsVertices) {
  // Moving meshes are solid as the box around them: a cube of 1 m, scaled, rests at half its height.
  const std::string mesh =
      std::string("<geometry><mesh><uri>") + ROBOTCONTROL_SOURCE_DIR +
      "/tests/simcore/sdf/models/meshes/cube.obj</uri><scale>0.2 0.2 0.2</scale></mesh></geometry>";
  Bodies bodies(ground() +
                model("cube", "0 0 0.3 0 0 0", inertial(1, momentsOfBox(1, {0.2, 0.2, 0.2})) + solid(mesh)));
  bodies.run(2);
  const auto scene = sceneOf(model("cube", "0 0 0 0 0 0", inertial(1, Vector3::Ones()) + solid(mesh)));
  ASSERT_TRUE(scene);
  const ModelExtent extent = extentOf(*scene->contents().world.models[0].type);
  compare({"moving mesh, height at which it rests", "its lowest vertex touches the ground", -extent.low,
           0.001, "m"},
          bodies.motion("cube").position.z());
}

TEST(JointTruth, modelsInModelsAreWhereTheirPosesAre) {
  const auto pose = [](double x, double y, double z, double roll, double pitch, double yaw) {
    return Pose3(Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(yaw, Vector3::UnitZ()) *
                 Eigen::AngleAxisd(pitch, Vector3::UnitY()) * Eigen::AngleAxisd(roll, Vector3::UnitX()));
  };
  const std::string link =
      "<link name='l'><pose>0.1 0 0 0 0 0.5</pose>" + inertial(1, Vector3::Constant(0.01)) + "</link>";
  const auto scene =
      sceneOf("<model name='a'><pose>1 2 3 0.1 0.2 0.3</pose>" + link +
              "<model name='b'><pose>0.4 0.5 0.6 0.3 0 -0.2</pose>" + link +
              "<model name='c'><pose>-0.3 0.2 0.1 0 0.7 0</pose>" + link +
              "</model></model>"
              "<joint name='ab' type='fixed'><parent>l</parent><child>b::l</child></joint>"
              "<joint name='bc' type='fixed'><parent>b::l</parent><child>b::c::l</child></joint></model>");
  ASSERT_TRUE(scene);
  Physics physics(scene->contents().world);
  ASSERT_EQ(physics.bodyCount(), 3U);
  const Pose3 inLink = pose(0.1, 0, 0, 0, 0, 0.5), a = pose(1, 2, 3, 0.1, 0.2, 0.3),
              b = a * pose(0.4, 0.5, 0.6, 0.3, 0, -0.2), c = b * pose(-0.3, 0.2, 0.1, 0, 0.7, 0);
  const Pose3 expected[] = {a * inLink, b * inLink, c * inLink};
  for (std::size_t i = 0; i < 3; ++i) {
    compare({"models in models, error of their poses", "product of the poses", 0, 1e-12, ""},
            (physics.linkInWorld(i).matrix() - expected[i].matrix()).cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace simcore::truth
