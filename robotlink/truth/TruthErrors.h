// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"
#include "robotlink/truth/PackageErrors.h"

namespace robotlink {

struct FieldDescription;
struct SharedDebugQueue;

/// The source of a compared package: its stream and its solution.
struct ErrorSource {
  /// The stream's path below the robot: "models/ball", or that of a shadow, "shadow/kalman/models/ball".
  std::string path;
  /// The solution that published it; empty if the program does not say which one does.
  std::string solution;
  auto operator<=>(const ErrorSource&) const = default;
};

/// Compares percepts and models of robots with the ground truth (oracle/world, oracle/state) of their
/// simulation. Fed with the debug queues of a run in which these and the packages are published; what comes
/// before the truth of its time waits for it. The tables of solutions say which solution published a package,
/// so that each has errors of its own, though solutions are switched while it runs.
///
/// A percept counts as missed if its object's center was in the image and nearer than 2 m, whatever stood in
/// front of it. A thing that a model lacks counts as missed only within 2 m. While a robot is
/// penalized, as game/state says, it stands beside the field, and nothing is compared. See EventErrors for
/// what happens to its body.
///
/// One thread at a time. Memory is bounded, however long it runs.
class TruthErrors {
 public:
  using Packages = std::map<ErrorSource, PackageErrors>;

  TruthErrors();
  ~TruthErrors();
  /// Without a field landmarks are not compared.
  void setField(std::shared_ptr<const FieldDescription> field) { field_ = std::move(field); }

  /// The packages that are compared.
  static const std::vector<std::string>& packages();
  /// The packages whose keys have to be on: those, the truth, and game/state.
  static const std::vector<std::string>& neededPackages();
  /// Whether add() does anything with messages of this path below the robot's name.
  static bool reads(std::string_view path);
  /// The package of a stream: that of "shadow/kalman/models/ball" is models/ball. Empty if it is not
  /// compared.
  static std::string_view comparedPackage(std::string_view path);

  void add(const std::string& robot, const SharedDebugQueue& queue);
  /// Adds a message of a robot, with its path below the robot's name and the time when it was published;
  /// messages that are not needed are skipped.
  void add(const std::string& robot, const std::string& path, Instant published, const PackagePtr& value);
  /// Forgets everything, such as after a reset of the simulation.
  void clear();
  /// Forgets the errors, but nothing of what it needs for those to come.
  void clearErrors() { errors_.clear(); }
  /// Keyed by robot.
  const std::map<std::string, Packages>& errors() const { return errors_; }

 private:
  struct Waiting {
    std::string path;
    Instant published;
    PackagePtr value;
  };
  /// The solution that publishes a package, since when, and the one before.
  struct Active {
    std::string solution, before;
    Instant since;
  };
  /// The packages of one kind of truth, the newest last, and what waits for it.
  struct Truths {
    std::deque<std::pair<Instant, PackagePtr>> known;
    std::deque<Waiting> waiting;
  };
  struct Robot {
    /// Keyed by the package of the truth.
    std::map<std::string, Truths, std::less<>> truths;
    /// When the last penalty began, and when it was over.
    std::optional<Instant> penalizedAt, playsAgainAt;
    /// Keyed by package.
    std::map<std::string, Active, std::less<>> active;
  };

  static void addGameState(Robot& robot, const PackagePtr& value);
  static void addSolutions(Robot& robot, Instant time, const PackagePtr& value);
  static bool isPenalized(const Robot& robot, Instant time);
  static std::string solutionOf(const Robot& robot, const Waiting& one);
  void compareWaiting(const std::string& name, const Robot& robot, Truths& truths);
  static const google::protobuf::Message* truthAt(const Truths& truths, Instant time);
  void compare(const std::string& name, const Robot& robot, const Waiting& one, Instant time,
               const google::protobuf::Message& truth);

  std::shared_ptr<const FieldDescription> field_ = nullptr;
  std::map<std::string, Robot> robots_;
  std::map<std::string, Packages> errors_;
};

}  // namespace robotlink
