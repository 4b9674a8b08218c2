// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/base/Worker.h"
#include "robotlink/session/HistoryArchive.h"
#include "widgets/TypedStreams.h"
#include "widgets/log/LogOverview.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// The parts of live robots' history that a timeline shows in addition to values: small images, warnings and
/// errors, of what is in memory and on disk. Images are made, and files read, in a thread, a few at a time.
/// Nothing is done but in tick(). GUI thread; the session must outlive it.
class HistoryStrips {
 public:
  /// The contents of the strip of a robot.
  struct Strip {
    /// The stream whose images are shown; empty: there is none.
    std::string imageStream = {};
    /// Keyed by the times for which they were requested; null where there is no image.
    std::map<robotlink::Instant, QImage> thumbnails = {};
    /// Sorted by time; null: the robot publishes no texts.
    std::shared_ptr<const std::vector<LogEntry>> said = {};
  };
  /// The maximum numbers of images and texts; beyond them all images, or the oldest texts, are dropped.
  static constexpr std::size_t kMaxThumbnails = 600, kMaxSaid = 5000;
  /// Once in this many ticks, a limited number of images and of files with texts is begun.
  static constexpr int kEvery = 6;
  static constexpr std::size_t kImagesAtOnce = 4, kPiecesAtOnce = 8;

  explicit HistoryStrips(robotlink::Session& session);

  /// Takes what was made and what has arrived, and begins more. Call this while it is shown.
  void tick();
  const Strip& of(const std::string& robot) { return robots_[robot].strip; }
  /// Sets which images of a robot are to be made, in place of those that were to be made; `height` in pixels.
  void want(const std::string& robot, std::vector<robotlink::Instant> times, int height);

 private:
  using Piece = robotlink::HistoryArchive::Piece;
  struct Robot {
    Strip strip;
    std::vector<robotlink::Instant> wanted;
    std::map<std::string, StreamCursor> cursors;
  };
  /// An image that is to be made.
  struct Picture {
    std::string robot;
    robotlink::Instant time;
    std::string stream;
    /// The message; null: it is the newest one in the piece that is not later.
    robotlink::PackagePtr value = {};
    Piece piece = {};
  };
  struct Job {
    std::uint64_t epoch = 0;
    int height = 0;
    std::vector<Picture> pictures;
    /// The pieces whose texts are read, and the streams with the texts.
    std::vector<Piece> pieces;
    std::vector<std::string> streams;
  };
  struct Made {
    std::uint64_t epoch = 0;
    std::vector<std::pair<std::string, LogThumbnail>> thumbnails = {};
    std::vector<LogEntry> texts = {};
  };

  static Made make(const Job& job, const std::stop_token& stop);
  /// Forgets all after a restart, or if the clock was set back.
  void followSession();
  /// Chooses the streams of images, if there are other streams or robots than before.
  void findImages();
  void takeMade();
  /// Takes texts that have arrived, and finds out what of them is only on disk.
  void takeTexts();
  void addTexts(const std::vector<LogEntry>& texts);
  /// The next images to read; empty: none.
  std::vector<Picture> nextPictures();
  /// The image of a robot at a time; unset: there is none.
  std::optional<Picture> find(const std::string& robot, robotlink::Instant time) const;

  robotlink::Session& session_;
  std::map<std::string, Robot> robots_;
  /// The store's list of streams, and the robots, when streams of images were chosen.
  std::pair<std::uint64_t, std::vector<std::string>> listed_{};
  int height_ = 1;
  int ticks_ = 0;
  std::uint64_t generation_ = 0;
  /// Counts restarts, so that what was begun before one is not taken behind it.
  std::uint64_t epoch_ = 0;
  /// All texts up to here were taken, or are to be read.
  robotlink::Instant knownTo_ = robotlink::Instant::min();
  std::deque<Piece> unread_;
  robotlink::Worker<Job, Made> worker_;
};

}  // namespace widgets
