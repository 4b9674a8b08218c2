// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "colortool/image/ColorCorrection.h"
#include "colortool/training/Suspicion.h"
#include "robotlink/base/Worker.h"
#include "robotlink/session/StreamMessage.h"

namespace foxglove {
class RawImage;
}

namespace widgets {

/// An image with suspicious pixels.
struct SuspiciousFrame {
  /// The time on the session's timeline.
  robotlink::Instant time;
  /// Score and pixel counts.
  colortool::Suspicion found;
  /// 54 pixels high.
  QImage thumbnail;
};

/// Images in a log file.
struct LoggedImages {
  std::filesystem::path log;
  /// Path of the stream in the log.
  std::string stream;
  /// Added to the log's times to get times of the timeline.
  robotlink::Duration offset{0};
  bool operator==(const LoggedImages&) const = default;
};
/// The image of a message, decoded if it is compressed; null if it has none that can be decoded.
std::shared_ptr<const foxglove::RawImage> rawImageIn(const robotlink::StreamMessage& message);

/// Images in the session's history.
using KeptImages = std::vector<robotlink::StreamMessage>;

/// The input of a search. Cheap to copy, except for a history.
struct FrameQuery {
  std::variant<LoggedImages, KeptImages> images;
  std::shared_ptr<const colortool::ColorTable> table;
  /// Indexed by ColorTable::cellOf; null: unknown.
  std::shared_ptr<const std::vector<std::uint8_t>> margins;
  /// Whether pixels of a class can be suspicious, indexed by class number.
  std::vector<bool> things;
  /// The correction of the camera's colors.
  colortool::ColorCorrection correction = {};
  colortool::SuspicionOptions options = {};
};

/// Goes through all images of a stream in a thread of its own, as fast as they can be decoded, and returns
/// those with suspicious pixels as it finds them, but no more than kMaxKept, the worst ones. The other
/// functions: one thread. The destructor gives up, and waits for the image in hand.
class FrameSearch {
 public:
  static constexpr std::size_t kMaxKept = 500;

  /// Begins at once. `news` is called in the search's thread whenever progress or results changed; it must
  /// not block.
  FrameSearch(FrameQuery query, std::function<void()> news);
  ~FrameSearch();
  FrameSearch(const FrameSearch&) = delete;
  FrameSearch& operator=(const FrameSearch&) = delete;

  /// Ends the search; what was found can still be taken.
  void cancel() { worker_.cancel(); }
  /// The frames found since the last call, in the order of the stream.
  std::vector<SuspiciousFrame> take();

  /// The progress of the search.
  struct Progress {
    /// Images that were examined.
    std::uint64_t seen = 0;
    /// The number of images with suspicious pixels, including those that were not kept.
    std::uint64_t suspicious = 0;
    /// The number of images that could not be decoded.
    std::uint64_t damaged = 0;
    /// All images of the stream; 0: unknown.
    std::uint64_t total = 0;
    /// Progress of opening the log, 0 to 1.
    double opening = 0;
    /// The search has ended, for whatever reason.
    bool ended = false;
    bool canceled = false;
    /// The reason why the log could not be read; empty: it could.
    std::string failure = {};
  };
  Progress progress() const;

 private:
  void searchLog(const LoggedImages& images);
  void searchHistory(const KeptImages& images);
  /// Examines an image. False: canceled.
  bool look(const robotlink::StreamMessage& message, robotlink::Duration offset);
  /// Whether a frame with this score is among the worst; remembers the score then.
  bool isKept(double score);
  /// Marks the search as ended.
  void end(std::string failure = {});

  const FrameQuery query_;
  const std::function<void()> news_;
  /// Says whether the search was canceled. Used by the thread only, as are meter and buffers.
  std::stop_token stop_;
  struct Eye;
  std::unique_ptr<Eye> eye_;
  /// Protects progress_ and found_.
  mutable std::mutex mutex_;
  Progress progress_;
  std::vector<SuspiciousFrame> found_;
  /// Has one job: the search.
  robotlink::Worker<std::monostate> worker_;
};

}  // namespace widgets
