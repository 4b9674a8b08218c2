// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "logplayer/base/LogWriter.h"
#include "logplayer/record/RecordedFrame.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// A log file that is being recorded: begins with the latched messages, encodes images as requested, and ends
/// with a report on dropped messages. One thread at a time.
class RecordingFile {
 public:
  using ImageCoding = robotcontrol::ControlRecording::ImageCoding;
  using Compression = robotcontrol::ControlRecording::Compression;
  /// The format of the file.
  struct Options {
    ImageCoding imageCoding = robotcontrol::ControlRecording::AS_IS;
    Compression compression = robotcontrol::ControlRecording::NONE;
    /// The name that is written into the file.
    std::string software;
  };

  /// The file must not exist.
  static robotlink::Result<std::unique_ptr<RecordingFile>> create(const std::filesystem::path& path,
                                                                  const Options& options);

  const std::filesystem::path& path() const { return path_; }
  /// Sets the latched messages. They are written with the first frame and get its time, so that the log does
  /// not begin earlier.
  void beginWith(std::vector<robotlink::StreamMessage> held) { held_ = std::move(held); }
  /// Fails with the first I/O error; what was written before remains readable.
  robotlink::Result<void> write(const RecordedFrame& frame);
  /// Writes chunks that are old enough; call this several times a second.
  robotlink::Result<void> tick() { return writer_->container().tick(); }
  /// Writes the report and the summary. `dropped`: the messages that were dropped during this recording.
  robotlink::Result<void> close(const DroppedMessages& dropped);

  /// Number of messages written.
  std::uint64_t messages() const { return messages_; }
  std::uint64_t bytes() const { return writer_->container().bytesWritten(); }

 private:
  RecordingFile(std::filesystem::path path, Options options, std::unique_ptr<LogWriter> writer);
  /// Writes the latched messages at this time.
  robotlink::Result<void> writeHeld(robotlink::Instant time);
  /// Encodes a raw image as requested; other messages are returned unchanged.
  robotlink::StreamMessage coded(const robotlink::StreamMessage& message) const;

  std::filesystem::path path_;
  Options options_;
  std::unique_ptr<LogWriter> writer_;
  std::vector<robotlink::StreamMessage> held_;
  /// Real time of the creation, ISO 8601.
  std::string started_;
  std::uint64_t messages_ = 0;
};

/// Chooses the path of a new recording: `wished`, if it is a file name; if it is a folder,
/// "robotcontrol-YYYYMMDD-HHMMSS.mcap" in it; if it is empty, the same in `folder`, which is created.
/// Generated names do not exist yet.
robotlink::Result<std::filesystem::path> newRecordingPath(const std::filesystem::path& requested,
                                                          const std::filesystem::path& folder);
/// The path at which a recording continues: "game.mcap" yields "game-2.mcap", with the first number that is
/// free.
std::filesystem::path nextRecordingPath(const std::filesystem::path& before);

}  // namespace logplayer
