// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "widgets/models/LogOverview.h"

namespace logplayer {
class LogFile;
}

namespace widgets {

/// Reads a log file in two threads: one goes over it once, from what is shown first to what costs most
/// (streams and times, warnings and errors, bookmarks, sizes); the other reads small pictures of its images
/// as they are wanted. The destructor ends both; it waits for at most one read.
class LogReader final : public LogReading {
 public:
  explicit LogReader(std::filesystem::path file);
  ~LogReader() override;
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;

  std::shared_ptr<const LogOverview> overview() override;
  void wantThumbnails(const std::string& stream, std::vector<robotlink::Instant> times, int height) override;
  std::vector<Thumbnail> takeThumbnails() override;
  std::optional<robotlink::Result<logplayer::Bookmarks>> takeBookmarks() override;

 private:
  struct Wanted {
    std::string stream;
    std::vector<robotlink::Instant> times;  // most urgent last
    int height = 0;
  };

  void readAll();
  bool open(LogOverview& overview);
  void readTimes(LogOverview& overview);
  void readTexts(LogOverview& overview);
  void readBookmarks();
  void countSizes(LogOverview& overview);
  void publish(const LogOverview& overview);
  bool tell(LogOverview& overview, double share);

  void readThumbnails();
  QImage thumbnail(const std::string& stream, robotlink::Instant time, int height);

  const std::filesystem::path file_;
  std::atomic<bool> quit_{false};

  std::mutex mutex_;  // protects all that follows
  std::condition_variable wakeUp_;
  std::shared_ptr<logplayer::LogFile> log_;  // null until it is open
  std::shared_ptr<const LogOverview> overview_;
  std::optional<robotlink::Result<logplayer::Bookmarks>> bookmarks_;
  Wanted wanted_;
  std::vector<Thumbnail> thumbnails_;

  std::thread overviewThread_, thumbnailThread_;
};

/// Starts reading a file: what ReadLog is but in tests.
std::unique_ptr<LogReading> readLogFile(const std::filesystem::path& file);

}  // namespace widgets
