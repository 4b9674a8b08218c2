// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/SessionServer.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <limits>
#include <set>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/session/ChannelSetups.h"
#include "robotlink/foxglove/session/KeyModeText.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/PostedWork.h"
#include "robotlink/foxglove/session/ProcessTables.h"
#include "robotlink/foxglove/session/RobotPath.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink::websocket {
namespace {

using google::protobuf::Message;
using robotcontrol::KeyTable;
using robotcontrol::ProcessTable;
using robotcontrol::Request;
using robotcontrol::SolutionTable;

/// A number that no client has.
constexpr std::uint64_t kNoClientHere = std::numeric_limits<std::uint64_t>::max();
/// The bytes that a link of 1 Mbit/s sends in 65 ms; and a size below that of images.
constexpr std::size_t kCalmBytes = 8U << 10U, kSmallBytes = 4U << 10U;
/// The interval of checking whether links keep up with what is sent.
constexpr Duration kLookAtLines = std::chrono::milliseconds(250);
constexpr char kRawImage[] = "foxglove.RawImage";

/// The time for which a channel is not replaced again by one of another type.
constexpr Duration kKeepType = std::chrono::seconds(1);

/// The number of ticks without anything new after which the session counts as paused.
constexpr int kStillTicks = 10;

bool fits(const StreamMessage& message, const ServerChannel& channel) {
  return message.value->GetDescriptor()->full_name() == channel.setup().schemaName;
}

}  // namespace

SessionServer::SessionServer(Session& session, ServerOptions options, Report report,
                             Steering::Limits steering)
    : session_(session),
      posted_(std::make_shared<Posted>()),
      keys_([this](const auto& robot, const auto& key, const auto& mode) { setMode(robot, key, mode); }),
      steering_(steering, steeringActions()) {
  options.publishesTime = true;
  options.metadata.emplace(kSessionKey, "1");
  options.limits.outbox.calmBytes = kCalmBytes;
  options.limits.outbox.smallBytes = kSmallBytes;
  server_ = Server::make(std::move(options), handlers(std::move(report)));
  offerServices("", robots_[""]);
  listener_ = session_.addListener({[this](const StreamMessage& message) { pass(message); },
                                    [this](const Request& request) {
                                      if (!isForwarding_)
                                        steering_.noteLocal(request, server_->clock().now());
                                      if (!request.has_set_key() || isChoosing_) return;
                                      keys_.noteChosen(request.robot(), request.set_key().name(),
                                                       request.set_key().mode());
                                    }});
  // Publish what the session has already.
  for (const StreamStore::Stream* stream : session_.store().streams()) {
    if (!stream->messages.empty()) pass(stream->messages.back());
  }
  updateRobots();
}

SessionServer::~SessionServer() {
  steering_.end();
  keys_.restoreAll();
  session_.removeListener(listener_);
  // Work that waits may hold the server, which holds this list.
  posted_->take();
}

bool SessionServer::isWanted(const std::string& path) const {
  const auto channel = channels_.find(path);
  return channel != channels_.end() && channel->second->isWanted();
}

void SessionServer::tick() {
  for (const Posted::Work& work : posted_->take()) work(*this);
  updateRobots();
  offerPlayback();
  getParameters();
  watchLinks();
  offerJpeg();
  publishSubscribers();
  if (++stillTicks_ > kStillTicks) publishUnheard();
  if (session_.store().newest() == newest_) return;
  stillTicks_ = 0;
  const Instant before = std::exchange(newest_, session_.store().newest());
  // Clients that come later get what is latched with a time that is not ahead of the session's.
  if (newest_ < before && !session_.store().streams().empty()) server_->setBackLatched(newest_);
  server_->publishTime(newest_);
}

// ---- From the session

void SessionServer::pass(const StreamMessage& message) {
  auto found = channels_.find(message.path);
  if (found != channels_.end() && !fits(message, *found->second)) {
    if (!removeOutdated(message.path)) return;
    found = channels_.end();
  }
  if (found == channels_.end()) {
    addChannels({setupOf(message.path, *message.value->GetDescriptor())});
    found = channels_.find(message.path);
  }
  if (found->second->isWanted()) found->second->publish(message.time, shownTo(message)->SerializeAsString());
  if (found->second->setup().schemaName == kRawImage)
    for (const auto& [coding, encoder] : encoders_) passEncoded(message, coding);
  unheard_.erase(message.path);
  notice(message);
}

/// A channel keeps its type, but another layout, or a remote robot, may publish something else on a path.
/// A publisher that alternates does not keep clients busy with it.
bool SessionServer::removeOutdated(const std::string& path) {
  const Instant now = server_->clock().now();
  const auto before = outdated_.find(path);
  if (before != outdated_.end() && now - before->second < kKeepType) return false;
  outdated_[path] = now;
  std::vector<ChannelPtr> removed;
  for (const std::string& each : {path, path + kJpegChannel, path + kPngChannel}) {
    const auto channel = channels_.find(each);
    const bool isOther = each != path && session_.store().find(each) != nullptr;
    if (channel == channels_.end() || isOther) continue;
    removed.push_back(channel->second);
    channels_.erase(channel);
  }
  server_->removeChannels(removed);
  const auto [robot, stream] = splitAtSlash(path);
  keys_.setSubscribers(robot, stream, {});
  offerOnDemand(robot);
  return true;
}

/// A key that is on for a client alone would otherwise look as if the robot wanted it to be, also to that
/// client, whose subscription would then keep it on.
PackagePtr SessionServer::withOwnModes(const std::string& robot, const KeyTable& table) const {
  const auto known = robots_.find(robot);
  auto shown = std::make_shared<KeyTable>(table);
  for (auto& key : *shown->mutable_keys()) {
    if (known == robots_.end() || !known->second.onDemand.contains(key.name())) continue;
    const auto own = keys_.ownMode(robot, key.name());
    *key.mutable_mode() = own.value_or(robotcontrol::KeyMode());
  }
  return shown;
}

PackagePtr SessionServer::shownTo(const StreamMessage& message) const {
  const auto* keys = dynamic_cast<const KeyTable*>(message.value.get());
  if (keys != nullptr) return withOwnModes(splitAtSlash(message.path).first, *keys);
  const auto* status = dynamic_cast<const robotcontrol::SteeringStatus*>(message.value.get());
  const std::string robot = splitAtSlash(message.path).first;
  if (status == nullptr || !isElsewhere(robot)) return message.value;
  auto shown = std::make_shared<robotcontrol::SteeringStatus>(*status);
  shown->set_own(false);
  if (status->own()) {
    const Steering::Status here = steering_.status(robot);
    shown->set_client(here.client);
    if (!here.who.empty()) shown->set_who(here.who);
  } else if (status->client() != 0) {
    shown->set_client(kNoClientHere);
  }
  return shown;
}

void SessionServer::addChannels(std::vector<ChannelSetup> setups) {
  for (std::size_t i = 0, count = setups.size(); i < count; ++i) {
    if (setups[i].schemaName != kRawImage) continue;
    for (const auto& [coding, encoder] : encoders_) {
      std::string path = setups[i].topic + coding;
      if (!channels_.contains(path))
        setups.push_back(setupOf(path, *foxglove::CompressedImage::descriptor()));
    }
  }
  for (const ChannelPtr& channel : server_->addChannels(std::move(setups)))
    channels_.emplace(channel->setup().topic, channel);
}

void SessionServer::setImageEncoders(ImageEncoders encoders) {
  encoders_ = std::move(encoders);
  encoding_ = std::make_unique<ImageEncoding>();
  std::vector<ChannelSetup> setups;
  for (const auto& [path, channel] : channels_) {
    if (channel->setup().schemaName != kRawImage) continue;
    for (const auto& [coding, encoder] : encoders_)
      if (!channels_.contains(path + coding))
        setups.push_back(setupOf(path + coding, *foxglove::CompressedImage::descriptor()));
  }
  if (!setups.empty()) addChannels(std::move(setups));
}

void SessionServer::passEncoded(const StreamMessage& message, const std::string& coding) {
  const auto found = channels_.find(message.path + coding);
  if (found == channels_.end() || !found->second->isWanted()) return;
  encoding_->post(found->second, message.time, message.value, encoders_.at(coding));
}

void SessionServer::finishImages() {
  if (encoding_) encoding_->finish();
}

std::string SessionServer::codingOf(const std::string& path) const {
  const auto found =
      std::ranges::find_if(encoders_, [&](const auto& encoder) { return path.ends_with(encoder.first); });
  return found == encoders_.end() ? std::string() : found->first;
}

/// Publishes for clients that subscribe in a pause, in which nothing new is published.
void SessionServer::publishUnheard() {
  for (const std::string& path : std::exchange(unheard_, {})) {
    const auto channel = channels_.find(path);
    if (channel == channels_.end() || channel->second->setup().latched) continue;
    const std::string coding = codingOf(path);
    const StreamMessage* newest =
        session_.store().latest(path.substr(0, path.size() - coding.size()), Instant::max());
    if (newest == nullptr) continue;
    if (!coding.empty()) {
      passEncoded(*newest, coding);
    } else if (fits(*newest, *channel->second)) {
      channel->second->publish(newest->time, newest->value->SerializeAsString());
    }
  }
}

void SessionServer::notice(const StreamMessage& message) {
  const auto [robot, stream] = splitAtSlash(message.path);
  if (stream.starts_with("tables/")) noticeTable(robot, stream, *message.value);
  if (!stream.starts_with(streams::kParameters)) return;
  const auto* values = dynamic_cast<const robotcontrol::ParameterValues*>(message.value.get());
  if (values != nullptr) server_->updateParameters(modules_.take(robot, *values));
}

void SessionServer::noticeTable(const std::string& robot, const std::string& stream, const Message& value) {
  Robot& known = robots_[robot];
  // A remote robot may publish anything on these paths.
  if (const auto* keys = dynamic_cast<const KeyTable*>(&value); keys && stream == streams::kKeys) {
    known.keys = *keys;
    keys_.setTable(robot, known.keys);
    offerKeyChannels(robot, known);
    std::map<std::string, std::string> modes;
    for (const auto& key : known.keys.keys()) modes[key.name()] = textOf(key.mode());
    offerParameters(robot, known, kKeysGroup, modes);
    offerOnDemand(robot);
  }
  if (const auto* table = dynamic_cast<const SolutionTable*>(&value);
      table && stream == streams::kSolutions) {
    std::map<std::string, std::string> active;
    for (const auto& task : table->tasks()) active[task.name()] = task.active();
    offerParameters(robot, known, kSolutionsGroup, active);
    server_->updateParameters(modules_.keep(robot, *table));
  }
  const auto* processes = dynamic_cast<const ProcessTable*>(&value);
  if (processes != nullptr && stream == streams::kProcesses) noticeProcesses(robot, *processes, known);
}

void SessionServer::noticeProcesses(const std::string& robot, const ProcessTable& table, Robot& to) {
  to.graph = graphOf(robot, table);
  offerGraph();
  to.processes = table;
  offerKeyChannels(robot, to);
}

void SessionServer::offerGraph() {
  ConnectionGraph all;
  for (const auto& [name, robot] : robots_) {
    all.publishedTopics.insert(robot.graph.publishedTopics.begin(), robot.graph.publishedTopics.end());
    all.subscribedTopics.insert(robot.graph.subscribedTopics.begin(), robot.graph.subscribedTopics.end());
  }
  server_->setConnectionGraph(std::move(all));
}

void SessionServer::offerKeyChannels(const std::string& robot, const Robot& from) {
  auto setups = keyChannels(robot, from.keys, from.processes,
                            [this](const std::string& path) { return channels_.contains(path); });
  if (!setups.empty()) addChannels(std::move(setups));
}

void SessionServer::offerParameters(const std::string& robot, Robot& to, const std::string& group,
                                    const std::map<std::string, std::string>& values) {
  std::vector<Parameter> parameters;
  std::set<std::string> names;
  for (const auto& [name, value] : values) {
    const std::string full = robot + "/" + group + "/" + name;
    names.insert(full);
    parameters.push_back({full, Value{value}});
  }
  for (const std::string& old : std::exchange(to.parameters[group], names)) {
    if (!names.contains(old)) parameters.push_back({old, std::nullopt});
  }
  server_->updateParameters(parameters);
}

void SessionServer::offerOnDemand(const std::string& robot) {
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return;
  std::map<std::string, std::string> values;
  std::set<std::string> names;
  for (const auto& [key, clients] : keys_.onDemand(robot)) {
    names.insert(key);
    for (const std::string& client : clients) {
      std::string& who = values[key];
      who += (who.empty() ? "" : ", ") + client;
    }
  }
  offerParameters(robot, known->second, kOnDemandGroup, values);
  if (std::exchange(known->second.onDemand, names) == names) return;
  for (const auto& [path, channel] : channels_) {
    if (!path.starts_with(robot + "/" + streams::kKeys) || !channel->isWanted()) continue;
    const StreamMessage* newest = session_.store().latest(path, Instant::max());
    if (newest != nullptr && fits(*newest, *channel))
      channel->publish(newest->time, shownTo(*newest)->SerializeAsString());
  }
}

void SessionServer::updateRobots() {
  for (const std::string& name : session_.robots()) {
    Robot& robot = robots_[name];
    if (!robot.services.empty()) continue;
    offerServices(name, robot);
    offerSteering(name, robot);
    // Created before use, so that the first text, and the first person who steers, find subscribers.
    const std::string log = name + "/" + streams::kLog, steering = name + "/" + streams::kSteering;
    if (!channels_.contains(log)) addChannels({setupOf(log, *foxglove::Log::descriptor())});
    if (!channels_.contains(steering))
      addChannels({setupOf(steering, *robotcontrol::SteeringStatus::descriptor())});
  }
  const std::size_t before = robots_.size();
  for (auto robot = robots_.begin(); robot != robots_.end();) {
    const auto& [name, known] = *robot;
    const bool isGone = !name.empty() && !known.services.empty() &&
                        std::ranges::find(session_.robots(), name) == session_.robots().end();
    if (isGone) removeRobot(name, robot->second);
    robot = isGone ? robots_.erase(robot) : std::next(robot);
  }
  if (robots_.size() < before) offerGraph();
}

/// Removes a robot with all that clients know of it.
void SessionServer::removeRobot(const std::string& name, Robot& robot) {
  for (const std::uint32_t service : robot.services) server_->removeService(service);
  for (const auto& [group, names] : std::map(robot.parameters)) offerParameters(name, robot, group, {});
  server_->updateParameters(modules_.remove(name));
  steering_.remove(name);
  keys_.forgetSubscribers(name);
  std::vector<ChannelPtr> channels;
  std::erase_if(channels_, [&](const auto& channel) {
    if (!channel.first.starts_with(name + "/")) return false;
    channels.push_back(channel.second);
    return true;
  });
  server_->removeChannels(channels);
}

// ---- The consequences of clients' actions

/// Requests the parameters that can be set as soon as a client is there that may want to know them.
void SessionServer::getParameters() {
  constexpr int kAtOnce = 4;
  if (clients_.empty()) return;
  for (auto& [name, robot] : robots_) {
    while (robot.asking < kAtOnce) {
      auto wanted = modules_.nextToGet(name);
      if (!wanted) break;
      ++robot.asking;
      request(std::move(*wanted), [this, of = name](const robotcontrol::RequestResult&) {
        if (const auto known = robots_.find(of); known != robots_.end()) --known->second.asking;
      });
    }
  }
}

Steering::Actions SessionServer::steeringActions() {
  return {
      [this](const Request& wanted, std::function<void(bool)> isDone) {
        request(wanted, [isDone = std::move(isDone)](const auto& result) { isDone(result.accepted()); });
      },
      [this](const std::string& robot, const Steering::Status& status) { publishSteering(robot, status); },
      [this](std::uint64_t client) { return server_->heardAt(client); }};
}

void SessionServer::steer(const std::string& robot, bool giveUp) {
  if (giveUp) return steering_.giveUpHere(robot);
  steering_.takeOverHere(robot, server_->clock().now());
}

void SessionServer::watchLinks() {
  // Several signs of life must be missing before a link counts as silent.
  server_->watch(steering_.clients(), steering_.limits().linkTime / 4);
  steering_.tick(server_->clock().now());
}

void SessionServer::offerJpeg() {
  const Instant now = server_->clock().now();
  if (!encoders_.contains(kJpegChannel) || clients_.empty() || now - lookedAtLines_ < kLookAtLines) return;
  lookedAtLines_ = now;
  std::set<std::string> topics;
  for (const auto& [path, channel] : channels_)
    if (channel->setup().schemaName == kRawImage) topics.insert(path);
  for (const auto& found : narrowLines_.look(server_->clients(), topics, now))
    server_->sendStatus(found.client, {StatusLevel::kInfo, found.text, kNarrowStatus + found.topic});
}

void SessionServer::publishSteering(const std::string& robot, const Steering::Status& status) {
  const std::string path = robot + "/" + streams::kSteering;
  if (isElsewhere(robot)) {
    // The session's message comes from the other server; clients are told again which of them steers.
    const StreamMessage* message = session_.store().latest(path, Instant::max());
    const auto channel = channels_.find(path);
    if (message != nullptr && channel != channels_.end() && channel->second->isWanted())
      channel->second->publish(message->time, shownTo(*message)->SerializeAsString());
    return;
  }
  auto message = std::make_shared<robotcontrol::SteeringStatus>();
  const Instant time = session_.store().newest();
  assign(*message->mutable_timestamp(), time);
  message->set_who(status.who);
  message->set_client(status.client);
  message->set_silent(status.isSilent);
  message->set_text(status.text);
  session_.push({path, time, std::move(message)});
}

void SessionServer::publishSubscribers() {
  for (auto& [name, robot] : robots_) {
    // For a remote robot, this session is one of those who ask.
    if (name.empty() || isElsewhere(name) || !keys_.takeChanged(name)) continue;
    auto subscribers = keys_.clientsByKey(name);
    if (subscribers == robot.subscribers) continue;
    robot.subscribers = std::move(subscribers);
    auto message = std::make_shared<robotcontrol::KeySubscribers>();
    const Instant time = session_.store().newest();
    assign(*message->mutable_timestamp(), time);
    for (const auto& [key, clients] : robot.subscribers) {
      auto& row = *message->add_keys();
      row.set_name(key);
      for (const std::string& client : clients) row.add_clients(client);
    }
    session_.push({name + "/" + streams::kSubscribers, time, std::move(message)});
  }
}

}  // namespace robotlink::websocket
