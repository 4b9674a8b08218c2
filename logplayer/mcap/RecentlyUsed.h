// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <list>
#include <unordered_map>
#include <utility>

namespace logplayer::mcap {

/// Keeps values up to a number of bytes; what was not used for longest goes first. The newest one is kept
/// whatever its size.
template <typename Value>
class RecentlyUsed {
 public:
  explicit RecentlyUsed(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  /// Null: not there. Valid until the next call.
  Value* find(std::size_t key) {
    if (!items_.empty() && items_.front().key == key) return &items_.front().value;
    const auto found = places_.find(key);
    if (found == places_.end()) return nullptr;
    items_.splice(items_.begin(), items_, found->second);
    return &items_.front().value;
  }

  void insert(std::size_t key, Value value, std::size_t bytes) {
    erase(key);
    items_.push_front({key, std::move(value), bytes});
    places_[key] = items_.begin();
    bytes_ += bytes;
    while (bytes_ > maxBytes_ && items_.size() > 1) erase(items_.back().key);
  }

  void erase(std::size_t key) {
    const auto found = places_.find(key);
    if (found == places_.end()) return;
    bytes_ -= found->second->bytes;
    items_.erase(found->second);
    places_.erase(found);
  }

  /// Takes out what would have to go to make room for `bytes` more: its memory can be used again.
  Value release(std::size_t bytes) {
    Value value{};
    while (!items_.empty() && bytes_ + bytes > maxBytes_) {
      value = std::move(items_.back().value);
      erase(items_.back().key);
    }
    return value;
  }

 private:
  struct Item {
    std::size_t key;
    Value value;
    std::size_t bytes;
  };
  std::size_t maxBytes_;
  std::size_t bytes_ = 0;
  std::list<Item> items_;  // the last used one first
  std::unordered_map<std::size_t, typename std::list<Item>::iterator> places_;
};

}  // namespace logplayer::mcap
