// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace robotlink {

/// A stretch of a session's time, both ends included.
struct Stretch {
  Instant from, to;
  bool operator==(const Stretch&) const = default;
};

/// The store to which a session's history moves messages that no longer fit into memory, and from which it
/// reads them when they are looked at. All functions return at once; reading and writing is done elsewhere.
/// Called by one thread, the session's.
class HistoryArchive {
 public:
  /// A stretch that was read.
  struct Part {
    /// The instant that was requested, which is within the stretch.
    Instant at;
    Stretch stretch;
    /// In order of time: the newest of each stream at the stretch's begin, and all within it.
    std::vector<StreamMessage> messages;
  };

  /// Messages that were added together, for threads that read values over time. It is a value; its file may
  /// be removed meanwhile.
  struct Piece {
    /// The time for which messages are complete with it.
    Stretch held;
    /// The times of the first and the last message of each stream, by path; never null.
    std::shared_ptr<const std::map<std::string, Stretch>> times;
    /// The log file that has the messages; empty: it was not written yet, and `messages` has them.
    std::filesystem::path file = {};
    /// The messages, in order of time within each stream; null if they are in a file.
    std::shared_ptr<const std::vector<StreamMessage>> messages = {};
  };

  virtual ~HistoryArchive() = default;

  /// Adds messages in any order; those of one stream are in order of time and follow the ones that were
  /// added before. They are all that held in `held` and no longer do at its end, since one that followed on
  /// their stream holds instead. Its begin is the end of what was added before, or Instant::min().
  virtual void add(std::vector<StreamMessage> messages, Stretch held) = 0;
  /// Drops what is later than `time`, because the platform's clock was set back; may drop more.
  virtual void forgetAfter(Instant time) = 0;
  virtual void clear() = 0;
  /// Requests the messages around an instant; replaces a request that was not served.
  virtual void request(Instant at) = 0;
  /// The last part that was read since the last call.
  virtual std::optional<Part> take() = 0;

  /// All that can be read now, in the order in which it was added; that of each stream is in order of time.
  virtual std::vector<Piece> pieces() const { return {}; }

  /// Changes the limit of the bytes that the archive may take; the oldest messages beyond it go. With 0
  /// nothing is added any longer. After a problem, adding begins again.
  virtual void setLimit(std::uint64_t bytes) = 0;
  virtual std::uint64_t limit() const = 0;

  /// Returns the range that can be read, except the holes; unset: nothing.
  virtual std::optional<Stretch> stretch() const = 0;
  /// Returns what was lost within stretch(), in order of time, because too much waited to be stored.
  virtual std::vector<Stretch> holes() const = 0;
  /// Whether little waits to be put there, so that more can be added than what robots send.
  virtual bool hasRoom() const = 0;
  /// Whether what is added now is lost, since too much waits.
  virtual bool isLosing() const = 0;
  /// Returns the size of the messages where they are stored, in bytes.
  virtual std::uint64_t bytes() const = 0;
  /// Each stream's share of the messages, in bytes of memory that they took.
  virtual std::map<std::string, std::uint64_t> shares() const = 0;
  /// Why nothing more is added, or why a part is lost, once.
  virtual std::optional<Error> takeProblem() = 0;
};

}  // namespace robotlink
