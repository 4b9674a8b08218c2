// SPDX-License-Identifier: GPL-3.0-or-later
// The requests of clients of a SessionServer.
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <utility>

#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/session/ClientCommands.h"
#include "robotlink/foxglove/session/KeyModeText.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/PostedWork.h"
#include "robotlink/foxglove/session/RequestServices.h"
#include "robotlink/foxglove/session/RobotPath.h"
#include "robotlink/foxglove/session/SessionServer.h"

namespace robotlink::websocket {
namespace {

using robotcontrol::Request;
using robotcontrol::RequestResult;

/// Answers when the results of several requests are known: with the first reason against one of them.
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

/// Services that change nothing, and STOP.
ServiceAccess accessTo(const std::string& service) {
  const bool isForAll =
      service.ends_with("stop") || service.ends_with("get_parameters") || service.ends_with("send_tables");
  return isForAll ? ServiceAccess::kAnybody : ServiceAccess::kControl;
}

void answer(const Reply& reply, const std::string& encoding, const std::string& refusal) {
  RequestResult result;
  result.set_accepted(refusal.empty());
  result.set_reason(refusal);
  reply.succeed(encodeResult(result, encoding), encoding);
}

}  // namespace

ServerHandlers SessionServer::handlers(Report report) {
  ServerHandlers handlers;
  handlers.report = std::move(report);
  handlers.subscribersChanged = [posted = posted_](const ChannelPtr& channel,
                                                   const std::vector<ClientInfo>& clients) {
    std::set<std::string> names;
    for (const ClientInfo& client : clients) names.insert(shownName(client));
    const std::string path = channel->setup().topic;
    posted->addState("subscribers of " + path, [path, names](SessionServer& self) {
      const auto [robot, stream] = splitAtSlash(path);
      self.keys_.setSubscribers(robot, stream, names);
      if (!names.empty()) self.unheard_.insert(path);
      self.offerOnDemand(robot);
    });
  };
  handlers.clientsChanged = [posted = posted_](const std::vector<ClientInfo>& clients) {
    posted->addState("clients", [clients](SessionServer& self) { self.noteClients(clients); });
  };
  handlers.setParameters = [posted = posted_](const ClientInfo& client,
                                              const std::vector<Parameter>& parameters, Reply reply) {
    const std::size_t bytes = encode(ParameterValues{parameters, ""}).bytes.size();
    const auto work = [client, parameters, reply](SessionServer& self) {
      self.set(client, parameters, reply);
    };
    if (!posted->add(work, bytes)) reply.fail(PostedWork::kRefusal);
  };
  handlers.playbackControl = [posted = posted_](const ClientInfo&, const PlaybackControl& control) {
    posted->add([control](SessionServer& self) { self.play(control); });
  };
  handlers.clientAdvertised = [posted = posted_](const ClientInfo& client, const ClientChannel& channel) {
    posted->add([client, channel](SessionServer& self) {
      const std::string why = self.problemOf(channel);
      if (!why.empty()) self.server_->sendStatus(client.id, {StatusLevel::kWarning, why, ""});
    });
  };
  handlers.clientMessage = [posted = posted_](const ClientInfo& client, const ClientChannel& channel,
                                              std::string_view payload) {
    posted->addNewest(client.id, channel.topic,
                      [client, channel, kept = std::string(payload)](SessionServer& self) {
                        self.command(client, channel, kept);
                      });
  };
  return handlers;
}

void SessionServer::noteClients(const std::vector<ClientInfo>& clients) {
  std::set<std::uint64_t> ids;
  std::set<std::string> names;
  for (const ClientInfo& client : clients) {
    ids.insert(client.id);
    names.insert(shownName(client));
    if (!clients_.contains(client.id)) steering_.joined(client);
  }
  clients_ = std::move(ids);
  keys_.setClients(names);
  for (const auto& [name, robot] : robots_) offerOnDemand(name);
  std::erase_if(complaints_,
                [this](const auto& reported) { return !clients_.contains(reported.first.first); });
}

void SessionServer::request(Request wanted, std::function<void(const RequestResult&)> onResult) {
  if (std::string why = wrongFromElsewhere(wanted); !why.empty()) {
    RequestResult refusal;
    refusal.set_reason(std::move(why));
    return onResult(refusal);
  }
  isForwarding_ = true;
  session_.request(std::move(wanted), [alive = std::weak_ptr(alive_),
                                       onResult = std::move(onResult)](const RequestResult& result) {
    if (!alive.expired()) onResult(result);
  });
  isForwarding_ = false;
}

// ---- Services

std::uint32_t SessionServer::addService(Service service, const std::string& robot, ServiceAccess access,
                                        bool isUrgent, ServiceHandlerOf handler) {
  const std::string name = service.name;
  return server_->addService(
      std::move(service),
      [posted = posted_, robot, name, isUrgent, handler](const ClientInfo& client,
                                                         const ServiceCallRequest& call, const Reply& reply) {
        // The payload is a part of the client's message, which goes.
        const auto payload = std::make_shared<const std::string>(call.payload);
        const auto work = [=](SessionServer& self) {
          ServiceCallRequest kept = call;
          kept.payload = *payload;
          (self.*handler)(robot, name, client, kept, reply);
        };
        const bool isTaken = isUrgent ? posted->addUrgent(work) : posted->add(work, payload->size());
        if (!isTaken) reply.fail(PostedWork::kRefusal);
      },
      access);
}

void SessionServer::offerServices(const std::string& robot, Robot& to) {
  for (Service& service : requestServices(robot)) {
    if (withheld_.contains(service.name)) continue;
    const std::string kind = splitAtSlash(service.name).second;
    to.services.push_back(
        addService(std::move(service), robot, accessTo(kind), kind == "stop", &SessionServer::call));
  }
}

void SessionServer::withhold(const std::string& request) {
  withheld_.insert(request);
  Robot& world = robots_[""];
  for (const std::uint32_t service : std::exchange(world.services, {})) server_->removeService(service);
  offerServices("", world);
}

void SessionServer::offerSteering(const std::string& robot, Robot& to) {
  to.services.push_back(
      addService(steerService(robot), robot, ServiceAccess::kControl, false, &SessionServer::steer));
}

void SessionServer::call(const std::string& robot, const std::string& service, const ClientInfo& client,
                         const ServiceCallRequest& call, const Reply& reply) {
  Result<Request> wanted = requestOf(robot, service, call);
  if (!wanted) return reply.fail(wanted.error().text);
  if (client.isReadOnly && wanted->has_stop() && !engagesStop(*wanted))
    return answer(reply, call.encoding,
                  "you may only watch: anyone may engage STOP, but only clients with control may release it");
  if (Steering::isSteering(*wanted)) {
    const std::string why = steering_.admit(client, *wanted, server_->clock().now());
    if (!why.empty()) return answer(reply, call.encoding, why);
  }
  const auto onResult = [reply, encoding = call.encoding](const RequestResult& result) {
    reply.succeed(encodeResult(result, encoding), encoding);
  };
  if (!wanted->has_set_key()) return request(std::move(*wanted), onResult);
  // Without a mode, a service switches off.
  wanted->mutable_set_key()->mutable_mode();
  setKey(client, *wanted, onResult);
}

void SessionServer::steer(const std::string& robot, const std::string& service, const ClientInfo& client,
                          const ServiceCallRequest& call, const Reply& reply) {
  robotcontrol::Steer wanted;
  const std::string payload(call.payload);
  const bool isRead =
      call.encoding == "protobuf"
          ? wanted.ParseFromString(payload)
          : payload.empty() || google::protobuf::util::JsonStringToMessage(payload, &wanted).ok();
  if (!isRead) return reply.fail("the argument of " + service + R"( is {} or {"give_up": true})");
  const Instant now = server_->clock().now();
  wanted.give_up() ? steering_.giveUp(client, robot, now) : steering_.takeOver(client, robot, now);
  if (isElsewhere(robot) && steerElsewhere_) steerElsewhere_(robot, wanted.give_up());
  answer(reply, call.encoding, "");
}

// ---- Publishing by clients

const SessionServer::ClientStream* SessionServer::clientStreamOf(const ClientChannel& channel) const {
  const std::string stream = splitAtSlash(channel.topic).second;
  const auto found = std::ranges::find(clientStreams_, stream, &ClientStream::stream);
  return found == clientStreams_.end() ? nullptr : &*found;
}

std::string SessionServer::problemOf(const ClientChannel& channel) const {
  const ClientStream* stream = clientStreamOf(channel);
  if (stream == nullptr) {
    const auto fits = checkCommandChannel(channel);
    return fits ? std::string() : fits.error().text;
  }
  const bool isRight = channel.encoding == "protobuf" && channel.schemaName == stream->type;
  return isRight ? std::string() : channel.topic + " takes messages of " + stream->type + " as protobuf";
}

void SessionServer::command(const ClientInfo& client, const ClientChannel& channel,
                            const std::string& payload) {
  if (const ClientStream* stream = clientStreamOf(channel)) {
    std::string why = problemOf(channel);
    if (why.empty()) why = stream->take(client, splitAtSlash(channel.topic).first, payload);
    return complain(client, channel.topic, why);
  }
  Result<Request> wanted = commandOf(channel, payload);
  if (!wanted) return complain(client, channel.topic, wanted.error().text);
  const auto robot = robots_.find(wanted->robot());
  if (wanted->robot().empty() || robot == robots_.end() || robot->second.services.empty())
    return complain(client, channel.topic, "there is no robot '" + wanted->robot() + "'");
  const std::string why = steering_.admit(client, *wanted, server_->clock().now());
  if (!why.empty()) return complain(client, channel.topic, why);
  const auto* solutions = session_.store().latestAs<robotcontrol::SolutionTable>(
      wanted->robot() + "/" + streams::kSolutions, Instant::max());
  std::string ignored = solutions == nullptr ? "" : whyIgnored(*wanted, *solutions);
  request(std::move(*wanted), [this, client, topic = channel.topic, ignored](const RequestResult& result) {
    complain(client, topic, result.accepted() ? ignored : result.reason());
  });
}

void SessionServer::complain(const ClientInfo& client, const std::string& topic, const std::string& why) {
  if (!clients_.contains(client.id)) return;
  std::string& reported = complaints_[{client.id, topic}];
  if (reported == why) return;
  reported = why;
  if (!why.empty()) server_->sendStatus(client.id, {StatusLevel::kWarning, why, ""});
}

// ---- Parameters

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
  Request request;
  request.set_robot(robot);
  // Without a value this client withdraws its choice of a mode.
  if (!parameter.value && group == kKeysGroup) {
    request.mutable_set_key()->set_name(name);
    return request;
  }
  if (text == nullptr)
    return failure("foxglove.parameter", "the value of '" + parameter.name + "' is a text");
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

Result<std::vector<Request>> SessionServer::requestsFor(const std::vector<Parameter>& parameters) const {
  std::vector<Request> requests;
  std::vector<Parameter> ofModules;
  for (const Parameter& parameter : parameters) {
    if (modules_.has(parameter.name)) {
      ofModules.push_back(parameter);
      continue;
    }
    Result<Request> request = requestFor(parameter);
    if (!request) return tl::unexpected(request.error());
    requests.push_back(std::move(*request));
  }
  auto settings = modules_.requestsFor(ofModules);
  if (!settings) return tl::unexpected(settings.error());
  for (Request& setting : *settings) requests.push_back(std::move(setting));
  return requests;
}

void SessionServer::set(const ClientInfo& client, const std::vector<Parameter>& parameters,
                        const Reply& reply) {
  auto requests = requestsFor(parameters);
  if (!requests) return reply.fail(requests.error().text);
  const auto joint = std::make_shared<JointReply>(reply, requests->size());
  for (const Request& wanted : *requests) {
    if (wanted.has_set_parameters()) modules_.expect(wanted);
    if (wanted.has_set_key()) {
      setKey(client, wanted, [joint](const RequestResult& result) { joint->add(result); });
      continue;
    }
    request(wanted, [this, joint, wanted](const RequestResult& result) {
      noteSet(wanted, result.accepted());
      joint->add(result);
    });
  }
}

/// Sets a key for a client, whose requests end with its connection.
void SessionServer::setKey(const ClientInfo& client, const Request& wanted,
                           std::function<void(const RequestResult&)> onResult) {
  const auto asked = chosenBy(client, wanted);
  if (!asked) {
    RequestResult done;
    done.set_accepted(true);
    return onResult(done);
  }
  isChoosing_ = true;
  request(*asked,
          [this, client, asked = *asked, onResult = std::move(onResult)](const RequestResult& result) {
            noteSet(asked, result.accepted());
            if (!result.accepted())
              keys_.choose(asked.robot(), asked.set_key().name(), shownName(client), std::nullopt);
            onResult(result);
          });
  isChoosing_ = false;
}

std::optional<Request> SessionServer::chosenBy(const ClientInfo& client, Request request) {
  // The client may have disconnected already.
  if (!clients_.contains(client.id)) return std::nullopt;
  robotcontrol::SetKey& key = *request.mutable_set_key();
  const auto chosen = key.has_mode() ? std::optional(key.mode()) : std::nullopt;
  const auto mode = keys_.choose(request.robot(), key.name(), shownName(client), chosen);
  offerOnDemand(request.robot());
  if (!mode) return std::nullopt;
  *key.mutable_mode() = *mode;
  return request;
}

void SessionServer::setMode(const std::string& robot, const std::string& key,
                            const robotcontrol::KeyMode& mode) {
  Request wanted;
  wanted.set_robot(robot);
  wanted.mutable_set_key()->set_name(key);
  *wanted.mutable_set_key()->mutable_mode() = mode;
  const std::weak_ptr<const int> alive = alive_;
  const std::string what = inWords(wanted);
  session_.request(std::move(wanted), [this, alive, what, robot, key](const RequestResult& result) {
    if (alive.expired() || result.accepted() || isLogged(robot, key)) return;
    session_.reportRefusal(what, result.reason());
  });
}

/// Whether a key is published as it was recorded, even if the program that runs on the log cannot publish it.
bool SessionServer::isLogged(const std::string& robot, const std::string& key) const {
  const auto known = robots_.find(robot);
  if (known == robots_.end() || session_.store().find(streams::kReplay) == nullptr) return false;
  const auto& keys = known->second.keys.keys();
  const auto row = std::ranges::find(keys, key, &robotcontrol::KeyTable::Key::name);
  return row != keys.end() && session_.store().find(robot + "/" + row->stream()) != nullptr;
}

/// Updates the value for the client that asked at once; the robot's table follows.
void SessionServer::noteSet(const Request& request, bool isAccepted) {
  const std::string& robot = request.robot();
  if (isAccepted && request.has_set_key())
    server_->updateParameters({{robot + "/" + kKeysGroup + "/" + request.set_key().name(),
                                Value{textOf(request.set_key().mode())}}});
  if (isAccepted && request.has_select_solution())
    server_->updateParameters({{robot + "/" + kSolutionsGroup + "/" + request.select_solution().task(),
                                Value{request.select_solution().solution()}}});
  if (isAccepted || !request.has_set_parameters()) return;
  // The expected values do not hold: the robot reports those that do.
  Request again;
  again.set_robot(robot);
  again.mutable_get_parameters()->set_task(request.set_parameters().task());
  again.mutable_get_parameters()->set_solution(request.set_parameters().solution());
  this->request(std::move(again), [](const RequestResult&) {});
}

}  // namespace robotlink::websocket
