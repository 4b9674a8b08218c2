// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that slide and roll.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

const Vector3 kSize(0.4, 0.4, 0.1);

/// A flat box of 3 kg that lies on a ground which falls towards +x.
std::string boxOn(double slope, double friction) {
  const Vector3 center = Eigen::AngleAxisd(slope, Vector3::UnitY()) * Vector3(0, 0, 0.05);
  return ground(slope, 1) + model("box", numbers(center) + " 0 " + std::to_string(slope) + " 0",
                                  inertial(3, momentsOfBox(3, kSize)) + solid(box(kSize), friction));
}

TEST(FrictionTruth, whatSlidesStopsAfterItsWay) {
  // In any direction: friction has no preferred axis.
  for (const auto& [heading, name] :
       {std::pair{0.0, "sliding along x, stopping distance"},
        std::pair{robotlink::kPi / 4, "sliding at 45 degrees, stopping distance"},
        std::pair{1.2, "sliding at 69 degrees, stopping distance"}}) {
    Bodies bodies(boxOn(0, 0.3));
    bodies.run(0.5);
    const Vector3 start = bodies.motion("box").position;
    bodies.throwModel("box", Vector3(2 * std::cos(heading), 2 * std::sin(heading), 0));
    bodies.run(2);
    const Vector3 way = bodies.motion("box").position - start;
    const double expected = 4 / (2 * 0.3 * kGravity);
    compare({name, "v^2 / (2 mu g)", expected, 0.03 * expected, "m"}, way.head<2>().norm());
    EXPECT_LT(bodies.motion("box").velocity.norm(), 1e-3);
    EXPECT_NEAR(std::atan2(way.y(), way.x()), heading, 0.03) << "it slides straight on";
  }
}

TEST(FrictionTruth, aBoxStaysOnASlopeBelowTheAngleOfFriction) {
  const double slope = std::atan(0.3) - 0.02;
  Bodies bodies(boxOn(slope, 0.3));
  bodies.run(1);
  const Vector3 start = bodies.motion("box").position;
  bodies.run(10);
  compare({"slope just below the angle of friction, way in 10 s", "0", 0, 0.002, "m"},
          (bodies.motion("box").position - start).norm());
}

TEST(FrictionTruth, aBoxSlidesDownASteeperSlope) {
  const double slope = std::atan(0.3) + 0.1;
  Bodies bodies(boxOn(slope, 0.3));
  bodies.run(0.2);
  const double before = bodies.motion("box").velocity.norm();
  bodies.run(1);
  const double expected = kGravity * (std::sin(slope) - 0.3 * std::cos(slope));
  compare({"steeper slope, acceleration", "g (sin a - mu cos a)", expected, 0.02 * expected, "m/s^2"},
          bodies.motion("box").velocity.norm() - before);
}

/// The acceleration down a slope of 0.2 rad, and the share of slip, of what rolls on it.
struct Rolled {
  double acceleration = 0, slip = 0;
};
Rolled rolledDown(const std::string& inLink, double radius, const std::string& tilt) {
  const double slope = 0.2;
  const Vector3 center = Eigen::AngleAxisd(slope, Vector3::UnitY()) * Vector3(0, 0, radius);
  Bodies bodies(ground(slope, 1) + model("round", numbers(center) + " " + tilt, inLink));
  bodies.run(0.4);
  const double before = bodies.motion("round").velocity.norm();
  bodies.run(1);
  const auto motion = bodies.motion("round");
  const double speed = motion.velocity.norm();
  return {speed - before, std::abs(speed - motion.angularVelocity.norm() * radius) / speed};
}

TEST(FrictionTruth, aBallAndACylinderRollDownASlopeWithoutSlipping) {
  const double down = kGravity * std::sin(0.2);
  const Rolled ball = rolledDown(inertial(1, momentsOfSphere(1, 0.1)) + solid(sphere(0.1)), 0.1, "0 0 0");
  compare({"ball down a slope, acceleration", "5/7 g sin a", down * 5 / 7, 0.01 * down, "m/s^2"},
          ball.acceleration);
  compare({"ball down a slope, slip", "0", 0, 0.01, ""}, ball.slip);
  const Rolled shell =
      rolledDown(inertial(1, Vector3::Constant(2.0 / 3 * 0.01)) + solid(sphere(0.1)), 0.1, "0 0 0");
  compare({"hollow ball down a slope, acceleration", "3/5 g sin a", down * 3 / 5, 0.01 * down, "m/s^2"},
          shell.acceleration);
  // Its axis lies along y.
  const Rolled can = rolledDown(inertial(1, momentsOfCylinder(1, 0.1, 0.3)) + solid(cylinder(0.1, 0.3)), 0.1,
                                "1.5707963267948966 0 0");
  compare({"cylinder down a slope, acceleration", "2/3 g sin a", down * 2 / 3, 0.01 * down, "m/s^2"},
          can.acceleration);
  compare({"cylinder down a slope, slip", "0", 0, 0.01, ""}, can.slip);
}

TEST(FrictionTruth, aBallThatIsThrownSlidesAndThenRolls) {
  for (const auto& [friction, heading] : {std::pair{0.2, 0.0}, std::pair{0.5, 0.8}}) {
    Bodies bodies(ground(0, 1) + model("ball", "0 0 0.1 0 0 0",
                                       inertial(1, momentsOfSphere(1, 0.1)) + solid(sphere(0.1), friction)));
    bodies.run(0.2);
    bodies.throwModel("ball", {3 * std::cos(heading), 3 * std::sin(heading), 0});
    double began = 0;
    for (int i = 0; i < 500; ++i) {
      bodies.step();
      const auto motion = bodies.motion("ball");
      if (began == 0 && motion.angularVelocity.norm() * 0.1 > 0.99 * motion.velocity.norm())
        began = bodies.time() - 0.2;
    }
    const auto motion = bodies.motion("ball");
    compare({"thrown ball, speed when it rolls", "5/7 v", 3 * 5.0 / 7, 0.02, "m/s"}, motion.velocity.norm());
    const double time = 2 * 3 / (7 * friction * kGravity);
    compare({"thrown ball, time until it rolls", "2 v / (7 mu g)", time, 0.04 * time + kStepSeconds, "s"},
            began);
  }
}

TEST(FrictionTruth, aBallWithRollingFrictionRollsOut) {
  // A velocity decay of both kinds is a rolling friction in proportion to the speed.
  Bodies bodies(ground(0, 1) +
                model("ball", "0 0 0.1 0 0 0",
                      inertial(1, momentsOfSphere(1, 0.1)) + solid(sphere(0.1)) +
                          "<velocity_decay><linear>0.5</linear><angular>0.5</angular></velocity_decay>"));
  bodies.run(0.2);
  const Vector3 start = bodies.motion("ball").position;
  bodies.throwModel("ball", {1, 0, 0}, {0, 10, 0});
  bodies.run(4);
  const double expected = 1 / 0.5 * (1 - std::exp(-2.0));
  compare({"rolling friction, way in 4 s", "v / d (1 - exp(-d t))", expected, 0.01 * expected, "m"},
          (bodies.motion("ball").position - start).norm());
}

}  // namespace
}  // namespace simcore::truth
