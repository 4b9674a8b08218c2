// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/LogJoin.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/debugging/Streams.h"

namespace logplayer {

using mcap::Reader;
using robotcontrol::ProgramSetup;
using robotlink::Duration;
using robotlink::Instant;

namespace {

/// The tolerated overlap: messages of a frame may be older than its end, and thus belong to the previous
/// part.
Duration toleranceOf(const LogPart& part) {
  return std::min<Duration>(std::chrono::seconds(1), (part.end() - part.begin()) / 20);
}

std::string typeNameOf(Reader& reader, const mcap::Channel& channel) {
  const auto schema = reader.schemas().find(channel.schemaId);
  return schema == reader.schemas().end() ? std::string() : schema->second.name;
}

/// Returns the first or the last setup of a robot's program in a log.
std::optional<ProgramSetup> setupIn(Reader& reader, const std::string& robot, bool last) {
  std::vector<std::uint16_t> channels;
  for (const auto& [id, channel] : reader.channels()) {
    const bool program = channel.topic == robot + "/" + robotlink::streams::kProgram;
    if (program && typeNameOf(reader, channel) == ProgramSetup::descriptor()->full_name())
      channels.push_back(id);
  }
  if (channels.empty()) return std::nullopt;
  const auto position =
      last ? reader.previous({Instant::max(), ~std::uint64_t{0}, ~std::uint64_t{0}, 0xFFFF}, channels)
           : reader.next({Instant::min(), 0, 0, 0}, channels);
  const auto data = position ? reader.read(*position) : tl::unexpected(robotlink::Error{});
  ProgramSetup setup;
  if (!data ||
      !setup.ParseFromArray(data->message.data.data(), static_cast<int>(data->message.data.size()))) {
    return std::nullopt;
  }
  return setup;
}

bool agree(const std::optional<ProgramSetup>& one, const std::optional<ProgramSetup>& other) {
  if (!one || !other) return !one && !other;
  const auto same = [](const ProgramSetup::File& a, const ProgramSetup::File& b) {
    return a.name() == b.name() && a.text() == b.text();
  };
  return same(one->layout(), other->layout()) && same(one->description(), other->description()) &&
         same(one->field(), other->field());
}

void forEachFrom(Reader& reader, Instant time, const std::vector<std::uint16_t>& channels,
                 const std::function<void(const std::string& topic, const mcap::Message&)>& visit) {
  if (channels.empty()) return;
  mcap::MessagePosition before{time, 0, 0, 0};
  while (const auto position = reader.next(before, channels)) {
    before = *position;
    if (const auto data = reader.read(*position)) {
      visit(reader.channels().at(position->channelId).topic, data->message);
    }
  }
}

}  // namespace

std::string whyNotJoined(const LogPart& earlier, const LogPart& later) {
  const auto nameOf = [](const LogPart& part) { return part.source.file().filename().string(); };
  if (later.begin() < earlier.end() - std::min(toleranceOf(earlier), toleranceOf(later))) {
    return "the times of " + nameOf(earlier) + " and " + nameOf(later) + " overlap";
  }
  for (const std::string& robot : later.source.robots()) {
    if (!earlier.source.robots().contains(robot)) continue;
    if (!agree(setupIn(earlier.source.reader(), robot, true), setupIn(later.source.reader(), robot, false))) {
      return robot + " runs a different program in " + nameOf(later) + " than in " + nameOf(earlier);
    }
  }
  return {};
}

LogSeam::Key LogSeam::keyOf(const std::string& topic, std::int64_t number, mcap::Bytes data) {
  const std::string_view bytes(reinterpret_cast<const char*>(data.data()), data.size());
  return {topic, number, bytes.size(), std::hash<std::string_view>{}(bytes)};
}

LogSeam::LogSeam(const LogPart& earlier, const LogPart& later)
    : begin_(later.begin() - later.offset), until_(earlier.end() - later.offset) {
  Reader& reader = earlier.source.reader();
  std::vector<std::uint16_t> channels, holding;
  for (const auto& [id, channel] : reader.channels()) {
    channels.push_back(id);
    if (isLatched(channel.topic, typeNameOf(reader, channel))) holding.push_back(id);
  }
  const Duration moved = earlier.offset - later.offset;
  forEachFrom(reader, Instant::min(), holding, [&](const std::string& topic, const mcap::Message& message) {
    held_.insert(keyOf(topic, (message.publishTime + moved).time_since_epoch().count(), message.data));
  });
  const Instant from = std::min(later.begin(), earlier.end()) - earlier.offset;
  forEachFrom(reader, from, channels, [&](const std::string& topic, const mcap::Message& message) {
    both_.insert(keyOf(topic, message.sequence, message.data));
  });
}

bool LogSeam::isRepeated(const mcap::Channel& channel, const std::string& type,
                         const mcap::Message& message) const {
  if (message.logTime <= until_ && both_.contains(keyOf(channel.topic, message.sequence, message.data)))
    return true;
  return message.sequence == 0 && message.logTime == begin_ && isLatched(channel.topic, type) &&
         held_.contains(keyOf(channel.topic, message.publishTime.time_since_epoch().count(), message.data));
}

}  // namespace logplayer
