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

/// Records frames into log files, in a thread of its own: add() never waits. What waits to be written is
/// bounded by `queueBytes`; past that the frame with the largest message goes first (of equal ones the
/// newest), as a whole, and is counted; the counts are in the file, too. Keeps the last seconds in memory, on
/// request, to be saved. What holds until it is told anew (tables, parameters, colour tables, the scene,
/// set-ups of programs) is kept from the beginning and opens every file.
///
/// When a platform is set back (restart(), or a process whose time goes back) the recording goes on in a new
/// file, so that in each of them time goes on only forwards; what was kept in memory is forgotten. A disk
/// that is full ends the recording; status() says so, and the file is readable.
///
/// All functions from any thread.
class Recorder {
 public:
  struct Options {
    std::size_t queueBytes = 64U << 20U;
    std::size_t keptBytes = 256U << 20U;  ///< at most, of the last seconds
    std::filesystem::path folder;         ///< of files whose place was not chosen; made if need be
    std::string software = "robotcontrol";
    /// What a person should know: messages were dropped, a recording ended by itself. Called in threads of
    /// the recorder, which must not be called back.
    std::function<void(const std::string&)> warn;
  };
  explicit Recorder(Options options);
  ~Recorder();  ///< closes the file

  /// What one frame of one process told, complete, its FrameInfo last; or a message of no frame.
  void add(std::vector<robotlink::StreamMessage> frame);
  /// Another platform, or one that was set back: what was told before holds no more.
  void restart();
  /// What a robot told holds no more: its program starts anew.
  void forget(const std::string& robot);

  /// Whether what comes is new, as it is from robots and simulations; it is at first. What comes from a log
  /// is in a file already: it is recorded if a person wants that, but not kept in memory.
  void setLive(bool live);
  /// Something is recorded or kept in memory. While it is not, only what holds until told anew need be added.
  bool active() const;
  /// Messages of this stream are recorded, kept, or waited for as the trigger.
  bool wants(const std::string& path) const;
  /// Another number after whatever may have changed active() or wants().
  std::uint64_t demand() const;

  /// Where files go whose place was not chosen.
  void setFolder(const std::filesystem::path& folder);
  /// Starts, stops, saves, or sets what is recorded. Fails if that cannot be done; what fails later is in
  /// status(). STOP returns before all is written.
  robotlink::Result<void> control(const robotcontrol::ControlRecording& control);
  robotcontrol::RecordingStatus status() const;

  /// Waits until the queue is at most half full: for those who can, and want to lose nothing.
  void waitForRoom();
  /// Waits until all that was added and asked for before is done.
  void finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer
