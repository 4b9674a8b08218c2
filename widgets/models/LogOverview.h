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

#include "logplayer/Bookmarks.h"
#include "robotlink/base/Error.h"
#include "widgets/models/LogModel.h"
#include "widgets/models/MessageDensity.h"

namespace widgets {

/// What a log file holds, as much of it as was read so far: what a time line and a list of streams show. All
/// times are the log's own, without any offset. A plain value; shared read-only between threads.
struct LogOverview {
  enum class Stage : std::uint8_t { kOpening, kTimes, kTexts, kSizes, kDone };
  struct Stream {
    std::string path;  ///< "nao/camera/image"
    std::string type;  ///< its schema: "foxglove.CompressedImage"
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;  ///< 0: not yet counted
    robotlink::Instant first, last;
    std::string undecoded = {};   ///< the encoding of its messages, if that is not read; they stay bytes
    MessageDensity density = {};  ///< empty until Stage::kTexts

    /// Messages a second between its first and last; 0 for less than two.
    double rate() const;
  };

  std::string file;
  Stage stage = Stage::kOpening;
  double progress = 0;   ///< of the stage, 0 to 1
  QString failure = {};  ///< why the file could not be opened
  QString damage = {};   ///< what was lost, in words; empty if the file is whole
  bool readOnly = false;
  bool converted = false;  ///< is of an older format, so there is nothing to repair
  robotlink::Instant begin = {}, end = {};
  std::vector<std::string> robots = {};
  std::vector<Stream> streams = {};  ///< by path
  std::vector<LogEntry> said = {};   ///< warnings and errors, by time
  std::uint64_t saidLeftOut = 0;     ///< because there were too many
  std::shared_ptr<const std::vector<LogEntry>> texts =
      {};  ///< all of them, by time, up to a bound; null until they were read

  const Stream* find(const std::string& path) const;
  /// Paths of the streams of images; cameras first.
  std::vector<std::string> imageStreams() const;
  /// "reading the sizes: 40 %"; empty when all is read.
  QString stageText() const;
};

/// A small picture of one image of a log.
struct Thumbnail {
  robotlink::Instant time;  ///< that was asked for; the image is the newest not later
  QImage image;             ///< null: there is none
};

/// Reads a log file for the GUI, which calls all of these and never waits.
class LogReading {
 public:
  virtual ~LogReading() = default;
  /// As far as it is known; another object whenever there is news.
  virtual std::shared_ptr<const LogOverview> overview() = 0;
  /// What is wanted now, most urgent first; what was wanted before and is not yet there is given up.
  virtual void wantThumbnails(const std::string& stream, std::vector<robotlink::Instant> times,
                              int height) = 0;
  /// Those that came since the last call.
  virtual std::vector<Thumbnail> takeThumbnails() = 0;
  /// Once, when they were read; the caller goes on with them.
  virtual std::optional<robotlink::Result<logplayer::Bookmarks>> takeBookmarks() = 0;
};
/// Starts reading a file.
using ReadLog = std::function<std::unique_ptr<LogReading>(const std::filesystem::path&)>;

}  // namespace widgets
