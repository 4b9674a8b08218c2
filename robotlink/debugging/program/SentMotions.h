// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/base/Clock.h"
#include "robotlink/motions/MotionLibrary.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/process/Process.h"
#include "robotlink/process/Sender.h"

namespace robotlink {

/// The key-frame motions of a robot's program: those of its files (resources/motions), and those that a user
/// has sent, which go to the task that plays them as the package "motions/texts". Used by the debug process;
/// internal to this folder. The files are read when they are needed first.
class SentMotions {
 public:
  /// `joints` are the robot's; the process must outlive this object.
  SentMotions(Process& process, std::vector<std::string> joints)
      : joints_(std::move(joints)), sender_(process, kMotionTexts.name, Blocking::kNo) {}

  /// Connected if a task plays motions.
  const AnySender& sender() const { return sender_; }
  /// Why the program cannot play the motion with the others, with the lines of its errors; empty: it can.
  std::string whyNot(const robotcontrol::MotionText& motion) const;
  /// Replaces or adds a motion, or takes one back whose text is empty, and sends the package.
  void set(const robotcontrol::MotionText& motion, Instant now);
  /// Replaces and adds all these motions, without a check, and sends the package.
  void add(const robotcontrol::MotionTexts& motions, Instant now);
  /// All motions, with `more` among them.
  robotcontrol::MotionTable table(const std::vector<robotcontrol::MotionText>& more = {}) const;

 private:
  const tl::expected<MotionLibrary, Errors>& library() const;
  void send(Instant now);

  const std::vector<std::string> joints_;
  Sender<robotcontrol::MotionTexts> sender_;
  mutable std::optional<tl::expected<MotionLibrary, Errors>> library_;
};

}  // namespace robotlink
