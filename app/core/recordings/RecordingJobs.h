// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/core/recordings/JobQueue.h"
#include "app/core/recordings/RecordingFetch.h"

namespace app {

/// Executes a user's jobs on the recordings of a robot, in threads that wait for the robot: fetching in one,
/// everything else in another, so that a recording can be stopped while another one is fetched. Results wait
/// here until they are looked at. One thread uses it; what `call` uses must outlive it.
class RecordingJobs {
 public:
  enum class Kind { kList, kStart, kStop, kFetch, kRemove };
  /// The outcome of a job. A plain value.
  struct Outcome {
    Kind kind;
    /// The recording; empty if it is of none.
    std::string name;
    /// The file to which it was fetched.
    std::filesystem::path file = {};
    RecordingFetch::Fetched fetched = {};
    /// Unset: done. The id "canceled" is that of a fetch that the user canceled.
    std::optional<robotlink::Error> error = {};
  };
  /// The fetch in progress.
  struct Progress {
    std::string name;
    double share = 0;
  };

  explicit RecordingJobs(RecordingFetch::Call call);
  /// Cancels what is in progress; takes some tenths of a second then.
  ~RecordingJobs();
  RecordingJobs(const RecordingJobs&) = delete;
  RecordingJobs& operator=(const RecordingJobs&) = delete;

  /// Asks the robot for its recordings, unless this is in progress. All but fetch() end with this.
  void list();
  /// Begins or ends a recording at the robot.
  void start();
  void stop();
  /// Deletes a recording at the robot.
  void remove(const std::string& name);
  /// See RecordingFetch::fetch(); waits for earlier fetches.
  void fetch(const std::string& name, const std::filesystem::path& file, bool replaces);
  /// Ends the fetch in progress, and drops those that wait. The next one continues where this one is.
  void cancel();

  /// The recordings that the robot had when it was last asked; unset before it has answered.
  std::optional<std::vector<RecordingFetch::Entry>> recordings() const;
  std::optional<Progress> fetching() const;
  /// Removes and returns the outcomes of the jobs that are done; those of lists only if they failed.
  std::vector<Outcome> takeOutcomes();

 private:
  using Action = std::function<robotlink::Result<void>(RecordingFetch&, const RecordingFetch::Progress&)>;
  void act(Kind kind, const std::string& name, const Action& action);
  void fetchNow(const std::string& name, const std::filesystem::path& file, bool replaces,
                std::uint64_t generation);
  void publish(Outcome outcome);

  const RecordingFetch::Call call_;
  std::atomic<bool> isEnding_ = false, isListing_ = false;
  /// Increased by cancel(); fetches of an older one end.
  std::atomic<std::uint64_t> generation_ = 0;
  /// Protects the following members.
  mutable std::mutex mutex_;
  std::optional<std::vector<RecordingFetch::Entry>> recordings_;
  std::optional<Progress> fetching_;
  std::vector<Outcome> outcomes_;
  /// The last members, since their threads use the others.
  JobQueue quick_, fetches_;
};

}  // namespace app
