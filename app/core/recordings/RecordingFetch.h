// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/core/recordings/PendingAnswer.h"
#include "robotlink/base/Error.h"

namespace robotlink::websocket {
class Client;
}

namespace app {

/// Fetches recordings from a robot that offers RecordingServices. All functions block; one thread at a time.
class RecordingFetch {
 public:
  using Answer = robotlink::Result<std::string>;
  /// Calls are repeated after errors of the line.
  using Call = ServiceCall;
  /// Called several times a second with the share that is done, 0 to 1; returns false to cancel.
  using Progress = std::function<bool(double share)>;
  struct Entry {
    std::string name;
    std::uint64_t bytes = 0;
    /// In seconds since 1970.
    double modified = 0;
    /// Whether it is being recorded.
    bool isRecording = false;
    /// Whether it was ended as it should be, rather than cut off by a crash.
    bool isWhole = true;
  };
  struct Fetched {
    std::uint64_t bytes = 0;
    /// The number of bytes that were there from an earlier try.
    std::uint64_t resumedAt = 0;
  };

  /// `patience`: how long nothing may come before it fails.
  explicit RecordingFetch(Call call, std::chrono::milliseconds patience = std::chrono::seconds(30));

  /// Returns the robot's recordings, the newest first; without those whose names are not plain file names.
  robotlink::Result<std::vector<Entry>> list(const Progress& progress = {});
  /// Writes a recording to `file`, which must not exist unless `replaces`. Until it is whole and its checksum
  /// fits, it is `file`.part, from which a later call continues after a cut, a cancel (error "canceled") or
  /// a crash. One that is still being recorded is fetched as far as it goes now.
  robotlink::Result<Fetched> fetch(const std::string& name, const std::filesystem::path& file, bool replaces,
                                   const Progress& progress = {});
  /// Begins and ends a recording at the robot.
  robotlink::Result<void> start(const Progress& progress = {});
  robotlink::Result<void> stop(const Progress& progress = {});
  /// Deletes it at the robot.
  robotlink::Result<void> remove(const std::string& name, const Progress& progress = {});

 private:
  struct Part;
  struct Checksum {
    std::uint64_t bytes = 0;
    std::uint32_t crc = 0;
  };
  /// Calls until the robot answers.
  Answer ask(const std::string& service, const std::string& argument, const Progress& progress, double share);
  robotlink::Result<Checksum> check(const std::string& name, std::uint64_t bytes, const Progress& progress,
                                    double share);
  /// Keeps of an earlier try what is the same at the robot.
  robotlink::Result<void> resume(const std::string& name, Part& part, const Progress& progress);
  robotlink::Result<void> read(const std::string& name, Part& part, std::uint64_t bytes,
                               const Progress& progress);

  const Call call_;
  const std::chrono::milliseconds patience_;
};

/// The services of a client's server. The client must outlive what it returns.
RecordingFetch::Call callsOf(robotlink::websocket::Client& client);

}  // namespace app
