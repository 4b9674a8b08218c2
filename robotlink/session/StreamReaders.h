// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"

namespace robotlink {

/// Tracks which readers use which streams of a session: each view while it is updated. What is read then by
/// find() and latest() of the store, or noted by noteRead(), counts as read by it, until the next period
/// begins. So readers need not declare what they read, and reading costs one more operation on a number.
///
/// Up to kMaxReaders have names of their own; those beyond share the last one. The store must outlive it. One
/// thread, the store's.
class StreamReaders {
 public:
  static constexpr std::size_t kMaxReaders = 64;

  explicit StreamReaders(StreamStore& store) : store_(store) {}
  StreamReaders(const StreamReaders&) = delete;
  StreamReaders& operator=(const StreamReaders&) = delete;

  /// While it exists, a reader reads. `key` identifies it; `name` is for users ("Image: red1/camera"). Within
  /// another one, that one reads no longer until this one ends.
  class Scope {
   public:
    Scope(StreamReaders& readers, const std::string& key, const std::string& name);
    ~Scope() { store_.setReader(before_); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    StreamStore& store_;
    std::uint64_t before_;
  };

  /// The names of those that have read a stream since the period began, sorted.
  std::vector<std::string> of(const StreamStore::Stream& stream) const;
  /// Starts a new period: forgets which reader has read what, and idle readers. The view that shows them
  /// calls this after several updates of all views.
  void beginPeriod();

 private:
  struct Reader {
    std::string key, name;
    /// Whether it was named since the period began.
    bool isActive = false;
  };
  /// The bit of a reader.
  std::uint64_t bitOf(const std::string& key, const std::string& name);

  StreamStore& store_;
  /// Keyed by bit; an empty key: free.
  std::array<Reader, kMaxReaders> readers_;
};

}  // namespace robotlink
