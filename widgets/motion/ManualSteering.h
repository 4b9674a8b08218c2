// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "widgets/View.h"
#include "widgets/motion/ManualControl.h"
#include "widgets/motion/MotionCommander.h"

namespace robotcontrol {
class MotionStatus;
}

namespace widgets {

/// Manual control of the selected robot: what the motion view and the commands for steering have in common.
/// takeOver() switches the robot's behavior (or driving) task to the solution "obey"; from then on tick()
/// sends what is commanded, ten times a second and whenever it changes. Nothing is commanded before manual
/// control is confirmed, nothing while another client steers the robot over a link, and nothing more to a
/// robot that is no longer selected, which is then made to stand. A remote robot may obey another client,
/// so nothing is sent to it, not even to stand, before it was taken over or commanded here, or says that this
/// session steers it.
///
/// One for all views of a window, see manualSteering(). GUI thread; the context must outlive it.
class ManualSteering final : public QObject {
  Q_OBJECT
 public:
  explicit ManualSteering(ViewContext& context, QObject* parent = nullptr);

  /// Adopts the selected robot and what it reports of its solutions.
  void follow();
  /// The same, then sends a motion request if one is due. Called 30 times a second, after the views.
  void tick();

  /// Requests manual control, or returns it to the solution that ran before. A remote robot that nobody
  /// steers then says at once that this window steers it. Fails if that is impossible now;
  /// a refusal of the robot arrives later, see Session::setRefusalHandler().
  robotlink::Result<void> takeOver(bool take);
  /// Sets the state of pad, keys and gamepad. A deflection replaces a velocity commanded by walk(), and
  /// ends with its release; without a deflection that continues.
  void setAxes(const WalkAxes& axes);
  /// Ends what pad, keys and gamepad command, and sends that at once.
  void releaseAxes();
  /// Commands what the panel of the head says.
  void setHead(const HeadTarget& head);

  // The functions for commands. They fail without manual control; while it has been requested and is not
  // confirmed yet, what they command begins as soon as it is.
  /// Commands a velocity until another one is commanded, m/s and rad/s; also of robots on wheels.
  robotlink::Result<void> walk(const Speed& velocity);
  /// Commands standing still; the head keeps its mode.
  robotlink::Result<void> stand();
  /// Commands a key-frame motion, or MotionCommander::kGetUp. Robots on wheels have none.
  robotlink::Result<void> play(const std::string& motion);
  /// Commands what the head does: "look-ahead", "search-ball", "track-ball" or "look-around".
  robotlink::Result<void> setHeadMode(const std::string& mode);
  /// Commands the angle of a joint of the head in rad ("pan", see kHeadJoints); the others keep theirs. Fails
  /// for joints that the robot does not have, and beyond their limits.
  robotlink::Result<void> setHeadJoint(const std::string& joint, double angle);

  /// Commands the angle of a single joint in rad; the others hold theirs. Fails for joints that the robot
  /// does not have, and beyond their limits.
  robotlink::Result<void> setJoint(const std::string& joint, double angle);
  /// Commands all joints limp, so that the robot is posed by hand, or to hold where they are.
  robotlink::Result<void> setLimp(bool limp);

  const std::string& robot() const { return robot_; }
  /// The description of the robot; null: unknown.
  const std::shared_ptr<const robotlink::RobotDescription>& description() const { return description_; }
  const ManualControl& control() const { return control_; }
  /// Whether the user commands the robot.
  bool isTaken() const { return control_.state() == ManualControl::State::kTaken; }
  /// Limits, head and command; the view changes its limits directly.
  MotionCommander& commander() { return commander_; }
  /// The motion that the robot reports to execute; null: none.
  const robotcontrol::MotionStatus* status() const;

 private:
  bool hasWheels() const;
  /// Follows the selected robot; fails if there is none.
  robotlink::Result<void> requireRobot();
  /// Fails, with the reason, unless manual control is taken or being taken. Else this window commands from
  /// now on.
  robotlink::Result<void> requireControl();
  /// The same for what only legged robots can do.
  robotlink::Result<void> requireLegs(const char* what);
  /// Fails if the robot does not have the joint, or for an angle beyond its limits. `shown` is its name for
  /// the user.
  robotlink::Result<void> requireJoint(const char* id, const std::string& joint, const std::string& shown,
                                       double angle) const;
  /// Makes a remote robot that nobody steers announce that this window does.
  void claim();
  /// Requests that the robot's program publishes what it executes.
  void requestStatus();
  /// Whether commands of this window are sent: to remote robots, not before there was one.
  bool isSteeredHere() const;
  /// Sends the commander's command with the timeline's newest time.
  void send();

  ViewContext& context_;
  ManualControl control_;
  MotionCommander commander_;
  /// The last axes of the views.
  WalkAxes axes_;
  std::string robot_;
  std::shared_ptr<const robotlink::RobotDescription> description_;
  /// Addresses of the solution tables that control_ has seen.
  std::vector<const void*> tables_;
  /// Whether the debug key of MotionStatus was requested for this robot.
  bool isStatusRequested_ = false;
  /// Whether the robot was taken over or commanded in this window.
  bool isCommanded_ = false;
};

/// The steering that all views of the context share.
ManualSteering& manualSteering(ViewContext& context);

}  // namespace widgets
