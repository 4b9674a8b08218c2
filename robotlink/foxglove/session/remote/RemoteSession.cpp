// SPDX-License-Identifier: GPL-3.0-or-later
// Handling of messages from the server, and subscriptions.
#include "robotlink/foxglove/session/remote/RemoteSession.h"

#include <algorithm>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/server/Server.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/ProcessTables.h"

namespace robotlink::websocket {
namespace {

using robotcontrol::KeyTable;

constexpr std::size_t kMaxGaps = 1000, kMaxPaths = 50'000;
/// A step back in time within a stream of several processes that is not disorder any longer, but a reset.
constexpr Duration kReset = std::chrono::seconds(1);
/// After a connection was opened again, robots that are not mentioned again are gone.
constexpr Duration kStaleTime = std::chrono::seconds(2);

SessionClientOptions withClock(SessionClientOptions options) {
  if (!options.connection.clock) options.connection.clock = std::make_shared<const SteadyClock>();
  return options;
}

/// Whether a robot always publishes a stream, even before its keys are known.
bool isAlways(const std::string& stream) {
  constexpr const char* kAlways[] = {"tables/",     streams::kFrames,  streams::kParameters,
                                     streams::kLog, streams::kProgram, streams::kSteering};
  return std::ranges::any_of(kAlways, [&](const char* prefix) { return stream.starts_with(prefix); });
}

/// Streams of a world are published by one thread, so each step back in their times is a reset.
bool isOfWorld(const std::string& path) {
  return path == streams::kTransforms || path == streams::kSimulation || path == streams::kPorts ||
         path == streams::kForces;
}

/// Returns the suffix of a channel of our servers whose images another channel has raw; else empty.
std::string_view codingOf(const RemoteChannel& channel) {
  if (channel.type != "foxglove.CompressedImage") return {};
  for (const std::string_view coding : {kJpegChannel, kPngChannel})
    if (channel.topic.ends_with(coding)) return coding;
  return {};
}

bool isImage(const RemoteChannel& channel) {
  return channel.type == "foxglove.RawImage" || channel.type == "foxglove.CompressedImage";
}

/// The process that published a message, as far as its stream and the robot's tables tell.
std::string processOf(const RemoteRobotList::Place& place, const PackagePtr& value) {
  if (const auto* text = dynamic_cast<const foxglove::Log*>(value.get()))
    return text->name().substr(0, text->name().find('/'));
  for (const std::string prefix : {streams::kFrames, streams::kStopwatches})
    if (place.stream.starts_with(prefix)) return place.stream.substr(prefix.size());
  return place.robot == nullptr ? std::string() : place.robot->publishers.processOf(place.stream);
}

/// Notes which process publishes which stream, if a table says so.
void notePublishers(RemoteRobotList::Robot& robot, const std::string& stream, const PackagePtr& value) {
  const std::string tables = std::string(streams::kKeys) + "/";
  if (const auto* keys = dynamic_cast<const KeyTable*>(value.get()); keys && stream.starts_with(tables))
    robot.publishers.setKeys(stream.substr(tables.size()), *keys);
  if (const auto* processes = dynamic_cast<const robotcontrol::ProcessTable*>(value.get()))
    robot.publishers.setProcesses(*processes);
}

}  // namespace

RemoteSession::RemoteSession(Session& sharedSession, SessionClientOptions chosen)
    : session(sharedSession),
      options(withClock(std::move(chosen))),
      inbox({}, options.convert),
      robots(options.isTaken),
      restarts(session.restarts()),
      client(std::make_shared<Client>(handlers(), ClientLimits(), options.connection.clock)) {}

void RemoteSession::connect() {
  connector = std::make_unique<Connector>(client, options.connection);
}

/// In the link's thread: decodes messages, and leaves everything else to tick().
ClientHandlers RemoteSession::handlers() {
  const auto change = [this](std::function<void()> work) {
    if (!inbox.pushChange(std::move(work))) client->end("the robot changes its offer too fast to follow");
  };
  ClientHandlers h;
  h.connected = [this](const ServerInfo& info) { inbox.push([this, info] { onConnected(info); }); };
  h.disconnected = [this] {
    inbox.removeAll();
    inbox.push([this] {
      channels.clear();
      services.clear();
      lostAt = options.connection.clock->now();
    });
  };
  h.channelsAdded = [this, change](const std::vector<Channel>& added) {
    change([this, known = inbox.add(added)] { onChannels(known); });
  };
  h.channelsRemoved = [this, change](const std::vector<Channel>& removed) {
    inbox.remove(removed);
    change([this, removed] {
      for (const Channel& channel : removed) channels.erase(channel.id);
      hasChanged = true;
    });
  };
  h.servicesAdded = [this, change](const std::vector<Service>& added) {
    std::vector<std::string> names;
    for (const Service& service : added) names.push_back(service.name);
    change([this, names] { onServices(names, {}); });
  };
  h.servicesRemoved = [this, change](const std::vector<std::string>& names) {
    change([this, names] { onServices({}, names); });
  };
  h.message = [this](const Channel& channel, Instant time, std::string_view payload) {
    inbox.push(channel, time, payload);
  };
  h.parameters = [this, change](const std::vector<Parameter>& parameters) {
    // No other is looked at.
    const std::string wanted = kClientParameter;
    const auto number = std::ranges::find(parameters, wanted, &Parameter::name);
    if (number != parameters.end()) change([this, number = *number] { onParameters({number}); });
  };
  h.graph = [this, change](const ConnectionGraphUpdate& update) {
    change([this, update] { onGraph(update); });
  };
  h.status = [this](const Status& status) {
    inbox.pushSparable([this, status] { onStatus(status); }, status.message.size() + status.id.size());
  };
  return h;
}

void RemoteSession::tick() {
  lookAtRestart();
  for (const RemoteInbox::Arrival& arrival : inbox.take()) {
    if (arrival.work)
      arrival.work();
    else
      onMessage(arrival);
  }
  const ConnectionState state = client->state();
  if (state.isConnected() && options.connection.clock->now() - connectedAt > kStaleTime) robots.removeStale();
  lookAtGaps(state);
  if (state.isConnected()) nameUndecoded();
  const bool led = std::exchange(hasLed, leads());
  if (std::exchange(hasChanged, false) || led != hasLed) {
    updateChannelKeys();
    updateSubscriptions();
    hasOtherGraph = true;  // the types of its topics may be known now
  }
  if (std::exchange(hasOtherGraph, false)) pushProcesses();
  for (const std::string& name : std::exchange(changedKeys, {}))
    if (RemoteRobotList::Robot* robot = robots.findRemote(name)) pushKeys(*robot);
}

/// Publishes latched messages again after the history was dropped, at the times of the leading source.
void RemoteSession::lookAtRestart() {
  const std::uint64_t before = std::exchange(restarts, session.restarts());
  if (before == restarts) return;
  shift.restart();
  newestOf.clear();
  gaps.clear();
  hasGap = false;
  for (StreamMessage& message : latched.all()) {
    message.time = timeOf(message.path, message.time, true);
    session.push(std::move(message));
  }
}

/// A gap begins with the newest message, and ends with the first one after it.
void RemoteSession::lookAtGaps(const ConnectionState& state) {
  if (state.isConnected() || !shift.newest()) return;
  if (!hasGap) gaps.push_back({*shift.newest(), {}, state.reason});
  if (gaps.size() > kMaxGaps) gaps.erase(gaps.begin());
  hasGap = true;
  if (!state.reason.empty()) gaps.back().reason = state.reason;
}

/// Ends the gap. Messages from before it may come first, such as the newest image of a robot that pauses. No
/// newer message follows if the clock was set back: then the data before the gap is gone, and the gap, too.
void RemoteSession::endGap(Instant time) {
  const Instant from = gaps.back().from;
  if (time < from && *shift.newest() >= from) return;
  hasGap = false;
  gaps.back().to = time;
  if (time <= from) gaps.pop_back();
}

// ---- From the server

void RemoteSession::onConnected(const ServerInfo& info) {
  connectedAt = options.connection.clock->now();
  isOurs = info.metadata.contains(kSessionKey);
  if (!serverSession.empty() && info.sessionId != serverSession) {
    hasChanged |= std::exchange(isNarrow, false);
    shift.continueAfter(connectedAt - lostAt);
    for (auto& [path, times] : newestOf) times.remote = Instant::min();
  }
  serverSession = info.sessionId;
  number = 0;
  robots.setStale();
  for (auto& [name, robot] : robots.all()) robot.keys.setUnsent();
  if (!isOurs) robots.add("", info.name.empty() ? options.connection.url.host : info.name);
  client->subscribeParameters(isOurs);
  graph = {};
  client->subscribeGraph(!isOurs);  // ours publish tables of processes
  hasChanged = true;
}

void RemoteSession::onChannels(const std::vector<RemoteChannelPtr>& added) {
  for (const RemoteChannelPtr& channel : added) channels[channel->id] = channel;
  hasChanged = true;
}

/// A robot of ours is what takes requests.
void RemoteSession::onServices(const std::vector<std::string>& added,
                               const std::vector<std::string>& removed) {
  const auto robotOf = [](const std::string& service) {
    constexpr std::string_view kEnd = "/set_key";
    return service.ends_with(kEnd) ? service.substr(0, service.size() - kEnd.size()) : std::string();
  };
  for (const std::string& name : added) {
    services.insert(name);
    if (const std::string robot = robotOf(name); isOurs && !robot.empty()) robots.add(robot, robot);
  }
  for (const std::string& name : removed) {
    services.erase(name);
    if (const std::string robot = robotOf(name); isOurs && !robot.empty()) robots.remove(robot);
  }
  hasChanged = true;
}

void RemoteSession::onParameters(const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    if (parameter.name != kClientParameter || !parameter.value) continue;
    const auto* value = std::get_if<std::int64_t>(&parameter.value->data);
    if (value != nullptr) onNumber(static_cast<std::uint64_t>(*value));
  }
}

std::string RemoteSession::takeJpegOffer(const std::string& text) {
  if (images != RemoteImages::kAutomatic || isNarrow) return text;
  isNarrow = hasChanged = true;
  return "Images come as JPEG from now on: " + text;
}

PackagePtr RemoteSession::shownSteering(const std::string& path, const PackagePtr& value) {
  const auto status = std::dynamic_pointer_cast<const robotcontrol::SteeringStatus>(value);
  if (!status) return value;
  steering[path] = status;
  const bool isOwn = number != 0 && status->client() == number;
  if (status->own() == isOwn) return value;
  auto shown = std::make_shared<robotcontrol::SteeringStatus>(*status);
  shown->set_own(isOwn);
  return shown;
}

/// Updates the steering, which may have been received before the number.
void RemoteSession::onNumber(std::uint64_t value) {
  if (std::exchange(number, value) == value) return;
  for (const auto& [path, status] : std::map(steering))
    enter({path, std::max(shift.newest().value_or(Instant()), newestOf[path].mapped),
           shownSteering(path, status)});
}

/// Publishes the server's text about this client's actions as one of the first robot.
void RemoteSession::onStatus(const Status& status) {
  const bool isOffer = isOurs && status.id.starts_with(kNarrowStatus);
  publishText(status.level, isOffer ? takeJpegOffer(status.message) : status.message);
}

void RemoteSession::publishText(StatusLevel level, const std::string& text) {
  if (robots.names().empty()) return;
  const auto log = std::make_shared<foxglove::Log>();
  log->set_level(level == StatusLevel::kError     ? foxglove::Log::ERROR
                 : level == StatusLevel::kWarning ? foxglove::Log::WARNING
                                                  : foxglove::Log::INFO);
  log->set_name("link/" + validUtf8(client->state().serverName));
  log->set_message(validUtf8(text));
  const std::string path = robots.names().front() + "/" + streams::kLog;
  const Instant time = shift.newest().value_or(Instant());
  enter({path, std::max(time, newestOf[path].mapped), log, "link"});
}

/// An image is the same stream however it is sent. Foreign servers have texts under any name; views look for
/// them here.
RemoteRobotList::Place RemoteSession::placeOf(const RemoteChannel& channel) {
  RemoteRobotList::Place place = robots.placeOf(channel.topic);
  if (isOurs) {
    if (const auto coding = codingOf(channel); place.stream.size() > coding.size())
      place.stream.resize(place.stream.size() - coding.size());
    return place;
  }
  if (channel.type == "foxglove.Log") place.stream = streams::kLog;
  return place;
}

void RemoteSession::onMessage(const RemoteInbox::Arrival& arrival) {
  RemoteRobotList::Place place = placeOf(*arrival.channel);
  if (place.stream.empty() || (place.robot == nullptr && !leads())) return;
  if (place.robot != nullptr) notePublishers(*place.robot, place.stream, arrival.value);
  StreamMessage message{place.path(), {}, arrival.value, processOf(place, arrival.value)};
  if (const auto* info = dynamic_cast<const robotcontrol::FrameInfo*>(arrival.value.get()))
    message.frame = info->number();
  if (const auto* table = dynamic_cast<const KeyTable*>(arrival.value.get()); table && place.robot) {
    if (place.stream == streams::kKeys) {
      place.robot->keys.setTable(*table);
      for (const std::string& key : place.robot->keys.takeUnsent()) sendChoice(*place.robot, key);
      hasChanged = true;
    }
    message.value = std::make_shared<const KeyTable>(place.robot->keys.shown(*table));
  }
  message.value = shownSteering(message.path, message.value);
  message.time = timeOf(message.path, arrival.time, isLatched(message));
  if (hasGap && !isLatched(message)) endGap(message.time);
  enter(std::move(message));
}

void RemoteSession::enter(StreamMessage message) {
  message.bytes = sizeOf(message);
  latched.take(message);
  newestOf[message.path].mapped = message.time;
  if (options.passed) options.passed(message);
  session.push(std::move(message));
}

Instant RemoteSession::timeOf(const std::string& path, Instant remote, bool latchedMessage) {
  const auto leading = options.leadingTime ? options.leadingTime() : std::nullopt;
  remote = std::max(remote, Instant());
  const auto known = newestOf.find(path);
  const Duration disorder = isOurs && isOfWorld(path) ? Duration(0) : kReset;
  const bool hadTime = shift.hasTime();
  const auto before = shift.newest();
  if (known != newestOf.end() && !latchedMessage && known->second.remote != Instant::min() &&
      remote < known->second.remote - disorder) {
    shift.reset();
    // The history of a robot that leads is cut there; another one's continues.
    if (!leading)
      newestOf.clear();
    else
      for (auto& [other, times] : newestOf) times.remote = Instant::min();
  }
  // A server that continues to invent names.
  if (newestOf.size() >= kMaxPaths && known == newestOf.end()) newestOf.clear();
  Instant mapped = latchedMessage ? shift.mapLatched(remote, leading) : shift.map(remote, leading);
  if (!latchedMessage && !hadTime && !leading && before && mapped < *before - kReset) setBack(mapped);
  Times& times = newestOf[path];
  // Messages of several processes may come out of order.
  mapped = std::max(mapped, times.mapped);
  times = {remote, mapped};
  return mapped;
}

/// Corrects the times of messages before the first one with the robot's time: they are from before a reset.
void RemoteSession::setBack(Instant time) {
  for (auto& [path, times] : newestOf) times.mapped = std::min(times.mapped, time);
  for (StreamMessage& message : latched.all()) {
    if (message.time <= time) continue;
    message.time = time;
    enter(std::move(message));
  }
}

// ---- Subscriptions

bool RemoteSession::wants(const RemoteChannel& channel) {
  const RemoteRobotList::Place place = placeOf(channel);
  if (!channel.isDecoded || place.stream.empty() || isOtherCoding(channel)) return false;
  if (options.alsoWanted && options.alsoWanted(place.path())) return true;
  if (options.wantsNothingElse) return false;
  if (place.robot == nullptr) return leads();
  const RemoteKeys& keys = place.robot->keys;
  if (!isOurs) return !channel.isHeavy() || keys.wants(place.stream);
  if (keys.isOfKey(place.stream)) return keys.wants(place.stream);
  return keys.hasTable() || isAlways(place.stream);
}

/// Whether another channel has the same images in the coding that is wanted.
bool RemoteSession::isOtherCoding(const RemoteChannel& channel) const {
  const std::string_view wanted = wantedCoding();
  if (const auto coding = codingOf(channel); !coding.empty()) return coding != wanted;
  return !wanted.empty() && encoded.contains(channel.topic + std::string(wanted));
}

std::string_view RemoteSession::wantedCoding() const {
  switch (images) {
    case RemoteImages::kJpeg:
      return kJpegChannel;
    case RemoteImages::kPng:
      return kPngChannel;
    case RemoteImages::kAutomatic:
      return isNarrow ? kJpegChannel : "";
    default:
      return {};
  }
}

void RemoteSession::updateSubscriptions() {
  encoded.clear();
  for (const auto& [id, channel] : channels)
    if (isOurs && !codingOf(*channel).empty()) encoded.insert(channel->topic);
  // Before the first image comes.
  updateRates();
  std::set<std::string> wanted, unwanted;
  for (const auto& [id, channel] : channels) (wants(*channel) ? wanted : unwanted).insert(channel->topic);
  // A topic may have several channels, of which only one is decoded.
  std::erase_if(unwanted,
                [&](const std::string& topic) { return !topics.contains(topic) || wanted.contains(topic); });
  // First what is new, so that no key is switched off only to be switched on again.
  client->subscribe(wanted);
  client->unsubscribe(unwanted);
  for (const std::string& topic : unwanted) topics.erase(topic);
  topics.insert(wanted.begin(), wanted.end());
}

/// Sets the rates of images, which foreign servers do not support.
void RemoteSession::updateRates() {
  std::map<std::string, double> rates;
  for (const auto& [id, channel] : channels)
    if (isOurs && imageRate > 0 && isImage(*channel)) rates[channel->topic] = imageRate;
  if (!channels.empty() || imageRate == 0) client->setRates(std::move(rates));
}

/// The table as it is shown here has changed, if the robot has one.
void RemoteSession::pushKeys(RemoteRobotList::Robot& robot) {
  if (!robot.keys.hasTable()) return;
  const std::string path = robot.local + "/" + streams::kKeys;
  const auto table = std::make_shared<const KeyTable>(robot.keys.shown());
  enter({path, std::max(shift.newest().value_or(Instant()), newestOf[path].mapped), table});
}

}  // namespace robotlink::websocket
