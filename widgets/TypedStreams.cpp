// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/TypedStreams.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "robotlink/debugging/Streams.h"

namespace widgets {

std::vector<const robotlink::StreamStore::Stream*> streamsOfType(const robotlink::StreamStore& store,
                                                                 const std::string& robot, const char* type) {
  auto streams = store.streams(robot.empty() ? std::string() : robot + '/');
  std::erase_if(streams, [type](const auto* stream) { return stream->type != type; });
  for (const auto* stream : streams) store.noteRead(*stream);
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

std::vector<const robotlink::StreamMessage*> latestTable(const robotlink::StreamStore& store,
                                                         const std::string& robot, const char* path,
                                                         robotlink::Instant time) {
  const auto* table = store.latest(robot + '/' + path, time);
  if (table == nullptr) return {};
  return {table};
}

std::vector<const void*> valuesOf(const std::vector<const robotlink::StreamMessage*>& messages) {
  std::vector<const void*> values;
  values.reserve(messages.size());
  for (const auto* message : messages) values.push_back(message != nullptr ? message->value.get() : nullptr);
  return values;
}

std::string lastPart(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

bool hasForeignStreams(const robotlink::StreamStore& store) {
  namespace streams = robotlink::streams;
  constexpr std::array<std::string_view, 10> kOfWorld{
      streams::kScene, streams::kTransforms, streams::kSimulation, streams::kRecording, streams::kReplay,
      streams::kMap,   streams::kBookmarks,  streams::kObjects,    streams::kPorts,     streams::kSolids};
  return std::ranges::any_of(store.streams(), [&](const auto* stream) {
    return robotlink::streams::robotOf(stream->path).empty() &&
           std::ranges::find(kOfWorld, stream->path) == kOfWorld.end();
  });
}

bool StreamCursor::seen(const robotlink::StreamMessage& message) const {
  return message.time <= newest_ &&
         std::find(recent_.rbegin(), recent_.rend(), message.value) != recent_.rend();
}

StreamCursor::News StreamCursor::take(const robotlink::StreamStore::Stream& stream) {
  constexpr std::size_t kRemembered = 256;  // more than ever arrive out of order
  News news;
  if (stream.generation != generation_) {
    news.restarted = count_ > 0;
    *this = {};
    generation_ = stream.generation;
  }
  const std::uint64_t added = stream.count - count_;
  if (added == 0) return news;
  // Messages that are only there because somebody looks back at them are not new.
  const auto end = stream.messages.rend() - static_cast<std::ptrdiff_t>(stream.lookedAt);
  for (auto at = stream.messages.rbegin(); at != end; ++at) {
    const auto& message = *at;
    if (news.messages.size() == added) break;
    if (!seen(message)) news.messages.push_back(&message);
  }
  std::reverse(news.messages.begin(), news.messages.end());
  news.missed = count_ > 0 && news.messages.size() < added;
  news.restarted =
      news.restarted || (count_ > 0 && !stream.messages.empty() && stream.messages.back().time < newest_);
  count_ = stream.count;
  if (!stream.messages.empty()) newest_ = stream.messages.back().time;
  for (const auto* message : news.messages) recent_.push_back(message->value);
  while (recent_.size() > kRemembered) recent_.pop_front();
  return news;
}

}  // namespace widgets
