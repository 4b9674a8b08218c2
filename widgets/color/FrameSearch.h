// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "colortool/ColorCorrection.h"
#include "colortool/Suspicion.h"
#include "robotlink/session/StreamMessage.h"

namespace widgets {

/// An image in which a table does something suspicious.
struct SuspiciousFrame {
  robotlink::Instant time;  ///< of the session: as the replay tells it
  colortool::Suspicion found;
  QImage thumbnail;
};

/// Where the images are: in a log, or in a history.
struct LoggedImages {
  std::filesystem::path log;
  std::string stream;             ///< as the log calls it
  robotlink::Duration offset{0};  ///< added to the log's times
};
using KeptImages = std::vector<robotlink::StreamMessage>;

/// What is looked for. Cheap to copy, but for a history.
struct FrameQuery {
  std::variant<LoggedImages, KeptImages> images;
  std::shared_ptr<const colortool::ColorTable> table;
  std::shared_ptr<const std::vector<std::uint8_t>> margins;  ///< null: not known
  std::vector<bool> things;                                  ///< classes that are looked at, by number
  colortool::ColorCorrection correction = {};                ///< of the camera
  colortool::SuspicionOptions options = {};
};

/// Goes over all images of a stream in a thread of its own, as fast as they can be decoded, and hands out
/// those with suspicious pixels as it finds them, but no more than kMaxKept, the worst ones. The other
/// functions: one thread. The destructor gives up, and waits for the image in hand.
class FrameSearch {
 public:
  static constexpr std::size_t kMaxKept = 500;

  /// `news` is called in the search's thread whenever there is something to take; it must not block.
  FrameSearch(FrameQuery query, std::function<void()> news);
  ~FrameSearch();
  FrameSearch(const FrameSearch&) = delete;
  FrameSearch& operator=(const FrameSearch&) = delete;

  /// Goes no further; what was found stays.
  void cancel() { cancelled_ = true; }
  /// Those that were found since the last call, the first ones first.
  std::vector<SuspiciousFrame> take();

  struct Progress {
    std::uint64_t seen = 0;        ///< images
    std::uint64_t suspicious = 0;  ///< of these, also those that are not among the worst
    std::uint64_t damaged = 0;     ///< of these, that could not be decoded
    std::uint64_t total = 0;       ///< 0: not yet known
    double opening = 0;            ///< the share of the log's opening
    bool ended = false;
    bool cancelled = false;
    std::string failure = {};  ///< why the log could not be read
  };
  Progress progress() const;

 private:
  void run();
  void searchLog(const LoggedImages& images);
  void searchHistory(const KeptImages& images);
  /// False: give up.
  bool look(const robotlink::StreamMessage& message, robotlink::Duration offset);
  /// Whether a frame with this score is among the worst.
  bool isKept(double score);
  void end(std::string failure = {});

  const FrameQuery query_;
  const std::function<void()> news_;
  std::atomic<bool> cancelled_{false};
  struct Eye;
  std::unique_ptr<Eye> eye_;  // the thread's own
  mutable std::mutex mutex_;  // protects progress_ and found_
  Progress progress_;
  std::vector<SuspiciousFrame> found_;
  std::thread thread_;
};

}  // namespace widgets
