// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <list>
#include <optional>
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
    if (retired_ == key) return &found->second->value;
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
    if (retired_ == key) retired_.reset();
    bytes_ -= found->second->bytes;
    items_.erase(found->second);
    places_.erase(found);
  }

  void clear() {
    items_.clear();
    places_.clear();
    retired_.reset();
    bytes_ = 0;
  }

  /// Says that a value will hardly be asked for again. It is kept for now, but goes before all others.
  void retire(std::size_t key) {
    const auto found = places_.find(key);
    if (found == places_.end() || retired_ == key) return;
    retired_ = key;
    items_.splice(items_.end(), items_, found->second);
  }

  /// Takes out what would have to go to make room for `bytes` more, or what was retired: its memory can be
  /// used again.
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
  struct Item {
    std::size_t key;
    Value value;
    std::size_t bytes;
  };
  std::size_t maxBytes_;
  std::size_t bytes_ = 0;
  std::list<Item> items_;               // the last used one first
  std::optional<std::size_t> retired_;  // if it is still there
  std::unordered_map<std::size_t, typename std::list<Item>::iterator> places_;
};

}  // namespace logplayer::mcap
