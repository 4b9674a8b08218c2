// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/remote/SessionClient.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>

#include "robotlink/base/Utf8.h"
#include "robotlink/foxglove/session/KeyModeText.h"
#include "robotlink/foxglove/session/RobotPath.h"
#include "robotlink/foxglove/session/remote/RemoteSession.h"

namespace robotlink::websocket {

using robotcontrol::Request;
using robotcontrol::RequestResult;

// ---- Requests

void RemoteSession::answer(std::uint64_t id, bool isAccepted, const std::string& reason) {
  RequestResult result;
  result.set_id(id);
  result.set_accepted(isAccepted);
  result.set_reason(validUtf8(reason));
  session.pushResult(result);
}

void RemoteSession::setKey(RemoteRobotList::Robot& robot, const Request& request) {
  const RemoteKeys before = robot.keys;
  const RemoteKeys::Outcome outcome = robot.keys.set(request.set_key());
  if (client->state().isConnected()) {
    const bool isChoice = outcome.isChoice || (outcome.isForwarded && isOurs);
    if (isChoice && !client->state().takesMessages) {
      robot.keys = before;
      return answer(request.id(), false, "you may only watch " + robot.local);
    }
    if (outcome.isChoice) sendChoice(robot, request.set_key().name());
  }
  hasChanged |= outcome.hasChanged;
  if (outcome.hasChanged) changedKeys.insert(robot.remote);
  if (outcome.isForwarded)
    forward(robot.remote, request);
  else
    answer(request.id(), true, "");
}

void RemoteSession::sendChoice(const RemoteRobotList::Robot& robot, const std::string& key) {
  Parameter parameter{robot.remote + "/" + kKeysGroup + "/" + key, std::nullopt};
  if (const auto mode = robot.keys.choice(key)) parameter.value = Value{textOf(*mode)};
  client->setParameters({parameter});
}

void RemoteSession::forward(const std::string& robot, const Request& request) {
  const auto* field = Request::descriptor()->FindFieldByNumber(static_cast<int>(request.what_case()));
  if (field == nullptr) return answer(request.id(), false, "an empty request");
  Client::Call call;
  call.service = (robot.empty() ? "" : robot + "/") + field->name();
  call.encoding = "protobuf";
  call.payload = request.GetReflection()->GetMessage(request, field).SerializeAsString();
  call.urgency = request.has_stop() ? Client::Urgency::kUrgent : Client::Urgency::kNormal;
  client->call(std::move(call), [this, id = request.id()](const Result<Client::Answer>& reply) {
    if (!reply) return answer(id, false, reply.error().text);
    RequestResult result;
    if (!result.ParseFromString(reply->data)) return answer(id, false, "the robot's answer is not valid");
    result.set_id(id);
    session.pushResult(result);
  });
}

// ---- The class itself

SessionClient::SessionClient(Session& session, Options options)
    : parts_(std::make_unique<RemoteSession>(session, std::move(options))) {
  parts_->connect();
}

SessionClient::~SessionClient() = default;

void SessionClient::tick() {
  parts_->tick();
}

const ServerUrl& SessionClient::url() const {
  return parts_->options.connection.url;
}

ConnectionState SessionClient::state() const {
  return parts_->client->state();
}

std::string SessionClient::stateText() const {
  const std::string text = describe(state(), parts_->options.connection.clock->now());
  return parts_->isNarrow && parts_->images == Images::kAutomatic
             ? text + ", images as JPEG: the link is too slow for raw ones"
             : text;
}

const std::vector<std::string>& SessionClient::robots() const {
  return parts_->robots.names();
}

std::uint64_t SessionClient::robotsVersion() const {
  return parts_->robots.version();
}

bool SessionClient::takes(const Request& request) const {
  if (!request.robot().empty()) return parts_->robots.findLocal(request.robot()) != nullptr;
  const auto* field = Request::descriptor()->FindFieldByNumber(static_cast<int>(request.what_case()));
  return parts_->leads() && field != nullptr && parts_->services.contains(field->name());
}

void SessionClient::request(const Request& request) {
  RemoteRobotList::Robot* robot = parts_->robots.findLocal(request.robot());
  if (robot != nullptr && request.has_set_key()) return parts_->setKey(*robot, request);
  parts_->forward(robot != nullptr ? robot->remote : request.robot(), request);
}

void SessionClient::steer(const std::string& robot, bool giveUp, std::function<void(Result<void>)> done) {
  const RemoteRobotList::Robot* found = parts_->robots.findLocal(robot);
  if (found == nullptr || found->remote.empty())
    return done(failure("steering.none", robot + " cannot be steered by this program", {}, {robot}));
  Client::Call call{found->remote + "/steer", "json", giveUp ? R"({"give_up": true})" : "{}"};
  parts_->client->call(std::move(call), [done = std::move(done)](const Result<Client::Answer>& answer) {
    if (!answer) return done(tl::unexpected(answer.error()));
    RequestResult result;
    const bool isRead = google::protobuf::util::JsonStringToMessage(answer->data, &result).ok();
    if (!isRead || !result.accepted())
      return done(failure("steering.refused", isRead ? result.reason() : "the robot's answer is not valid"));
    done({});
  });
}

const std::vector<SessionClient::Gap>& SessionClient::gaps() const {
  return parts_->gaps;
}

std::vector<SessionClient::Stream> SessionClient::streams() const {
  std::vector<Stream> all;
  const auto counters = parts_->client->counters();
  for (const auto& [id, channel] : parts_->channels) {
    Stream stream{parts_->placeOf(*channel).path(), channel->topic, channel->type, channel->encoding};
    stream.isSubscribed = parts_->topics.contains(channel->topic);
    stream.isDecoded = channel->isDecoded;
    stream.messages = channel->messages;
    stream.bytes = channel->bytes;
    if (const auto counted = counters.find(channel->topic); counted != counters.end()) {
      stream.thinned = counted->second.thinned;
      stream.dropped = counted->second.dropped;
    }
    all.push_back(std::move(stream));
  }
  std::ranges::sort(all, {}, &Stream::path);
  return all;
}

std::optional<Instant> SessionClient::newest() const {
  return parts_->shift.newest();
}

void SessionClient::updateSubscriptions() {
  parts_->hasChanged = true;
}

void SessionClient::setImages(Images images) {
  parts_->isNarrow = false;
  parts_->hasChanged |= std::exchange(parts_->images, images) != images;
}

void SessionClient::setImageRate(double imagesPerSecond) {
  parts_->hasChanged |= std::exchange(parts_->imageRate, imagesPerSecond) != imagesPerSecond;
}

void SessionClient::setBudget(double bytesPerSecond) {
  parts_->client->setBudget(bytesPerSecond);
}

bool SessionClient::hasSession() const {
  return parts_->isOurs;
}

bool SessionClient::hasService(const std::string& name) const {
  return parts_->services.contains(name);
}

Client& SessionClient::client() {
  return *parts_->client;
}

}  // namespace robotlink::websocket
