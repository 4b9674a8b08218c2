// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// Records frames into log files, in a thread of its own: add() never waits. What waits to be written is
/// bounded by `queueBytes`; past that the frame with the largest message goes first (of equal ones the
/// newest), as a whole, and is counted; the counts are in the file, too. Keeps the last seconds in memory, on
/// request, for saveLast(). What holds until it is told anew (tables, parameters, colour tables, the scene,
/// set-ups of programs) is kept from the beginning and opens every file.
///
/// All functions from any thread.
class Recorder {
 public:
  struct Options {
    std::size_t queueBytes = 64U << 20U;
    std::size_t keptBytes = 256U << 20U;  ///< at most, of the last seconds
  };
  explicit Recorder(Options options);
  ~Recorder();  ///< closes the file

  /// What one frame of one process told, complete.
  void add(std::vector<robotlink::StreamMessage> frame);

  /// Starts, stops, saves, or sets what is recorded.
  robotlink::Result<void> control(const robotcontrol::ControlRecording& control);
  robotcontrol::RecordingStatus status() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer
