// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/TypedStreams.h"

#include <algorithm>

namespace widgets {

std::vector<const robotlink::StreamStore::Stream*> streamsOfType(const robotlink::StreamStore& store,
                                                                 const std::string& robot, const char* type) {
  auto streams = store.streams(robot.empty() ? std::string() : robot + '/');
  std::erase_if(streams, [type](const auto* stream) { return stream->type != type; });
  return streams;
}

std::vector<const robotlink::StreamMessage*> latestOfType(const robotlink::StreamStore& store,
                                                          const std::string& robot, const char* type,
                                                          robotlink::Instant time) {
  std::vector<const robotlink::StreamMessage*> messages;
  for (const auto* stream : streamsOfType(store, robot, type)) {
    messages.push_back(store.latest(stream->path, time));
  }
  return messages;
}

std::vector<const void*> valuesOf(const std::vector<const robotlink::StreamMessage*>& messages) {
  std::vector<const void*> values;
  values.reserve(messages.size());
  for (const auto* message : messages) values.push_back(message != nullptr ? message->value.get() : nullptr);
  return values;
}

std::string lastPart(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::string robotPart(const std::string& path) {
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

StreamCursor::Range StreamCursor::take(const robotlink::StreamStore::Stream& stream) {
  const auto& messages = stream.messages;
  const auto size = messages.size();
  const auto added = static_cast<std::size_t>(std::min<std::uint64_t>(stream.count - count_, size));
  Range range{size - added, size, false};
  if (added == 0 && stream.count == count_) return range;
  if (last_.value != nullptr && !messages.empty() && messages[range.first].time < last_.time) {
    range.restarted = true;
  }
  count_ = stream.count;
  if (!messages.empty()) last_ = messages.back();
  return range;
}

}  // namespace widgets
