// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace app {

/// A run to be compared: `robotctl` with these arguments, which prints figures as JSON.
struct PlannedRun {
  /// The variant that is compared, such as a solution or a pair of teams.
  std::string variant;
  /// The subject it is tried on, "seed 3" or the name of a log. Variants are compared on the same subject.
  std::string subject;
  std::vector<std::string> arguments;
  /// Further inputs on which its result depends; see inputsOf().
  std::string inputs = {};
};

/// The files of runs in a folder: the request, the result, and the output meanwhile. A result
/// counts as long as its run and that run's inputs are still the same.
class RunFiles {
 public:
  /// Makes the folder. Fails if that is impossible.
  static robotlink::Result<RunFiles> in(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path result(const PlannedRun& run) const { return fileOf(run, ".json"); }
  /// Becomes the result when the run has ended well.
  std::filesystem::path unfinished(const PlannedRun& run) const { return fileOf(run, ".json.part"); }
  std::filesystem::path texts(const PlannedRun& run) const { return fileOf(run, ".txt"); }

  /// Whether there is a result of this very run.
  bool isDone(const PlannedRun& run) const;
  /// Call this before it is started: removes an older result. Fails if it cannot be written.
  robotlink::Result<void> prepare(const PlannedRun& run) const;
  /// Makes the files that it has written its result.
  robotlink::Result<void> finish(const PlannedRun& run) const;

 private:
  explicit RunFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path fileOf(const PlannedRun& run, const char* suffix) const;

  std::filesystem::path folder_;
};

/// A command line that a shell reads as these words.
std::string shellLine(const std::vector<std::string>& words);
/// A file by its whole path, since jobs run in other folders; the name of what is shipped as it is.
std::string wholePath(const std::string& name);

}  // namespace app
