// SPDX-License-Identifier: GPL-3.0-or-later
// The special handling of foreign servers: channels that are not decoded or heavy, and nodes.
#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/session/ProcessTables.h"
#include "robotlink/foxglove/session/remote/RemoteSession.h"

namespace robotlink::websocket {
namespace {

using robotcontrol::KeyTable;

/// The interval of checks for channels that are not decoded, and how many of them a text names.
constexpr Duration kLookAtChannels = std::chrono::seconds(1);
constexpr std::size_t kMaxNamed = 20;
constexpr std::size_t kMaxNoted = 10'000;

}  // namespace

/// Whether a schema makes sense is known with its first message only.
void RemoteSession::nameUndecoded() {
  const Instant now = options.connection.clock->now();
  if (robots.names().empty() || now - lookedAtChannels < kLookAtChannels) return;
  lookedAtChannels = now;
  std::set<std::string> decoded;
  for (const auto& [id, channel] : channels)
    if (channel->isDecoded) decoded.insert(channel->topic);
  std::string names;
  std::size_t count = 0;
  for (const auto& [id, channel] : channels) {
    if (decoded.contains(channel->topic) || undecoded.size() >= kMaxNoted) continue;
    if (!undecoded.insert(channel->topic).second || ++count > kMaxNamed) continue;
    names += (names.empty() ? "" : ", ") + channel->topic + " (" + channel->encoding + ")";
  }
  if (count == 0) return;
  if (count > kMaxNamed) names += " and " + std::to_string(count - kMaxNamed) + " more";
  publishText(StatusLevel::kWarning, "Not shown, since their encoding is not decoded here: " + names);
}

/// A foreign server's heavy channels look like debug keys, which one switches on.
void RemoteSession::updateChannelKeys() {
  RemoteRobotList::Robot* robot = robots.findRemote("");
  if (isOurs || robot == nullptr) return;
  KeyTable table;
  for (const auto& [id, channel] : channels) {
    if (!channel->isDecoded || !channel->isHeavy()) continue;
    KeyTable::Key& key = *table.add_keys();
    const std::string stream = robots.placeOf(channel->topic).stream;
    key.set_name(validUtf8("channel/" + stream));
    key.set_help(validUtf8("Receives " + channel->type + " from " + toString(options.connection.url)));
    key.set_stream(validUtf8(stream));
    key.set_in_use(true);
  }
  robot->keys.setChannelKeys(table);
  changedKeys.insert(robot->remote);
}

void RemoteSession::onGraph(const ConnectionGraphUpdate& update) {
  apply(update, graph);
  hasOtherGraph = true;
}

void RemoteSession::pushProcesses() {
  const RemoteRobotList::Robot* robot = robots.findRemote("");
  const std::string path = robot == nullptr ? std::string() : robot->local + "/" + streams::kProcesses;
  const bool isEmpty = graph.publishedTopics.empty() && graph.subscribedTopics.empty();
  // A table that was published before may be outdated.
  if (isOurs || robot == nullptr || (isEmpty && session.store().find(path) == nullptr)) return;
  std::map<std::string, std::string> types;
  for (const auto& [id, channel] : channels) types[channel->topic] = channel->type;
  const auto table = std::make_shared<const robotcontrol::ProcessTable>(tableOf(graph, types));
  enter({path, std::max(shift.newest().value_or(Instant()), newestOf[path].mapped), table});
}

}  // namespace robotlink::websocket
