// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/bookmarks/Bookmarks.h"
#include "robotlink/base/Error.h"
#include "widgets/log/LogModel.h"
#include "widgets/log/MessageDensity.h"

namespace widgets {

/// The contents of a log file, as far as they have been read: what a timeline and a list of streams show. All
/// times are the log's own, without any offset. A plain value; shared read-only between threads.
struct LogOverview {
  /// The stage of reading: the summary, the times of all messages, the text messages, the sizes; kDone:
  /// everything was read.
  enum class Stage : std::uint8_t { kOpening, kTimes, kTexts, kSizes, kDone };
  /// A stream of the log.
  struct Stream {
    /// "nao/camera/image"
    std::string path;
    /// Name of its schema: "foxglove.CompressedImage".
    std::string type;
    /// Number of messages.
    std::uint64_t count = 0;
    /// Sum of their sizes; 0: not counted yet.
    std::uint64_t bytes = 0;
    robotlink::Instant first, last;
    /// Encoding of the messages if it cannot be decoded (they are kept as bytes); else empty.
    std::string undecoded = {};
    /// Times of the messages; empty before Stage::kTexts.
    MessageDensity density = {};

    /// Mean rate between the first and the last message, Hz; 0 for less than two messages.
    double rate() const;
  };

  /// Path of the log.
  std::string file;
  Stage stage = Stage::kOpening;
  /// Progress of the stage, 0 to 1.
  double progress = 0;
  /// The reason why the file could not be opened; empty: it could.
  QString failure = {};
  /// Damage report in words; empty if the file is intact.
  QString damage = {};
  /// Whether the log, and so its bookmarks, cannot be written.
  bool readOnly = false;
  /// Whether the file has another format and was converted while reading, so that there is nothing to repair.
  bool converted = false;
  robotlink::Instant begin = {}, end = {};
  /// Names of the robots that were logged.
  std::vector<std::string> robots = {};
  /// Sorted by path.
  std::vector<Stream> streams = {};
  /// Warnings and errors, sorted by time.
  std::vector<LogEntry> said = {};
  /// Number of warnings and errors beyond the bound of `said`.
  std::uint64_t saidLeftOut = 0;
  /// All text messages up to a bound, sorted by time; null before they were read.
  std::shared_ptr<const std::vector<LogEntry>> texts = {};

  /// Null if there is none.
  const Stream* find(const std::string& path) const;
  /// Paths of the streams of images that are not empty, those of cameras first.
  std::vector<std::string> imageStreams() const;
  /// "counting sizes: 40 %", translated; empty when everything was read or the file could not be opened.
  QString stageText() const;
};

/// A small version of one image of a log.
struct LogThumbnail {
  /// The time that was requested; the image is the newest one not later.
  robotlink::Instant time;
  /// Null: there is no such image.
  QImage image;
};

/// Interface of what reads a log file for the GUI. All functions are called in the GUI thread and return at
/// once; the reading is done elsewhere. Implemented by LogReader; tests implement their own.
class LogReading {
 public:
  virtual ~LogReading() = default;
  /// The overview read so far, never null; another object whenever something was added.
  virtual std::shared_ptr<const LogOverview> overview() = 0;
  /// Requests thumbnails of a stream, most urgent first; replaces earlier requests that have not been served.
  /// `height` in pixels.
  virtual void wantThumbnails(const std::string& stream, std::vector<robotlink::Instant> times,
                              int height) = 0;
  /// Removes and returns the thumbnails that were read since the last call.
  virtual std::vector<LogThumbnail> takeThumbnails() = 0;
  /// Returns the bookmarks, or why they cannot be read, once; unset before and after. The caller owns them
  /// from then on.
  virtual std::optional<robotlink::Result<logplayer::Bookmarks>> takeBookmarks() = 0;
};
/// Starts reading a file.
using ReadLog = std::function<std::unique_ptr<LogReading>(const std::filesystem::path&)>;

}  // namespace widgets
