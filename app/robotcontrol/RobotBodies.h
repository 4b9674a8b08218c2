// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>
#include <map>
#include <memory>
#include <string>
#include <utility>

class QColor;

namespace widgets {
struct RobotBody;
}

namespace app {

/// The bodies of kinds of robots, from the shipped model files of the simulator; each is read when it is
/// needed first, which takes some 100 ms. GUI thread.
class RobotBodies {
 public:
  /// `kind`: the name of the robot's description ("ers210"). Null if there is no model of that name, or if it
  /// cannot be read.
  std::shared_ptr<const widgets::RobotBody> of(const std::string& kind, const QColor& team);

 private:
  /// Keyed by kind and color.
  std::map<std::pair<std::string, QRgb>, std::shared_ptr<const widgets::RobotBody>> bodies_;
};

}  // namespace app
