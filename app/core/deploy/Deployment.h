// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/core/deploy/RobotSet.h"
#include "app/core/recordings/PendingAnswer.h"
#include "robotlink/base/Error.h"

namespace app {

/// A file that a robot should have. A plain value.
struct DeployFile {
  /// In the robot's resource folder: "layouts/compact.yaml".
  std::string path;
  /// The path on this computer.
  std::filesystem::path source;
  std::string contents, sha256;
};

/// The files that a robot of a set should have; `folder` is that of the set's file. Fails with all files that
/// cannot be read, are not a layout or color table, or that robots do not accept.
tl::expected<std::vector<DeployFile>, robotlink::Errors> filesFor(const RobotSet::Robot& robot,
                                                                  const std::filesystem::path& folder);

/// The state of a file at a robot, compared with the local one.
struct DeployDifference {
  enum class State {
    kSame,
    kDiffers,
    kMissing,
    kWaiting,  ///< the same, but the robot's program has not read it yet: it does when it starts again
  };
  std::string path;
  State state = State::kSame;
  bool operator==(const DeployDifference&) const = default;
};

/// Compares and sends files to a robot that offers DeployServices. All functions block; one thread at a time.
class Deployment {
 public:
  /// Called several times a second with the share that is done, 0 to 1; returns false to cancel.
  using Progress = std::function<bool(double share)>;

  /// `robot` is its name there, by which it is known what its program has read; empty: that is not asked.
  explicit Deployment(ServiceCall call, std::string robot = {})
      : call_(std::move(call)), robot_(std::move(robot)) {}

  /// Returns one difference for each file, in their order.
  robotlink::Result<std::vector<DeployDifference>> check(const std::vector<DeployFile>& files,
                                                         const Progress& progress = {});
  /// Sends what differs, and checks again; fails if something differs still.
  robotlink::Result<std::vector<DeployDifference>> send(const std::vector<DeployFile>& files,
                                                        const Progress& progress = {});
  /// Restarts the robot's program, in the layout among the files, if it has not read some of them, and
  /// checks again. The robot stands still meanwhile.
  robotlink::Result<std::vector<DeployDifference>> restart(const std::vector<DeployFile>& files,
                                                           const Progress& progress = {});

 private:
  PendingAnswer::Answer ask(const std::string& service, const std::string& argument, const Progress& progress,
                            double share);

  const ServiceCall call_;
  const std::string robot_;
};

/// Whether the robot's program has to be started again so that all files take effect.
bool needsRestart(const std::vector<DeployDifference>& differences);

/// "2 of 14 files differ: layouts/compact.yaml differs, motions/sit.mof is missing".
std::string describe(const std::vector<DeployDifference>& differences);

}  // namespace app
