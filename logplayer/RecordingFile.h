// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "logplayer/LogWriter.h"
#include "logplayer/RecordedFrame.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// A log file that is being recorded: begins with what held before, codes images as wished, ends with what
/// became of the recording. One thread at a time.
class RecordingFile {
 public:
  using ImageCoding = robotcontrol::ControlRecording::ImageCoding;
  using Compression = robotcontrol::ControlRecording::Compression;
  struct Options {
    ImageCoding imageCoding = robotcontrol::ControlRecording::AS_IS;
    Compression compression = robotcontrol::ControlRecording::NONE;
    std::string software;
  };

  /// The file must not exist.
  static robotlink::Result<std::unique_ptr<RecordingFile>> create(const std::filesystem::path& path,
                                                                  const Options& options);

  const std::filesystem::path& path() const { return path_; }
  /// What held before the first frame; it gets that frame's time, so that the log does not begin earlier.
  void beginWith(std::vector<robotlink::StreamMessage> held) { held_ = std::move(held); }
  robotlink::Result<void> write(const RecordedFrame& frame);
  /// Hands to the operating system what has waited long enough: to be called several times a second.
  robotlink::Result<void> tick() { return writer_->container().tick(); }
  robotlink::Result<void> close(const DroppedMessages& dropped);

  std::uint64_t messages() const { return messages_; }
  std::uint64_t bytes() const { return writer_->container().bytesWritten(); }

 private:
  RecordingFile(std::filesystem::path path, Options options, std::unique_ptr<LogWriter> writer);
  robotlink::Result<void> writeHeld(robotlink::Instant time);
  robotlink::StreamMessage coded(const robotlink::StreamMessage& message) const;

  std::filesystem::path path_;
  Options options_;
  std::unique_ptr<LogWriter> writer_;
  std::vector<robotlink::StreamMessage> held_;
  std::string started_;  // real time, ISO 8601
  std::uint64_t messages_ = 0;
};

/// A file that does not exist yet: `wished`; if that is a folder, or nothing,
/// "robotcontrol-YYYYMMDD-HHMMSS.mcap" in it, or in `folder`, which is made.
robotlink::Result<std::filesystem::path> newRecordingPath(const std::filesystem::path& wished,
                                                          const std::filesystem::path& folder);
/// "game.mcap" gives "game-2.mcap", the first number that is free: where a recording goes on.
std::filesystem::path nextRecordingPath(const std::filesystem::path& before);

}  // namespace logplayer
