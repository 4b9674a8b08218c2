// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <list>
#include <optional>
#include <unordered_map>
#include <utility>

namespace logplayer::mcap {

/// A cache of values up to a total size: the least recently used value is evicted first. The newest value is
/// kept whatever its size. Not synchronized.
template <typename Value>
class RecentlyUsed {
 public:
  /// `maxBytes`: the maximum of the sum of the sizes passed to insert().
  explicit RecentlyUsed(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  /// Returns null if there is no such value; marks it as used. Valid until the next call.
  Value* find(std::size_t key) {
    if (!items_.empty() && items_.front().key == key) return &items_.front().value;
    const auto found = places_.find(key);
    if (found == places_.end()) return nullptr;
    if (retired_ == key) return &found->second->value;
    items_.splice(items_.begin(), items_, found->second);
    return &items_.front().value;
  }

  /// Whether there is such a value; does not mark it as used.
  bool contains(std::size_t key) const { return places_.contains(key); }

  /// Adds or replaces a value of this size; may evict others.
  void insert(std::size_t key, Value value, std::size_t bytes) {
    erase(key);
    items_.push_front({key, std::move(value), bytes});
    places_[key] = items_.begin();
    bytes_ += bytes;
    while (bytes_ > maxBytes_ && items_.size() > 1) erase(items_.back().key);
  }

  /// Removes a value, if it is there.
  void erase(std::size_t key) {
    const auto found = places_.find(key);
    if (found == places_.end()) return;
    if (retired_ == key) retired_.reset();
    bytes_ -= found->second->bytes;
    items_.erase(found->second);
    places_.erase(found);
  }

  /// Removes all values.
  void clear() {
    items_.clear();
    places_.clear();
    retired_.reset();
    bytes_ = 0;
  }

  /// Marks a value as probably no longer needed: it stays available, but is evicted first.
  void retire(std::size_t key) {
    const auto found = places_.find(key);
    if (found == places_.end() || retired_ == key) return;
    retired_ = key;
    items_.splice(items_.end(), items_, found->second);
  }

  /// Removes the values that have to go to make room for `bytes` more, and the retired one, and returns one
  /// of them, so that its memory can be reused; a default value if there is none.
  Value release(std::size_t bytes) {
    Value value{};
    if (retired_) {
      value = std::move(places_.at(*retired_)->value);
      erase(*retired_);
    }
    while (!items_.empty() && bytes_ + bytes > maxBytes_) {
      value = std::move(items_.back().value);
      erase(items_.back().key);
    }
    return value;
  }

 private:
  /// A value with its key and size.
  struct Item {
    std::size_t key;
    Value value;
    std::size_t bytes;
  };
  std::size_t maxBytes_;
  std::size_t bytes_ = 0;
  /// The most recently used one first.
  std::list<Item> items_;
  /// Key of the retired value, while it exists.
  std::optional<std::size_t> retired_;
  /// Positions in items_ by key.
  std::unordered_map<std::size_t, typename std::list<Item>::iterator> places_;
};

}  // namespace logplayer::mcap
