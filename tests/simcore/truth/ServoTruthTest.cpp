// SPDX-License-Identifier: GPL-3.0-or-later
// Motors of joints against the equation of motion, which is integrated with steps of 10 us.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

/// kg m^2, of a flywheel about its vertical axis.
constexpr double kInertia = 0.004;

struct Motor {
  double effort = 100, velocity = 100;
  std::string servo = {};
  /// The joint's axis; a horizontal one lets the weight work, 0.2 kg at 0.3 m.
  bool isArm = false;
};

std::unique_ptr<Simulation> flywheel(const Motor& motor) {
  const double shift = motor.isArm ? 0.3 : 0;
  const double moment = motor.isArm ? 0.001 : kInertia;
  return simulationOf(
      model("wheel", "0 0 2 0 0 0", inertial(motor.isArm ? 0.2 : 1, Vector3::Constant(moment), {shift, 0, 0}),
            jointToWorld(
                "revolute",
                fmt::format("<axis><xyz>{}</xyz><limit><lower>-3</lower><upper>3</upper><effort>{}</effort>"
                            "<velocity>{}</velocity></limit></axis>",
                            motor.isArm ? "0 -1 0" : "0 0 1", motor.effort, motor.velocity),
                "<robotcontrol:speed_sensor/><robotcontrol:load_sensor/><robotcontrol:servo>" + motor.servo +
                    "</robotcontrol:servo>")));
}

struct Gains {
  double p = 0, i = 0, d = 0;
  std::string xml() const {
    return fmt::format(
        "<robotcontrol:p>{}</robotcontrol:p><robotcontrol:i>{}</robotcontrol:i>"
        "<robotcontrol:d>{}</robotcontrol:d>",
        p, i, d);
  }
};

/// The response to a step of the command from 0 to 1 rad.
class Response {
 public:
  Gains gains;
  double inertia = kInertia, limit = 1e9, delay = 0;
  /// The torque of the weight at an angle.
  std::function<double(double)> load = [](double) { return 0.0; };

  /// Continues up to a time and returns the angle.
  double at(double time) {
    constexpr double kFine = 1e-5;
    for (; time_ < time - kFine / 2; time_ += kFine) {
      const double missing = (time_ >= delay - kFine / 2 ? 1 : 0) - angle_;
      const double wanted = gains.p * missing + gains.i * integral_ - gains.d * rate_;
      const double torque = std::clamp(wanted, -limit, limit);
      if (wanted == torque || wanted * missing < 0) integral_ += missing * kFine;
      rate_ += kFine * (torque + load(angle_)) / inertia;
      angle_ += kFine * rate_;
    }
    return angle_;
  }

 private:
  double time_ = 0, angle_ = 0, rate_ = 0, integral_ = 0;
};

/// The largest difference between the simulated and the expected angle.
double largestError(Simulation& simulation, Response response, double seconds) {
  simulation.requestAngle(0, 1);
  double largest = 0;
  for (int i = 1; i * kStepSeconds <= seconds; ++i) {
    simulation.step();
    largest =
        largerOf(largest, std::abs(read(simulation, "wheel/joint/position") - response.at(i * kStepSeconds)));
  }
  return largest;
}

TEST(ServoTruth, stepResponsesAreThoseOfTheirGains) {
  struct Case {
    const char* name;
    Gains gains;
    double tolerance;
  };
  // A step of the physics is a delay of h / 2, which takes p h / 2 of the damping: what only swings gains a
  // little with each period.
  for (const auto& [name, gains, tolerance] :
       {Case{"step response, P", {0.4, 0, 0}, 0.06},
        Case{"step response, P and D, swinging", {0.4, 0, 0.02}, 0.03},
        Case{"step response, P and D, critically damped", {0.4, 0, 0.08}, 0.03},
        Case{"step response, P, I and D", {0.4, 1, 0.05}, 0.03}}) {
    const auto simulation = flywheel({.servo = gains.xml()});
    Response response;
    response.gains = gains;
    compare({name, "I a = p e + i integral(e) - d w, over 1.5 s", 0, tolerance, "rad"},
            largestError(*simulation, response, 1.5));
  }
}

TEST(ServoTruth, aDelayedCommandGivesTheSameResponseLater) {
  const Gains gains{0.4, 0, 0.05};
  const auto simulation = flywheel({.servo = gains.xml() + "<robotcontrol:delay>0.1</robotcontrol:delay>"});
  Response response;
  response.gains = gains;
  response.delay = 0.1;
  compare({"step response with a delay of 0.1 s", "I a = p e - d w", 0, 0.03, "rad"},
          largestError(*simulation, response, 1.2));
}

TEST(ServoTruth, aWeakMotorSaturates) {
  const Gains gains{0.4, 0, 0.05};
  const auto simulation = flywheel({.effort = 0.05, .servo = gains.xml()});
  Response response;
  response.gains = gains;
  response.limit = 0.05;
  compare({"step response with the torque limited to an eighth", "I a = clamp(p e - d w)", 0, 0.03, "rad"},
          largestError(*simulation, response, 2));
}

TEST(ServoTruth, aWeightIsHeldWhereTheGainsSay) {
  const auto torqueAt = [](double angle) { return -0.2 * kGravity * 0.3 * std::cos(angle); };
  for (const auto& [gains, name] :
       {std::pair{Gains{4, 0, 0.6}, "step response of an arm with its weight, P and D"},
        std::pair{Gains{4, 8, 0.6}, "step response of an arm with its weight, P, I and D"}}) {
    const auto simulation = flywheel({.servo = gains.xml(), .isArm = true});
    Response response;
    response.gains = gains;
    response.inertia = 0.001 + 0.2 * 0.09;
    response.load = torqueAt;
    compare({name, "I a = p e + i integral(e) - d w - m g l cos", 0, 0.03, "rad"},
            largestError(*simulation, response, 3));
  }
  const auto simulation = flywheel({.servo = Gains{4, 0, 0.6}.xml(), .isArm = true});
  advance(*simulation, 4);
  // p e = m g l cos(e)
  double sag = 0;
  for (int i = 0; i < 100; ++i) sag = torqueAt(sag) / 4;
  compare({"sag of a proportional servo", "p e = m g l cos e", sag, 1e-3, "rad"},
          read(*simulation, "wheel/joint/position"));
  compare({"load of a joint that holds an arm", "m g l cos e", -torqueAt(sag), 2e-3, "N m"},
          read(*simulation, "wheel/joint/load"));
}

TEST(ServoTruth, aStiffServoTurnsAtItsSpeedAndArrives) {
  const auto simulation = flywheel({.velocity = 2});
  simulation->requestAngle(0, 1);
  advance(*simulation, 0.3);
  compare({"stiff servo, angle on its way", "w t", 0.6, 2 * kStepSeconds, "rad"},
          read(*simulation, "wheel/joint/position"));
  compare({"stiff servo, speed on its way", "its limit", 2, 1e-3, "rad/s"},
          read(*simulation, "wheel/joint/speed"));
  advance(*simulation, 1);
  compare({"stiff servo, angle in the end", "its command", 1, 1e-4, "rad"},
          read(*simulation, "wheel/joint/position"));
}

TEST(ServoTruth, torqueMotorsKeepTheirTorqueAndTheirSpeed) {
  const auto simulation = flywheel(
      {.effort = 0.02, .velocity = 1.5, .servo = "<robotcontrol:control>torque</robotcontrol:control>"});
  simulation->requestAngle(0, 0.01);
  advance(*simulation, 0.2);
  compare({"torque motor, speed after 0.2 s", "T t / I", 0.01 * 0.2 / kInertia, 1e-3, "rad/s"},
          read(*simulation, "wheel/joint/speed"));
  compare({"torque motor, load", "its command", 0.01, 1e-4, "N m"}, read(*simulation, "wheel/joint/load"));
  simulation->requestAngle(0, 5);
  advance(*simulation, 0.1);
  compare({"torque motor beyond its effort, speed gained in 0.1 s", "limit t / I", 0.02 * 0.1 / kInertia,
           1e-3, "rad/s"},
          read(*simulation, "wheel/joint/speed") - 0.5);
  advance(*simulation, 0.5);
  compare({"torque motor, greatest speed", "its limit", 1.5, 1e-3, "rad/s"},
          read(*simulation, "wheel/joint/speed"));
}

TEST(ServoTruth, velocityMotorsReachTheirSpeedWithTheirTorque) {
  const auto simulation = flywheel(
      {.effort = 0.02, .velocity = 3, .servo = "<robotcontrol:control>velocity</robotcontrol:control>"});
  simulation->requestAngle(0, 10);
  advance(*simulation, 0.2);
  compare({"velocity motor, speed after 0.2 s", "limit t / I", 0.02 * 0.2 / kInertia, 1e-3, "rad/s"},
          read(*simulation, "wheel/joint/speed"));
  advance(*simulation, 0.5);
  compare({"velocity motor, greatest speed", "its limit", 3, 1e-3, "rad/s"},
          read(*simulation, "wheel/joint/speed"));
}

}  // namespace
}  // namespace simcore::truth
