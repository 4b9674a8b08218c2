// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/StreamReaders.h"

#include <algorithm>
#include <utility>

namespace robotlink {

StreamReaders::Scope::Scope(StreamReaders& readers, const std::string& key, const std::string& name)
    : store_(readers.store_), before_(readers.store_.reader()) {
  store_.setReader(readers.bitOf(key, name));
}

std::uint64_t StreamReaders::bitOf(const std::string& key, const std::string& name) {
  auto found = std::ranges::find(readers_, key, &Reader::key);
  if (found == readers_.end()) found = std::ranges::find(readers_, std::string(), &Reader::key);
  if (found == readers_.end()) found = std::prev(readers_.end());
  found->key = key;
  found->name = name;
  found->isActive = true;
  return std::uint64_t{1} << static_cast<unsigned>(found - readers_.begin());
}

std::vector<std::string> StreamReaders::of(const StreamStore::Stream& stream) const {
  std::vector<std::string> names;
  for (std::size_t bit = 0; bit < kMaxReaders; ++bit) {
    if ((stream.readers >> bit & 1U) != 0 && !readers_[bit].name.empty()) names.push_back(readers_[bit].name);
  }
  std::ranges::sort(names);
  return names;
}

void StreamReaders::beginPeriod() {
  store_.forgetReaders();
  for (Reader& reader : readers_) {
    if (!std::exchange(reader.isActive, false)) reader = {};
  }
}

}  // namespace robotlink
