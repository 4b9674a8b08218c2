// SPDX-License-Identifier: GPL-3.0-or-later
// A bench with a small robot that plays motions, for tests of joints and of the motion editor.
#pragma once

#include <memory>
#include <string>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/commands/CommandCatalog.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/motions/MotionWords.h"
#include "tests/widgets/Bench.h"
#include "widgets/motion/MotionCommands.h"
#include "widgets/motions/MotionBench.h"
#include "widgets/motions/MotionEditorCommands.h"
#include "widgets/motions/MotionFiles.h"

namespace widgets::test {

inline const std::string kWave =
    "motion_id = wave\n"
    "joints = headPan legFL1 legFR1\n"
    "label start\n"
    "  10  20  30  1 300 // up\n"
    " -10   *   -  0 100\n"
    "transition allMotions extern start\n";

/// The robot red1 has the joints headPan, legFL1 and legFR1, and the motion wave in its files.
struct JointBench : Bench {
  JointBench() {
    auto robot = std::make_shared<robotlink::RobotDescription>();
    robot->name = "toy";
    const auto limit = robotlink::radians(90);
    robot->joints = {{"headPan", -limit, limit, 3, 0, "headPan", true},
                     {"legFL1", -limit / 2, limit, 3, 0, "legFR1", false},
                     {"legFR1", -limit / 2, limit, 3, 0, "legFL1", false}};
    context.robots["red1"] = robot;
    auto base = std::make_shared<robotlink::RobotDescription>();
    base->name = "base";
    base->drive = robotlink::RobotDescription::Drive();
    context.robots["blue1"] = base;
    commands = robotlink::CommandTable(robotlink::commandCatalog());
    attachMotionCommands(context);
    attachMotionEditorCommands(context);
    publishMotions();
    publishBehavior("go-to-ball");
    step();
  }
  /// Lets the session and all that follow it notice what was published.
  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      session.tick();
      manualSteering(context).tick();
      tickMotions(context);
    }
  }
  void publishMotions(const std::string& wave = kWave, bool sent = false) {
    robotcontrol::MotionTable table;
    for (const char* joint : {"headPan", "legFL1", "legFR1"}) table.add_joints(joint);
    const auto add = [&](const char* name, const std::string& text, bool isSent) {
      auto& motion = *table.add_motions();
      motion.set_name(name);
      motion.set_text(text);
      motion.set_sent(isSent);
    };
    add("extern",
        "motion_id = extern\nlabel start\ntransition wave wave start\ntransition extern extern start\n",
        false);
    add("wave", wave, sent);
    push("red1/tables/motions", table, ++time);
  }
  void publishBehavior(const std::string& active) {
    robotcontrol::SolutionTable table;
    auto& task = *table.add_tasks();
    task.set_name("behavior");
    task.set_active(active);
    task.add_solutions()->set_name("go-to-ball");
    task.add_solutions()->set_name("obey");
    push("red1/tables/solutions", table, ++time);
  }
  /// Measured and requested angles of all joints, degrees.
  void publishJoints(double measured, double requested) {
    foxglove::JointStates states;
    robotcontrol::JointRequest request;
    for (const char* name : {"headPan", "legFL1", "legFR1"}) {
      auto& joint = *states.add_joints();
      joint.set_name(name);
      joint.set_position(robotlink::radians(measured));
      joint.set_velocity(0.5);
      joint.set_effort(0.125);
      request.add_positions(robotlink::radians(requested));
    }
    push("red1/joints/states", states, ++time);
    push("red1/joints/request", request, time);
  }
  void takeOver() {
    QCOMPARE(refusal("robot.take-over"), std::string());
    publishBehavior("obey");
    step();
    requests.clear();
  }
  std::string refusal(const std::string& line) {
    const auto done = commands.runLine(line);
    return done ? std::string() : done.error().id;
  }
  /// The last motion that was commanded; fails if there was none.
  robotcontrol::MotionRequest commanded() const {
    for (auto request = requests.rbegin(); request != requests.rend(); ++request) {
      if (request->has_motion()) return request->motion().motion();
    }
    qFatal("no motion was commanded");
  }
  /// The last text that was sent; fails if there was none.
  const robotcontrol::Request& sentMotion() const {
    for (auto request = requests.rbegin(); request != requests.rend(); ++request) {
      if (request->has_set_motion()) return *request;
    }
    qFatal("no motion was sent");
  }
  MotionBench& bench() { return motionBench(context); }
  /// A line of the motion's text, from 1.
  std::string row(int line) {
    return std::string(robotlink::motionRows(bench().document().text())[static_cast<std::size_t>(line - 1)]);
  }
  TestFolder folder;
  double time = 0;
};

}  // namespace widgets::test
