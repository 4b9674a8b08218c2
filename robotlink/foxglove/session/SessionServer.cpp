// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/SessionServer.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <array>
#include <set>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/session/KeyModeText.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/RequestServices.h"
#include "robotlink/packages/Schema.h"
#include "robotlink/session/LatchedMessages.h"

namespace robotlink::websocket {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using robotcontrol::ControlReplay;
using robotcontrol::KeyTable;
using robotcontrol::ProcessTable;
using robotcontrol::ReplayStatus;
using robotcontrol::Request;
using robotcontrol::RequestResult;
using robotcontrol::SolutionTable;

/// What a line of 1 Mbit/s sends in 65 ms.
constexpr std::size_t kCalmBytes = 8U << 10U;
constexpr char kKeysGroup[] = "keys", kSolutionsGroup[] = "solutions";

struct StreamType {
  const char* prefix;
  const char* type;
};
/// What is published on the streams of debug keys that are not packages.
constexpr std::array kStreamTypes{StreamType{streams::kImageDrawings, "foxglove.ImageAnnotations"},
                                  StreamType{streams::kFieldDrawings, "foxglove.SceneUpdate"},
                                  StreamType{streams::kRobotDrawings, "foxglove.SceneUpdate"},
                                  StreamType{streams::kImages, "foxglove.RawImage"},
                                  StreamType{streams::kPlots, "robotcontrol.PlotValue"}};
/// Beside what is latched: types of which no message may be replaced by a newer one.
constexpr std::array kCompleteTypes{"foxglove.Log", "foxglove.Event", "robotcontrol.PlotValue",
                                    "robotcontrol.Request", "robotcontrol.LinkPackets"};

ChannelSetup setupOf(const std::string& path, const Descriptor& type) {
  ChannelSetup setup{path, "protobuf", type.full_name(), schemaOf(type)};
  setup.latched = isLatched(path, type.full_name());
  const bool complete =
      setup.latched || std::ranges::find(kCompleteTypes, type.full_name()) != kCompleteTypes.end();
  setup.delivery = complete ? Delivery::kComplete : Delivery::kLatest;
  return setup;
}

/// A name in front of the first slash, and what follows it.
std::pair<std::string, std::string> splitAtSlash(const std::string& path) {
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) return {"", path};
  return {path.substr(0, slash), path.substr(slash + 1)};
}

/// Answers when the results of several requests have come: with the first reason against one of them.
class JointReply {
 public:
  JointReply(Reply reply, std::size_t count) : reply_(std::move(reply)), left_(count) {}
  void add(const RequestResult& result) {
    if (!result.accepted()) reply_.fail(result.reason());
    if (--left_ == 0) reply_.succeed();
  }

 private:
  Reply reply_;
  std::size_t left_;
};

}  // namespace

/// Filled by the link's thread, emptied by tick(); outlives the SessionServer with the server's handlers.
struct SessionServer::Posted {
  using Work = std::function<void(SessionServer&)>;
  void add(Work work) {
    const std::lock_guard lock(mutex);
    waiting.push_back(std::move(work));
  }
  std::vector<Work> take() {
    const std::lock_guard lock(mutex);
    return std::exchange(waiting, {});
  }

  std::mutex mutex;
  std::vector<Work> waiting;
};

SessionServer::SessionServer(Session& session, ServerOptions options, Report report)
    : session_(session),
      posted_(std::make_shared<Posted>()),
      keys_([this](const std::string& robot, const std::string& key, const robotcontrol::KeyMode& mode) {
        Request request;
        request.set_robot(robot);
        request.mutable_set_key()->set_name(key);
        *request.mutable_set_key()->mutable_mode() = mode;
        session_.request(std::move(request));
      }) {
  options.publishesTime = true;
  options.metadata.emplace(kSessionKey, "1");
  options.limits.outbox.calmBytes = kCalmBytes;
  server_ = Server::make(std::move(options), handlers(std::move(report)));
  offerServices("", robots_[""]);
  listener_ = session_.addListener({[this](const StreamMessage& message) { pass(message); },
                                    [this](const Request& request) {
                                      if (!request.has_set_key()) return;
                                      keys_.noteChosen(request.robot(), request.set_key().name(),
                                                       request.set_key().mode());
                                    }});
  // What the session has already.
  for (const StreamStore::Stream* stream : session_.store().streams()) {
    if (!stream->messages.empty()) pass(stream->messages.back());
  }
  updateRobots();
}

SessionServer::~SessionServer() {
  session_.removeListener(listener_);
  // What waits may hold the server, which holds this list.
  static_cast<void>(posted_->take());
}

ServerHandlers SessionServer::handlers(Report report) {
  const auto post = [posted = posted_](Posted::Work work) { posted->add(std::move(work)); };
  ServerHandlers handlers;
  handlers.report = std::move(report);
  handlers.subscribersChanged = [post](const ChannelPtr& channel, const std::vector<ClientInfo>& clients) {
    std::set<std::string> names;
    for (const ClientInfo& client : clients) names.insert(client.address);
    post([path = channel->setup().topic, names](SessionServer& self) {
      const auto [robot, stream] = splitAtSlash(path);
      self.keys_.setSubscribers(robot, stream, names);
      self.offerOnDemand(robot);
    });
  };
  handlers.setParameters = [post](const ClientInfo&, const std::vector<Parameter>& parameters, Reply reply) {
    post([parameters, reply](SessionServer& self) { self.set(parameters, reply); });
  };
  handlers.playbackControl = [post](const ClientInfo&, const PlaybackControl& control) {
    post([control](SessionServer& self) { self.play(control); });
  };
  return handlers;
}

void SessionServer::tick() {
  for (const Posted::Work& work : posted_->take()) work(*this);
  updateRobots();
  offerPlayback();
  if (session_.store().newest() == newest_) return;
  newest_ = session_.store().newest();
  server_->publishTime(newest_);
}

// ---- From the session

void SessionServer::pass(const StreamMessage& message) {
  auto found = channels_.find(message.path);
  if (found == channels_.end()) {
    const auto made = server_->addChannels({setupOf(message.path, *message.value->GetDescriptor())});
    found = channels_.emplace(message.path, made.front()).first;
  }
  if (found->second->isWanted()) found->second->publish(message.time, message.value->SerializeAsString());
  notice(message);
}

void SessionServer::notice(const StreamMessage& message) {
  const auto [robot, stream] = splitAtSlash(message.path);
  if (!stream.starts_with("tables/")) return;
  Robot& known = robots_[robot];
  if (stream == streams::kKeys) {
    known.keys = dynamic_cast<const KeyTable&>(*message.value);
    keys_.setTable(robot, known.keys);
    offerKeyChannels(robot, known);
    std::map<std::string, std::string> modes;
    for (const auto& key : known.keys.keys()) modes[key.name()] = textOf(key.mode());
    offerParameters(robot, known, kKeysGroup, modes);
    offerOnDemand(robot);
  } else if (stream == streams::kSolutions) {
    std::map<std::string, std::string> active;
    for (const auto& task : dynamic_cast<const SolutionTable&>(*message.value).tasks()) {
      active[task.name()] = task.active();
    }
    offerParameters(robot, known, kSolutionsGroup, active);
  } else if (stream == streams::kProcesses) {
    noticeProcesses(robot, dynamic_cast<const ProcessTable&>(*message.value), known);
  }
}

void SessionServer::noticeProcesses(const std::string& robot, const ProcessTable& table, Robot& to) {
  ConnectionGraph graph;
  std::map<std::string, std::string> types;
  for (const auto& process : table.processes()) {
    const std::string id = robot + "/" + process.name();
    for (const auto& port : process.senders()) {
      graph.publishedTopics[robot + "/" + port.package()].push_back(id);
      types[port.package()] = port.type();
    }
    for (const auto& port : process.receivers()) {
      graph.subscribedTopics[robot + "/" + port.package()].push_back(id);
      types[port.package()] = port.type();
    }
  }
  to.graph = std::move(graph);
  ConnectionGraph all;
  for (const auto& [name, other] : robots_) {
    all.publishedTopics.insert(other.graph.publishedTopics.begin(), other.graph.publishedTopics.end());
    all.subscribedTopics.insert(other.graph.subscribedTopics.begin(), other.graph.subscribedTopics.end());
  }
  server_->setConnectionGraph(std::move(all));
  if (types == to.packageTypes) return;
  to.packageTypes = std::move(types);
  offerKeyChannels(robot, to);
}

void SessionServer::offerPlayback() {
  const StreamMessage* newest = session_.store().latest(streams::kReplay, Instant::max());
  const auto* status = newest == nullptr ? nullptr : dynamic_cast<const ReplayStatus*>(newest->value.get());
  if (status == nullptr) {
    replay_.reset();
    return server_->setPlayable({});
  }
  server_->setPlayable(TimeRange{Instant(Duration(status->begin())), Instant(Duration(status->end()))});
  if (plays_ > 0 || newest->value == replay_) return;
  // A jump replaces the history.
  publishPlayback(replay_ && session_.store().generation() != generation_, {});
}

void SessionServer::publishPlayback(bool didSeek, const std::string& requestId) {
  const StreamMessage* newest = session_.store().latest(streams::kReplay, Instant::max());
  const auto* known = newest == nullptr ? nullptr : dynamic_cast<const ReplayStatus*>(newest->value.get());
  if (known == nullptr) return;
  replay_ = newest->value;
  generation_ = session_.store().generation();
  const ReplayStatus& status = *known;
  using Phase = PlaybackState::Phase;
  const bool ended = !status.playing() && status.time() >= status.end();
  const Phase phase = status.playing() ? Phase::kPlaying : ended ? Phase::kEnded : Phase::kPaused;
  server_->publishPlaybackState(
      {phase, Instant(Duration(status.time())), static_cast<float>(status.speed()), didSeek, requestId});
}

void SessionServer::offerKeyChannels(const std::string& robot, const Robot& from) {
  std::vector<ChannelSetup> setups;
  for (const auto& key : from.keys.keys()) {
    const std::string path = robot + "/" + key.stream();
    if (key.stream().empty() || channels_.contains(path)) continue;
    const auto known = std::ranges::find_if(
        kStreamTypes, [&](const StreamType& type) { return key.stream().starts_with(type.prefix); });
    const auto package = from.packageTypes.find(key.stream());
    std::string type;
    if (known != kStreamTypes.end()) type = known->type;
    if (package != from.packageTypes.end()) type = package->second;
    const Descriptor* descriptor = DescriptorPool::generated_pool()->FindMessageTypeByName(type);
    if (descriptor != nullptr) setups.push_back(setupOf(path, *descriptor));
  }
  if (setups.empty()) return;
  for (const ChannelPtr& channel : server_->addChannels(std::move(setups))) {
    channels_.emplace(channel->setup().topic, channel);
  }
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
  for (const auto& [key, clients] : keys_.onDemand(robot)) {
    std::string& names = values[key];
    for (const std::string& client : clients) names += (names.empty() ? "" : ", ") + client;
  }
  offerParameters(robot, known->second, kOnDemandGroup, values);
}

void SessionServer::updateRobots() {
  for (const std::string& name : session_.robots()) {
    Robot& robot = robots_[name];
    if (!robot.services.empty()) continue;
    offerServices(name, robot);
    // So that its first text finds its subscribers.
    const std::string path = name + "/" + streams::kLog;
    if (!channels_.contains(path))
      channels_.emplace(path, server_->addChannels({setupOf(path, *foxglove::Log::descriptor())}).front());
  }
  // Those that are gone, with all their channels.
  for (auto robot = robots_.begin(); robot != robots_.end();) {
    const std::string& name = robot->first;
    const bool isGone = !name.empty() && !robot->second.services.empty() &&
                        std::ranges::find(session_.robots(), name) == session_.robots().end();
    if (!isGone) {
      ++robot;
      continue;
    }
    for (const std::uint32_t service : robot->second.services) server_->removeService(service);
    for (const auto& [group, names] : std::map(robot->second.parameters)) {
      offerParameters(name, robot->second, group, {});
    }
    std::vector<ChannelPtr> channels;
    std::erase_if(channels_, [&](const auto& channel) {
      if (!channel.first.starts_with(name + "/")) return false;
      channels.push_back(channel.second);
      return true;
    });
    server_->removeChannels(channels);
    robot = robots_.erase(robot);
  }
}

void SessionServer::offerServices(const std::string& robot, Robot& to) {
  for (Service& service : requestServices(robot)) {
    const std::string name = service.name;
    to.services.push_back(server_->addService(
        std::move(service),
        [posted = posted_, robot, name](const ClientInfo&, const ServiceCallRequest& call, Reply reply) {
          // The payload is a part of the client's message, which goes.
          const auto payload = std::make_shared<const std::string>(call.payload);
          posted->add([=](SessionServer& self) {
            ServiceCallRequest kept = call;
            kept.payload = *payload;
            self.call(robot, name, kept, reply);
          });
        }));
  }
}

// ---- From clients

void SessionServer::call(const std::string& robot, const std::string& service, const ServiceCallRequest& call,
                         const Reply& reply) {
  Result<Request> request = requestOf(robot, service, call);
  if (!request) return reply.fail(request.error().text);
  session_.request(std::move(*request), [reply, encoding = call.encoding](const RequestResult& result) {
    reply.succeed(encodeResult(result, encoding), encoding);
  });
}

void SessionServer::play(const PlaybackControl& control) {
  const auto refuse = [this](const RequestResult& result) {
    if (!result.accepted()) server_->publishStatus({StatusLevel::kWarning, result.reason(), {}});
  };
  if (control.seek) {
    Request jump;
    jump.mutable_control_replay()->set_action(ControlReplay::JUMP_TO_TIME);
    jump.mutable_control_replay()->set_time(control.seek->time_since_epoch().count());
    session_.request(std::move(jump), refuse);
  }
  Request act;
  const bool plays = control.command == PlaybackControl::Command::kPlay;
  act.mutable_control_replay()->set_action(plays ? ControlReplay::PLAY : ControlReplay::PAUSE);
  act.mutable_control_replay()->set_speed(static_cast<double>(control.speed));
  ++plays_;
  session_.request(std::move(act), [this, refuse, control](const RequestResult& result) {
    refuse(result);
    --plays_;
    publishPlayback(control.seek.has_value(), control.requestId);
  });
}

Result<Request> SessionServer::requestFor(const Parameter& parameter) const {
  const auto [robot, rest] = splitAtSlash(parameter.name);
  const auto [group, name] = splitAtSlash(rest);
  const auto known = robots_.find(robot);
  const auto names = known == robots_.end() ? decltype(Robot::parameters)::const_iterator{}
                                            : known->second.parameters.find(group);
  if (known == robots_.end() || names == known->second.parameters.end() || group == kOnDemandGroup ||
      !names->second.contains(parameter.name)) {
    return failure("foxglove.parameter", "there is no parameter '" + parameter.name + "' that can be set");
  }
  const auto* text = parameter.value ? std::get_if<std::string>(&parameter.value->data) : nullptr;
  if (text == nullptr)
    return failure("foxglove.parameter", "the value of '" + parameter.name + "' is a text");
  Request request;
  request.set_robot(robot);
  if (group == kSolutionsGroup) {
    request.mutable_select_solution()->set_task(name);
    request.mutable_select_solution()->set_solution(*text);
    return request;
  }
  auto mode = keyModeOf(*text);
  if (!mode) return tl::unexpected(mode.error());
  request.mutable_set_key()->set_name(name);
  *request.mutable_set_key()->mutable_mode() = *mode;
  return request;
}

void SessionServer::set(const std::vector<Parameter>& parameters, const Reply& reply) {
  std::vector<Request> requests;
  for (const Parameter& parameter : parameters) {
    Result<Request> request = requestFor(parameter);
    if (!request) return reply.fail(request.error().text);
    requests.push_back(std::move(*request));
  }
  const auto joint = std::make_shared<JointReply>(reply, requests.size());
  for (std::size_t i = 0; i < requests.size(); ++i) {
    session_.request(std::move(requests[i]),
                     [this, joint, parameter = parameters[i]](const RequestResult& result) {
                       // The robot's table follows; who asked shall see it at once.
                       if (result.accepted()) server_->updateParameters({parameter});
                       joint->add(result);
                     });
  }
}

}  // namespace robotlink::websocket
