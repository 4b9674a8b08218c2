// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "logplayer/scratch/ScratchFolder.h"
#include "logplayer/scratch/ScratchSegment.h"
#include "robotlink/base/Worker.h"

namespace logplayer {

/// The history of a session on disk: what no longer fits into memory, as log files in a temporary folder, of
/// which the oldest are removed. It is written and read in a thread of its own; messages are in memory until
/// they were written, and are shared.
///
/// A full disk is reported once, and nothing further is added; data that was written can still be read. If
/// the disk is too slow, added messages are lost until half of the waiting ones were written: this is noted
/// once, and leaves a hole. Messages that are valid at the begin of a hole are not lost.
class ScratchLog final : public robotlink::HistoryArchive {
 public:
  struct Options {
    /// How much the files may take; the oldest is removed beyond it. 0: nothing is added.
    std::uint64_t bytes = std::uint64_t{4} << 30U;
    /// How much stays free on the disk, for others.
    std::uint64_t reserve = std::uint64_t{1} << 30U;
    /// How much may wait in memory to be written, in addition to what was added last.
    std::uint64_t waiting = std::uint64_t{256} << 20U;
    /// Called in the thread before a file is written, so that tests can hold it up.
    std::function<void()> beforeWrite = {};
  };

  /// Creates a log that writes nothing to disk before something is added.
  explicit ScratchLog(Options options);
  ~ScratchLog() override;

  void add(std::vector<robotlink::StreamMessage> messages, robotlink::Stretch held) override;
  void forgetAfter(robotlink::Instant time) override;
  void clear() override;
  void request(robotlink::Instant at) override;
  std::optional<Part> take() override { return worker_.take(); }
  std::vector<Piece> pieces() const override;
  void setLimit(std::uint64_t bytes) override;
  std::uint64_t limit() const override;
  std::optional<robotlink::Stretch> stretch() const override;
  std::vector<robotlink::Stretch> holes() const override;
  bool hasRoom() const override;
  bool isLosing() const override;
  std::uint64_t bytes() const override;
  std::map<std::string, std::uint64_t> shares() const override;
  std::optional<robotlink::Error> takeProblem() override;

  /// Blocks until all that was added is written and all that was requested is read.
  void finish() { worker_.finish(); }
  /// The folder with the files; empty before there is one.
  std::filesystem::path folder() const;

 private:
  struct Entry {
    /// Used by the thread only, except for constant parts.
    std::shared_ptr<ScratchSegment> segment;
    /// The messages of the segment until they are written, and the file afterward.
    std::shared_ptr<const std::vector<robotlink::StreamMessage>> messages;
    std::filesystem::path file = {};
    /// The stretch of time that is complete with it.
    robotlink::Stretch held = {};
    /// The memory of the messages until they are written, and the size of the file afterward.
    std::uint64_t waiting = 0, written = 0;
    /// Whether a part before it was lost.
    bool isAfterHole = false;
  };

  /// Writes and reads until nothing is left to do; in the thread.
  void work();
  /// Returns whether there was something to write.
  bool writeNext();
  robotlink::Result<std::uint64_t> write(ScratchSegment& segment);
  Part read(robotlink::Instant at, const std::deque<Entry>& entries) const;
  /// The memory of all that was not written yet. Call it with the mutex locked.
  std::uint64_t waiting() const;
  /// Begins or ends a hole, whose begin is `from`. Returns whether one has ended. Call it with the mutex
  /// locked.
  bool followQueue(robotlink::Instant from);
  /// Removes all. Call it with the mutex locked.
  void drop();
  /// Removes the oldest files beyond the limit. Call it with the mutex locked.
  void trim();
  /// Reports a problem, and drops what was not written. Call it with the mutex locked.
  void stop(const std::string& why);

  const Options options_;
  /// Used by the thread only; unset until something is written.
  std::optional<ScratchFolder> folder_;
  std::uint64_t files_ = 0;
  /// Protects everything below but the thread.
  mutable std::mutex mutex_;
  std::uint64_t limit_;
  std::filesystem::path path_;
  std::deque<Entry> entries_;
  std::optional<robotlink::Instant> requested_;
  /// The begin of the hole, while what is added is lost.
  std::optional<robotlink::Instant> losingFrom_;
  std::optional<robotlink::Error> problem_;
  bool isStopped_ = false;
  robotlink::Worker<std::monostate, Part> worker_;
};

}  // namespace logplayer
