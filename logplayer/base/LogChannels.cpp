// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/LogChannels.h"

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"

namespace logplayer {
namespace {

using robotcontrol::FrameInfo;

std::string robotOf(const std::string& path) {
  return path.substr(0, path.find('/'));
}

std::string processOf(const mcap::Channel& channel) {
  const auto found = channel.metadata.find("process");
  return found == channel.metadata.end() ? std::string() : found->second;
}

}  // namespace

std::uint64_t widenFrame(std::uint32_t lower, std::uint64_t near) {
  if (lower == 0 && near < (std::uint64_t{1} << 31)) return 0;
  // The signed difference of the lower bits, negative if that is shorter.
  const auto way = static_cast<std::int32_t>(lower - static_cast<std::uint32_t>(near));
  return near + static_cast<std::uint64_t>(static_cast<std::int64_t>(way));
}

LogChannels::LogChannels(mcap::Reader& reader) : reader_(reader) {
  const auto& counts = reader.statistics().channelMessageCounts;
  for (const auto& [id, channel] : reader.channels()) {
    const auto schema = reader.schemas().find(channel.schemaId);
    std::optional<robotlink::MessageSchema> known;
    if (schema != reader.schemas().end())
      known = {schema->second.name, schema->second.encoding, schema->second.data};
    const auto sample = [this, number = id] { return firstOf(number); };
    states_.emplace(
        id, State{channel.topic, processOf(channel),
                  robotlink::MessageType(known ? &*known : nullptr, channel.messageEncoding, sample)});
    const auto count = counts.find(id);
    if (!channel.topic.empty() && count != counts.end() && count->second > 0)
      streams_[channel.topic].push_back(id);
  }
  findFrames();
}

std::set<std::string> LogChannels::robots() const {
  std::set<std::string> robots;
  for (const auto& [path, channels] : streams_) {
    const auto slash = path.find('/');
    if (slash == std::string::npos || slash == 0) continue;
    const bool ours = std::any_of(channels.begin(), channels.end(), [&](std::uint16_t id) {
      const State& state = states_.at(id);
      return state.type.isDecoded() &&
             (!state.process.empty() || state.type.name().starts_with("robotcontrol."));
    });
    if (ours) robots.insert(path.substr(0, slash));
  }
  return robots;
}

const std::vector<std::uint16_t>& LogChannels::of(const std::string& path) const {
  static const std::vector<std::uint16_t> kNone;
  const auto found = streams_.find(path);
  return found == streams_.end() ? kNone : found->second;
}

std::string LogChannels::firstOf(std::uint16_t channel) {
  const auto first = reader_.next({mcap::Instant::min(), 0, 0, 0}, {channel});
  const auto data = first ? reader_.read(*first) : tl::unexpected(robotlink::Error{});
  if (!data) return {};
  return {reinterpret_cast<const char*>(data->message.data.data()), data->message.data.size()};
}

void LogChannels::findFrames() {
  std::map<std::string, Frames> frames;  // by "<robot>/<process>"
  for (const auto& [path, channels] : streams_) {
    const std::string robot = robotOf(path);
    const std::string prefix = robot + "/" + robotlink::streams::kFrames;
    if (!path.starts_with(prefix)) continue;
    for (const std::uint16_t channel : channels) {
      if (const auto found = framesOf(channel)) frames[robot + "/" + path.substr(prefix.size())] = *found;
    }
  }
  for (auto& [id, state] : states_) {
    const auto found = frames.find(robotOf(state.path) + "/" + state.process);
    if (state.process.empty() || found == frames.end()) continue;
    state.firstFrame = found->second.first;
    // Only if the file was not closed properly: a complete file may contain messages between frames.
    if (!reader_.complete()) state.completeUntil = found->second.last;
  }
}

std::optional<LogChannels::Frames> LogChannels::framesOf(std::uint16_t channel) {
  const auto last = reader_.latest(channel, mcap::Instant::max());
  const auto first = reader_.next({mcap::Instant::min(), 0, 0, 0}, {channel});
  if (!first || !last) return std::nullopt;
  Frames frames{0, last->time};
  // The FrameInfo contains the full number.
  if (const auto data = reader_.read(*first)) {
    const auto value = states_.at(channel).type.read(data->message.data);
    if (const auto* info = dynamic_cast<const FrameInfo*>(value.get())) frames.first = info->number();
  }
  return frames;
}

std::optional<robotlink::StreamMessage> LogChannels::read(const mcap::MessagePosition& position) {
  const auto data = reader_.read(position);
  return data ? read(data->message) : std::nullopt;
}

std::optional<robotlink::StreamMessage> LogChannels::read(const mcap::Message& message) const {
  const State& state = states_.at(message.channelId);
  robotlink::StreamMessage read{state.path, message.logTime, state.type.read(message.data), state.process};
  if (!read.value) return std::nullopt;
  if (!state.process.empty()) read.frame = widenFrame(message.sequence, state.firstFrame);
  read.bytes = message.data.size() + 256;  // the value of robotlink::sizeOf(), without measuring again
  return read;
}

}  // namespace logplayer
