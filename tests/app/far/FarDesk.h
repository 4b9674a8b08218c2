// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "robotlink/session/Session.h"
#include "tests/app/far/FarRobot.h"
#include "tests/app/window/RemoteDesk.h"

namespace app::test {

/// The desk of somebody who works with a remote robot by mouse and keyboard. Functions that wait return
/// false, or what is missing, if it does not come.
class FarDesk : public RemoteDesk {
 public:
  using RemoteDesk::RemoteDesk;

  /// Connects to a robot that this person has never seen: compares its fingerprint with what it has printed,
  /// trusts it, and enters its token. Returns what went wrong; empty: nothing.
  QString meet(const FarRobot& robot);
  /// Brings a view to the front.
  void show(const char* view);
  /// Switches a key on or off in the view of debug keys.
  bool switchKey(const QString& group, const QString& key);
  /// Clicks a solution in the view of solutions, and waits until the robot has switched.
  bool choose(const std::string& task, const std::string& solution);
  using RemoteDesk::choose;
  /// Clicks "Take over" in the motion tester, and waits until the robot obeys.
  bool takeOver();
  /// Holds a key down on the pad of the motion tester, and lets it go.
  void hold(Qt::Key key);
  void release(Qt::Key key);

  /// What is known of the line to the robot.
  const robotlink::RemoteRobot& line();
  /// Where the simulated robot was in the world since an instant, in order of time.
  std::vector<robotlink::Vector3> track(robotlink::Instant since);
  /// How far it moved in the last 0.4 s of its time, m; nothing while less is known.
  std::optional<double> moved();
  bool walks() { return moved().value_or(0) > 0.02; }
  bool stands() { return moved().value_or(1) < 0.004; }
};

}  // namespace app::test
