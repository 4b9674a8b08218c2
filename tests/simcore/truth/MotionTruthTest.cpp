// SPDX-License-Identifier: GPL-3.0-or-later
// Free motion: falling, flying, tumbling, swinging. The integrator is semi-implicit Euler with steps of h:
// its ways differ from the truth by half a step's speed, g t h / 2, and that is the tolerance where it is
// named.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

using robotlink::kPi;

constexpr double kStep = kStepSeconds;

std::string ballAt(const std::string& pose) {
  return model("ball", pose, inertial(2, momentsOfSphere(2, 0.1)) + solid(sphere(0.1)));
}

TEST(MotionTruth, whatFallsFallsAsGalileoSays) {
  Bodies bodies(ballAt("0 0 100 0 0 0"));
  bodies.run(1);
  const auto ball = bodies.motion("ball");
  compare({"free fall, way after 1 s", "g t^2 / 2", kGravity / 2, kGravity * kStep / 2 * 1.001, "m"},
          100 - ball.position.z());
  compare({"free fall, speed after 1 s", "g t", kGravity, 1e-9, "m/s"}, -ball.velocity.z());
}

TEST(MotionTruth, whatIsThrownFliesAlongAParabola) {
  Bodies bodies(ballAt("0 0 100 0 0 0"));
  bodies.throwModel("ball", {3, -1, 4}, {1, 2, 3});
  bodies.run(0.8);
  const auto ball = bodies.motion("ball");
  compare({"throw, way along the ground", "v t", 2.4, 1e-9, "m"}, ball.position.x());
  compare({"throw, height", "v t - g t^2 / 2", 4 * 0.8 - kGravity * 0.32, kGravity * 0.8 * kStep / 2 * 1.001,
           "m"},
          ball.position.z() - 100);
  compare({"throw, turning of a sphere", "constant", std::sqrt(14.0), 1e-6, "rad/s"},
          ball.angularVelocity.norm());
}

TEST(MotionTruth, decayOfVelocityIsExponential) {
  Bodies bodies("<gravity>0 0 0</gravity>" +
                model("ball", "0 0 1 0 0 0",
                      inertial(2, momentsOfSphere(2, 0.1)) +
                          "<velocity_decay><linear>0.5</linear><angular>1</angular></velocity_decay>"));
  bodies.throwModel("ball", {2, 0, 0}, {0, 0, 3});
  bodies.run(2);
  const auto ball = bodies.motion("ball");
  // The decay of each step is 1 - d h instead of exp(-d h), which differs by (d h)^2 / 2 of the speed.
  compare({"velocity_decay, speed after 2 s", "v exp(-d t)", 2 * std::exp(-1.0), 0.002, "m/s"},
          ball.velocity.x());
  compare({"velocity_decay, turning after 2 s", "w exp(-d t)", 3 * std::exp(-2.0), 0.003, "rad/s"},
          ball.angularVelocity.z());
  compare({"velocity_decay, way after 2 s", "v / d (1 - exp(-d t))", 4 * (1 - std::exp(-1.0)), 0.01, "m"},
          ball.position.x());
}

/// A body without gravity whose moments of inertia are these.
std::string tumbling(const Vector3& moments) {
  return "<gravity>0 0 0</gravity>" + model("top", "0 0 5 0 0 0", inertial(1, moments));
}

TEST(MotionTruth, aSymmetricTopPrecessesAboutItsAngularMomentum) {
  Bodies bodies(tumbling({0.02, 0.02, 0.04}));
  bodies.throwModel("top", Vector3::Zero(), {1.5, 0, 6});
  const Bodies::Sums start = bodies.sums();
  const Vector3 axis = start.angularMomentum.normalized();
  // The angle of the top's axis about that of the angular momentum.
  const Vector3 first = axis.unitOrthogonal(), second = axis.cross(first);
  double turned = 0, before = 0, nutation = 0;
  for (int i = 0; i <= 500; ++i) {
    const Vector3 top = bodies.motion("top").rotation * Vector3::UnitZ();
    const double angle = std::atan2(top.dot(second), top.dot(first));
    if (i > 0) turned += robotlink::normalizedAngle(angle - before);
    before = angle;
    nutation = std::acos(top.dot(axis));
    if (i < 500) bodies.step();
  }
  const double rate = start.angularMomentum.norm() / 0.02;
  compare({"free top, rate of precession over 2 s", "L / I1", rate, 0.01 * rate, "rad/s"}, turned / 2);
  compare({"free top, angle to its angular momentum after 2 s", "atan(I1 w1 / (I3 w3))",
           std::atan2(0.02 * 1.5, 0.04 * 6), 0.01, "rad"},
          nutation);
  const Bodies::Sums end = bodies.sums();
  compare({"free top, change of the angular momentum in 2 s", "0", 0, 0.01 * start.angularMomentum.norm(),
           "N m s"},
          (end.angularMomentum - start.angularMomentum).norm());
  compare({"free top, change of the energy in 2 s", "0", 0, 0.01 * start.kinetic, "J"},
          end.kinetic - start.kinetic);
}

TEST(MotionTruth, aBoxThatTumblesAboutItsMiddleAxisGainsNoEnergy) {
  Bodies bodies(tumbling({0.02, 0.03, 0.045}));
  bodies.throwModel("top", {1, 0, 0}, {0.01, 5, 0});
  const Bodies::Sums start = bodies.sums();
  double most = 0;
  for (int i = 0; i < 2500; ++i) {
    bodies.step();
    most = largerOf(most, bodies.sums().kinetic);
  }
  const Bodies::Sums end = bodies.sums();
  compare({"tumbling box, greatest gain of energy in 10 s", "none", 0, 0.001 * start.kinetic, "J"},
          largerOf(0.0, most - start.kinetic));
  compare({"tumbling box, change of the momentum in 10 s", "0", 0, 1e-9, "N s"},
          (end.momentum - start.momentum).norm());
  compare({"tumbling box, change of the angular momentum in 10 s", "0", 0,
           0.03 * (start.angularMomentum).norm(), "N m s"},
          (end.angularMomentum - end.momentum.cross(Vector3::Zero()) - start.angularMomentum).norm());
}

/// A bar of 1 kg and 1 m length that hangs from its upper end at the world's height 2, turned by an angle.
std::string pendulum(double angle, const std::string& axis = "<axis><xyz>0 1 0</xyz></axis>",
                     const std::string& type = "revolute") {
  return model("bar", "0 0 2 0 " + std::to_string(angle) + " 0",
               inertial(1, momentsOfBox(1, {0.02, 0.02, 1}), {0, 0, -0.5}), jointToWorld(type, axis));
}

/// The times at which the bar's center passes the lowest place from one side, interpolated.
std::vector<double> passages(Bodies& bodies, double seconds) {
  std::vector<double> times;
  double before = bodies.motion("bar").position.x();
  while (bodies.time() < seconds) {
    bodies.step();
    const double x = bodies.motion("bar").position.x();
    if (before < 0 && x >= 0) times.push_back(bodies.time() - kStep * x / (x - before));
    before = x;
  }
  return times;
}

double periodOf(Bodies& bodies, double seconds) {
  const auto times = passages(bodies, seconds);
  if (times.size() < 2) return std::nan("");
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

/// The period of a bar about its end, for small amplitudes.
double barPeriod() {
  return 2 * kPi * std::sqrt(1.0 / 3 / (kGravity * 0.5));
}

TEST(MotionTruth, aPendulumSwingsWithItsPeriod) {
  Bodies bodies(pendulum(0.05));
  const double period = barPeriod() * (1 + 0.05 * 0.05 / 16);
  compare(
      {"pendulum, period at 0.05 rad", "2 pi sqrt(I / (m g l)) (1 + a^2 / 16)", period, 0.001 * period, "s"},
      periodOf(bodies, 30));
}

TEST(MotionTruth, aLargeSwingTakesLongerAsTheEllipticIntegralSays) {
  for (const auto& [amplitude, name] :
       {std::pair{1.5, "pendulum, period at 1.5 rad"}, std::pair{2.5, "pendulum, period at 2.5 rad"}}) {
    Bodies bodies(pendulum(amplitude));
    const double period = barPeriod() * 2 / kPi * std::comp_ellint_1(std::sin(amplitude / 2));
    compare({name, "4 sqrt(I / (m g l)) K(sin(a / 2))", period, 0.015 * period, "s"}, periodOf(bodies, 12));
  }
}

TEST(MotionTruth, aPendulumKeepsItsEnergyForAMinute) {
  Bodies bodies(pendulum(1));
  const double start = bodies.sums().energy() - kGravity * 1.5;
  double most = start, mean = 0;
  for (int i = 0; i < 15000; ++i) {
    bodies.step();
    const double energy = bodies.sums().energy() - kGravity * 1.5;
    most = largerOf(most, energy);
    if (i >= 14000) mean += energy / 1000;
  }
  // Semi-implicit Euler lets the energy sway with the swing, by about half a step's work.
  compare({"pendulum, greatest gain of energy in a minute", "none", 0, 0.02 * start, "J"}, most - start);
  compare({"pendulum, energy after a minute", "that of the start", start, 0.02 * start, "J"}, mean);
}

TEST(MotionTruth, aConicalPendulumTurnsAtItsRate) {
  const double angle = 0.5;
  // A sphere at 1 m, which hangs from a ball joint: its spin about the vertical exerts no moment.
  Bodies bodies(model("bar", "0 0 2 0 0.5 0", inertial(1, momentsOfSphere(1, 0.2), {0, 0, -1}),
                      jointToWorld("ball", "")));
  const double rate = std::sqrt(kGravity / std::cos(angle));
  const Vector3 start = bodies.motion("bar").position - Vector3(0, 0, 2);
  bodies.throwModel("bar", Vector3(0, 0, rate).cross(start), Vector3(0, 0, rate));
  double turned = 0, before = std::atan2(start.y(), start.x());
  for (int i = 0; i < 1000; ++i) {
    bodies.step();
    const Vector3 now = bodies.motion("bar").position;
    const double heading = std::atan2(now.y(), now.x());
    turned += robotlink::normalizedAngle(heading - before);
    before = heading;
  }
  compare(
      {"conical pendulum at a ball joint, rate over 4 s", "sqrt(g / (l cos a))", rate, 0.02 * rate, "rad/s"},
      turned / 4);
}

}  // namespace
}  // namespace simcore::truth
