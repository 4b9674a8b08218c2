// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/truth/PackageErrors.h"
#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace robotcontrol {
class OracleWorld;
}
namespace robotlink {
struct FieldDescription;
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

/// Compares percepts and models of robots with the ground truth (oracle/world) of their simulation. Fed with
/// the debug queues of a run in which the packages and oracle/world are published; what comes before the
/// truth of its time waits for it.
///
/// A percept counts as missed if its object's center was in the image and nearer than 2 m, whatever stood in
/// front of it. What a model does not know counts as missed only while it could: within 2 m. While a robot is
/// penalized, as game/state says, it stands beside the field, and nothing is compared.
///
/// One thread at a time. Memory is bounded, however long it runs.
class TruthErrors {
 public:
  /// Keyed by the stream's path below the robot: "models/ball", or that of a shadow.
  using Packages = std::map<std::string, PackageErrors>;

  TruthErrors();
  ~TruthErrors();
  /// Without a field landmarks are not compared.
  void setField(std::shared_ptr<const robotlink::FieldDescription> field) { field_ = std::move(field); }

  /// The packages that are compared; their keys have to be on, and those of oracle/world and game/state.
  static const std::vector<std::string>& packages();

  void add(const std::string& robot, const robotlink::SharedDebugQueue& queue);
  /// One message of a robot, with its path below the robot's name and the time when it was published; what
  /// is neither truth nor compared is skipped.
  void add(const std::string& robot, const std::string& path, robotlink::Instant published,
           const robotlink::PackagePtr& value);
  /// Forgets everything, such as after a reset.
  void clear();
  /// Keyed by robot.
  const std::map<std::string, Packages>& errors() const { return errors_; }

 private:
  struct Waiting {
    std::string path;
    robotlink::Instant published;
    robotlink::PackagePtr value;
  };
  struct Robot {
    /// The newest last.
    std::deque<std::pair<robotlink::Instant, robotlink::PackagePtr>> truths;
    std::deque<Waiting> waiting;
    /// When the last penalty began, and when it was over.
    std::optional<robotlink::Instant> penalizedAt, playsAgainAt;
  };

  static void addGameState(Robot& robot, const robotlink::PackagePtr& value);
  static bool isPenalized(const Robot& robot, robotlink::Instant time);
  void compareWaiting(const std::string& name, Robot& robot);
  static const robotcontrol::OracleWorld* truthAt(const Robot& robot, robotlink::Instant time);
  void compare(const std::string& robot, const Waiting& one, robotlink::Instant time,
               const robotcontrol::OracleWorld& truth);

  std::shared_ptr<const robotlink::FieldDescription> field_ = nullptr;
  std::map<std::string, Robot> robots_;
  std::map<std::string, Packages> errors_;
};

}  // namespace app
