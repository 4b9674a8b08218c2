// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

#include "robotlink/base/Worker.h"
#include "robotlink/session/StreamMessage.h"
#include "widgets/log/LogOverview.h"

namespace foxglove {
class Log;
}
namespace logplayer {
class LogFile;
}

namespace widgets {

/// Reads a log file in two threads. One goes over the file once, beginning with what is needed first
/// (streams, times, bookmarks, text messages, sizes) and publishes an overview after each step; the other
/// reads thumbnails of the images as they are requested. Overviews are immutable and shared. The public
/// functions are called by one thread and do not block. The destructor ends both threads; it waits for at
/// most one read.
class LogReader final : public LogReading {
 public:
  /// Begins at once; the file is opened in the thread.
  explicit LogReader(std::filesystem::path file);
  ~LogReader() override;
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;

  std::shared_ptr<const LogOverview> overview() override;
  void wantThumbnails(const std::string& stream, std::vector<robotlink::Instant> times, int height) override;
  std::vector<LogThumbnail> takeThumbnails() override;
  std::optional<robotlink::Result<logplayer::Bookmarks>> takeBookmarks() override;

 private:
  /// The thumbnails that are requested.
  struct Wanted {
    std::string stream;
    /// The instants, the most urgent first.
    std::vector<robotlink::Instant> times;
    /// Pixels.
    int height = 0;
  };

  /// Makes the overview, in one thread; the next functions are its steps.
  void readAll();
  /// False: the file cannot be opened.
  bool open(LogOverview& overview);
  void readTimes(LogOverview& overview);
  void readTexts(LogOverview& overview);
  void readBookmarks();
  void countSizes(LogOverview& overview);
  /// Makes a copy available to overview().
  void publish(const LogOverview& overview);
  /// Publishes the progress, at most ten times per step. False: the reader is being destroyed.
  bool report(LogOverview& overview, double share);

  /// Reads thumbnails, in the other thread.
  void readThumbnails(const Wanted& wanted, const std::stop_token& stop);
  /// Null: there is no image or it cannot be decoded.
  QImage thumbnail(const std::string& stream, robotlink::Instant time, int height);

  const std::filesystem::path file_;
  /// Says that the reader is being destroyed. Used by the thread that makes the overview only.
  std::stop_token stop_;

  /// Protects all following members but the threads. log_ is set once; the threads use it afterward without
  /// the mutex.
  std::mutex mutex_;
  /// Null until it is open.
  std::shared_ptr<logplayer::LogFile> log_;
  std::shared_ptr<const LogOverview> overview_;
  std::optional<robotlink::Result<logplayer::Bookmarks>> bookmarks_;
  Wanted wanted_;
  std::vector<LogThumbnail> thumbnails_;

  /// Reads what is requested once log_ is open.
  robotlink::Worker<Wanted> thumbnailWorker_;
  /// Has one job. Last, since it uses all others.
  robotlink::Worker<std::monostate> overviewWorker_;
};

/// A text message of a robot.
LogEntry loggedEntry(const robotlink::StreamMessage& message, const foxglove::Log& log);
/// A small picture of an image, compressed or not; null: it is none, or cannot be decoded. `height` in
/// pixels. Any thread.
QImage thumbnailOf(const robotlink::PackagePtr& value, int height);

/// The ReadLog that is used outside of tests.
std::unique_ptr<LogReading> readLogFile(const std::filesystem::path& file);

}  // namespace widgets
