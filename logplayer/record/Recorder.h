// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// Records frames into log files in a thread of its own, so that add() never waits for the disk. The queue is
/// bounded by `queueBytes`; when it is full, the frame with the largest message (of several the newest) is
/// dropped as a whole. Dropped messages are counted; the counts are also written to the file. On request the
/// last seconds are kept in memory, to be saved later. Latched messages (tables, parameters, color tables,
/// the scene, setups of programs) are collected from the beginning and open every file.
///
/// When a platform is reset (restart(), or the time of a process goes back), the recording continues in a new
/// file, so that time increases monotonically in each file, and the seconds in memory are discarded. A full
/// disk ends the recording: status() reports it, and the file remains readable.
///
/// All functions may be called from any thread.
class Recorder {
 public:
  /// Fixed settings of a recorder.
  struct Options {
    /// Maximum size of the frames that wait to be written.
    std::size_t queueBytes = 64U << 20U;
    /// Maximum size of the seconds that are kept in memory.
    std::size_t keptBytes = 256U << 20U;
    /// Folder of files without an explicit path; created if necessary.
    std::filesystem::path folder;
    /// The name that is written into the files.
    std::string software = "robotcontrol";
    /// Called with messages for the user: messages were dropped, a recording ended by itself. Runs in the
    /// threads of the recorder and must not call it.
    std::function<void(const std::string&)> warn;
  };
  explicit Recorder(Options options);
  /// Ends the recording and waits until the file is closed.
  ~Recorder();

  /// Records a complete frame of one process, its FrameInfo last, or a message outside of frames.
  void add(std::vector<robotlink::StreamMessage> frame);
  /// Call this when another platform is loaded or the platform is reset: discards all latched messages.
  void restart();
  /// Call this when a robot's program is restarted: discards its latched messages.
  void forget(const std::string& robot);

  /// Sets whether added messages are new, as from robots and simulations; at first they are. Those of a log
  /// are in a file already: they are recorded if the user wants that, but not kept in memory.
  void setLive(bool live);
  /// Whether something is recorded or kept in memory. If not, only latched messages need be added.
  bool active() const;
  /// Whether messages of this stream are recorded, kept in memory, or are the trigger for saving.
  bool wants(const std::string& path) const;
  /// Changes its value whenever the results of active() or wants() may have changed, so that callers can
  /// cache them.
  std::uint64_t demand() const;

  /// Sets the folder of files without an explicit path.
  void setFolder(const std::filesystem::path& folder);
  /// Changes the settings, then starts, stops or saves. Fails if that is impossible; later failures are
  /// reported by status(). STOP returns before everything is written, see finish().
  robotlink::Result<void> control(const robotcontrol::ControlRecording& control);
  /// A snapshot of settings and progress.
  robotcontrol::RecordingStatus status() const;

  /// Blocks until the queue is at most half full; for producers that can wait and must not lose messages.
  void waitForRoom();
  /// Blocks until everything that was added and requested before is done.
  void finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer
