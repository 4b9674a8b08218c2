// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/program/SentMotions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/process/Process.h"
#include "robotlink/process/Sender.h"

namespace robotlink {

class DebugContext;

/// The packages that the debug process sends on behalf of a user: "remote/motion", "remote/goal",
/// "colors/table" and "motions/texts". What is sent holds for the program until something else is. Used by
/// the debug process; internal to this folder.
class UserPackages {
 public:
  /// `joints` are the robot's. The process and its context must outlive this object.
  UserPackages(Process& process, DebugContext& debug, std::vector<std::string> joints);

  /// Whether requests of this kind ask for one of these packages.
  static bool has(const robotcontrol::Request& request);
  /// The sender of the package that a request asks for, which `has()`. It is connected if a task receives it.
  const AnySender& senderFor(const robotcontrol::Request& request) const;
  /// Returns the purpose of the task that receives this package: "drives to goals".
  static const char* useOf(const robotcontrol::Request& request);
  /// Why the program cannot use what a request brings, which is valid in itself; empty: it can.
  std::string whyNot(const robotcontrol::Request& request) const;

  /// Sends what a request asks for, and logs what it changes for a person; a repeated one changes nothing.
  /// Returns the checksum of a color table, otherwise 0.
  std::uint64_t send(const robotcontrol::Request& request);
  /// Sends a package without a request. Packages of other types and invalid color tables are ignored.
  void offer(const PackagePtr& package);

  /// The color table in use, without its cells; none: no task of the program uses one.
  std::optional<robotcontrol::ColorTable> colorTableInUse() const;
  /// The key-frame motions, with `more` among them; none: no task of the program plays any.
  std::optional<robotcontrol::MotionTable> motions(const std::vector<robotcontrol::MotionText>& more) const;
  /// Publishes both if they have changed since they were published, or if that was asked for.
  void publishChanged();
  void publishAgain() { colorTableDue_ = motionsDue_ = true; }

 private:
  struct Row;
  static const Row* rowFor(const robotcontrol::Request& request);
  std::uint64_t sendRemoteMotion(const robotcontrol::Request& request);
  std::uint64_t sendColorTable(const robotcontrol::Request& request);
  std::uint64_t sendMotionText(const robotcontrol::Request& request);
  std::uint64_t sendGoal(const robotcontrol::Request& request);
  void use(std::shared_ptr<const robotcontrol::ColorTable> table);
  const AnySender& remoteMotionSender() const { return remoteMotion_; }
  const AnySender& colorTableSender() const { return colorTable_; }
  const AnySender& motionTextSender() const { return motions_.sender(); }
  const AnySender& goalSender() const { return goal_; }

  Process& process_;
  DebugContext& debug_;
  Sender<robotcontrol::RemoteMotion> remoteMotion_;
  Sender<robotcontrol::ColorTable> colorTable_;
  SentMotions motions_;
  Sender<robotcontrol::DriveGoal> goal_;
  std::shared_ptr<const robotcontrol::ColorTable> colorTableInUse_;  // null: the built-in one
  bool colorTableDue_ = true, motionsDue_ = true;
};

}  // namespace robotlink
