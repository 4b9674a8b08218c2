// SPDX-License-Identifier: GPL-3.0-or-later
// Collisions: what they conserve, and how what bounces goes on.
#include <gtest/gtest.h>

#include <cmath>

#include "robotlink/base/Random.h"
#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

constexpr const char* kWeightless = "<gravity>0 0 0</gravity>";

std::string ball(const std::string& name, const std::string& place, double mass, double radius,
                 double restitution, double friction = 0) {
  return model(name, place + " 0 0 0",
               inertial(mass, momentsOfSphere(mass, radius)) + solid(sphere(radius), friction, restitution));
}

TEST(CollisionTruth, ballsThatMeetHeadOnKeepMomentumAndBounce) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    // From light to heavy: 0.1 kg on 0.3 kg, and 30 kg on 90 kg.
    for (const double mass : {0.1, 30.0}) {
      Bodies bodies(kWeightless + ball("a", "-0.5 0 1", mass, 0.1, restitution) +
                    ball("b", "0.5 0 1", 3 * mass, 0.1, restitution));
      bodies.throwModel("a", {2, 0, 0});
      const Bodies::Sums start = bodies.sums();
      bodies.run(1.5);
      const Bodies::Sums end = bodies.sums();
      compare({"head-on collision, change of the momentum", "0", 0, 1e-9 * start.momentum.norm(), "N s"},
              (end.momentum - start.momentum).norm());
      const double apart = bodies.motion("b").velocity.x() - bodies.motion("a").velocity.x();
      compare({"head-on collision, speed of separation", "e v", restitution * 2, 0.04, "m/s"}, apart);
      compare({"head-on collision, speed of the heavier ball", "(1 + e) v m1 / (m1 + m2)",
               (1 + restitution) * 2 / 4, 0.02, "m/s"},
              bodies.motion("b").velocity.x());
    }
  }
}

TEST(CollisionTruth, aGrazingCollisionKeepsAngularMomentum) {
  Bodies bodies(kWeightless + ball("a", "-0.5 0.1 1", 1, 0.1, 0.8, 0.5) +
                ball("b", "0.5 0 1", 2, 0.1, 0.8, 0.5));
  bodies.throwModel("a", {2, 0, 0.1}, {1, 2, 3});
  const Bodies::Sums start = bodies.sums();
  double most = start.kinetic;
  for (int i = 0; i < 375; ++i) {
    bodies.step();
    most = largerOf(most, bodies.sums().kinetic);
  }
  const Bodies::Sums end = bodies.sums();
  EXPECT_LT(end.kinetic, 0.98 * start.kinetic) << "they met";
  compare({"grazing collision, change of the momentum", "0", 0, 1e-9, "N s"},
          (end.momentum - start.momentum).norm());
  // Between two steps the balls overlap, and the force acts where that is.
  compare({"grazing collision, change of the angular momentum", "0", 0, 0.01 * start.angularMomentum.norm(),
           "N m s"},
          (end.angularMomentum - start.angularMomentum).norm());
  compare({"grazing collision, gain of energy", "none", 0, 1e-9, "J"}, largerOf(0.0, most - start.kinetic));
}

TEST(CollisionTruth, whatFallsBouncesToTheSquareOfItsRestitution) {
  struct Case {
    double restitution;
    const char* name;
  };
  for (const auto& [restitution, name] :
       {Case{0, "fall from 1 m, rebound with e = 0"}, Case{0.5, "fall from 1 m, rebound with e = 0.5"},
        Case{0.9, "fall from 1 m, rebound with e = 0.9"}}) {
    for (const double mass : {0.2, 50.0}) {
      Bodies bodies(ground(0, 1, restitution) + ball("ball", "0 0 1.1", mass, 0.1, restitution));
      double highest = 0, lowest = 2;
      bool fell = false;
      for (int i = 0; i < 300; ++i) {
        bodies.step();
        const double height = bodies.motion("ball").position.z() - 0.1;
        lowest = std::min(lowest, height);
        fell |= height < 0.02;
        if (fell) highest = largerOf(highest, height);
      }
      // A step's fall at 4.4 m/s is 18 mm: that is how deep it may sink before it is noticed.
      compare({name, "e^2 h", restitution * restitution, 0.03, "m"}, highest < 0.021 ? 0 : highest);
      EXPECT_GT(lowest, -0.02);
    }
  }
}

TEST(CollisionTruth, energyDoesNotGrowAmongManyBalls) {
  std::string balls;
  robotlink::Random random(11);
  for (int i = 0; i < 27; ++i) {
    balls += ball("ball" + std::to_string(i), numbers({i % 3 * 0.4, i / 3 % 3 * 0.4, 1 + i / 9 * 0.4}),
                  0.5 + 0.1 * (i % 4), 0.1, 0.7, 0.4);
  }
  Bodies bodies(kWeightless + balls);
  for (int i = 0; i < 27; ++i) {
    const Vector3 velocity{random.normal(), random.normal(), random.normal()};
    bodies.throwModel("ball" + std::to_string(i), velocity);
  }
  const Bodies::Sums start = bodies.sums();
  double growth = 0, before = start.kinetic;
  for (int i = 0; i < 1000; ++i) {
    bodies.step();
    const double now = bodies.sums().kinetic;
    growth = largerOf(growth, now - before);
    before = now;
  }
  const Bodies::Sums end = bodies.sums();
  EXPECT_LT(end.kinetic, 0.95 * start.kinetic) << "some met";
  compare({"27 balls, greatest gain of energy in a step", "none", 0, 0.01 * start.kinetic, "J"}, growth);
  compare({"27 balls, change of the momentum", "0", 0, 1e-9, "N s"}, (end.momentum - start.momentum).norm());
  compare({"27 balls, change of the angular momentum", "0", 0, 0.02 * start.angularMomentum.norm(), "N m s"},
          (end.angularMomentum - start.angularMomentum).norm());
}

TEST(CollisionTruth, aBoxThatFallsOnItsCornerGainsNoEnergy) {
  const Vector3 size(0.3, 0.2, 0.1);
  Bodies bodies(ground(0, 0.6, 0.5) + model("box", "0 0 0.8 0.5 0.6 0.7",
                                            inertial(2, momentsOfBox(2, size)) + solid(box(size), 0.6, 0.5)));
  bodies.throwModel("box", {1, 0, 0}, {2, -3, 1});
  const double start = bodies.sums().energy();
  double most = start;
  for (int i = 0; i < 2500; ++i) {
    bodies.step();
    most = largerOf(most, bodies.sums().energy());
  }
  compare({"box falling on a corner, gain of energy", "none", 0, 0.01 * start, "J"}, most - start);
  compare({"box falling on a corner, height of its center at rest", "half its height", 0.05, 0.002, "m"},
          bodies.motion("box").position.z());
  compare({"box falling on a corner, speed at rest", "0", 0, 0.002, "m/s"},
          bodies.motion("box").velocity.norm() + bodies.motion("box").angularVelocity.norm() * 0.1);
}

}  // namespace
}  // namespace simcore::truth
