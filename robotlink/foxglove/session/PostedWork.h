// SPDX-License-Identifier: GPL-3.0-or-later
// For the sources of a SessionServer only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace robotlink::websocket {

class SessionServer;

/// Work that the link's thread adds and tick() takes; outlives the SessionServer with the server's handlers.
/// Bounded: while the session does not tick, clients are refused what would wait beyond that.
class PostedWork {
 public:
  using Work = std::function<void(SessionServer&)>;
  struct Limits {
    std::size_t pieces = 4096, urgent = 256, bytes = 64U << 20U;
  };
  /// The reason for clients whose wish was not taken.
  static constexpr char kRefusal[] =
      "too many requests are waiting already: the robot's session is busy; try again later";

  PostedWork() : PostedWork(Limits()) {}
  explicit PostedWork(Limits limits) : limits_(limits) {}

  /// Returns false without taking it if too much waits. `bytes` is the memory that it keeps besides itself.
  bool add(Work work, std::size_t bytes = 0) {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= limits_.pieces || bytes > limits_.bytes - bytes_) return false;
    bytes_ += bytes;
    waiting_.push_back({std::move(work), ""});
    return true;
  }
  /// Adds work that precedes all that is not urgent. Returns false without taking it if too much waits.
  bool addUrgent(Work work) {
    const std::lock_guard lock(mutex_);
    if (urgent_.size() >= limits_.urgent) return false;
    urgent_.push_back(std::move(work));
    return true;
  }
  /// Notes the whole state of something, which is always accepted: if too much waits, it replaces what
  /// waits with the same key.
  void addState(const std::string& key, Work work) {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= limits_.pieces)
      std::erase_if(waiting_, [&](const Piece& one) { return one.key == key; });
    waiting_.push_back({std::move(work), key});
  }
  /// Takes the place of what waits of the same client and topic.
  void addNewest(std::uint64_t client, const std::string& topic, Work work) {
    const std::lock_guard lock(mutex_);
    newest_[{client, topic}] = std::move(work);
  }
  /// Everything that waits, in the order in which it is to be done.
  std::vector<Work> take() {
    const std::lock_guard lock(mutex_);
    std::vector<Work> all = std::exchange(urgent_, {});
    for (Piece& piece : std::exchange(waiting_, {})) all.push_back(std::move(piece.work));
    for (auto& [from, work] : std::exchange(newest_, {})) all.push_back(std::move(work));
    bytes_ = 0;
    return all;
  }

 private:
  struct Piece {
    Work work;
    /// The object whose state it notes; empty if it must be done whatever comes after it.
    std::string key;
  };

  const Limits limits_;
  /// Protects what follows.
  std::mutex mutex_;
  std::vector<Work> urgent_;
  std::deque<Piece> waiting_;
  std::map<std::pair<std::uint64_t, std::string>, Work> newest_;
  std::size_t bytes_ = 0;
};

}  // namespace robotlink::websocket
