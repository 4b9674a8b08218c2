// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/ClientCommands.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <array>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/packages/Packages.h"

namespace robotlink::websocket {
namespace {

using google::protobuf::Message;
using robotcontrol::DriveGoal;
using robotcontrol::DriveRequest;
using robotcontrol::MotionRequest;
using robotcontrol::RemoteMotion;
using robotcontrol::Request;

void fillMotion(Request& request, const Message& message) {
  *request.mutable_motion() = dynamic_cast<const RemoteMotion&>(message);
}

void fillDrive(Request& request, const Message& message) {
  const auto& velocity = dynamic_cast<const DriveRequest&>(message).velocity();
  MotionRequest& motion = *request.mutable_motion()->mutable_motion();
  const bool isMoving = velocity.x() != 0 || velocity.y() != 0 || velocity.rotation() != 0;
  motion.set_kind(isMoving ? MotionRequest::WALK : MotionRequest::STAND);
  if (isMoving) *motion.mutable_walk() = velocity;
}

void fillGoal(Request& request, const Message& message) {
  *request.mutable_set_goal() = dynamic_cast<const DriveGoal&>(message);
}

struct CommandTopic {
  const char* topic;
  const Message& (*type)();
  void (*fill)(Request& request, const Message& message);
};

template <typename T>
const Message& prototypeOf() {
  return T::default_instance();
}

constexpr std::array kCommandTopics{
    CommandTopic{kRemoteMotion.name, prototypeOf<RemoteMotion>, fillMotion},
    CommandTopic{"remote/drive", prototypeOf<DriveRequest>, fillDrive},
    CommandTopic{kDriveGoal.name, prototypeOf<DriveGoal>, fillGoal},
};

const CommandTopic* commandTopic(const std::string& path) {
  const std::size_t slash = path.find('/');
  for (const CommandTopic& topic : kCommandTopics)
    if (slash != std::string::npos && path.substr(slash + 1) == topic.topic) return &topic;
  return nullptr;
}

tl::unexpected<Error> wrongCommand(std::string why) {
  return failure("foxglove.command", std::move(why));
}

}  // namespace

std::string commandTopics() {
  std::string text;
  for (const CommandTopic& topic : kCommandTopics)
    text += (text.empty() ? "ROBOT/" : ", ROBOT/") + std::string(topic.topic);
  return text;
}

Result<void> checkCommandChannel(const ClientChannel& channel) {
  const CommandTopic* topic = commandTopic(channel.topic);
  if (topic == nullptr)
    return wrongCommand("nothing receives what you publish on " + channel.topic + ": there are " +
                        commandTopics());
  const std::string type = topic->type().GetTypeName();
  if (channel.encoding == "protobuf" && !channel.schemaName.empty() && channel.schemaName != type)
    return wrongCommand(channel.topic + " takes messages of " + type + ", not of " + channel.schemaName);
  return {};
}

std::string whyIgnored(const Request& request, const robotcontrol::SolutionTable& solutions) {
  constexpr char kObey[] = "obey";
  if (!request.has_motion()) return {};
  for (const auto& task : solutions.tasks()) {
    const bool canObey =
        std::ranges::any_of(task.solutions(), [&](const auto& solution) { return solution.name() == kObey; });
    if (!canObey) continue;
    if (task.active() == kObey) return {};
    return request.robot() + " ignores this as long as its " + task.name() + " is '" + task.active() +
           "', and not '" + kObey + "': set the parameter " + request.robot() + "/solutions/" + task.name();
  }
  return {};
}

Result<Request> commandOf(const ClientChannel& channel, std::string_view payload) {
  if (const auto fits = checkCommandChannel(channel); !fits) return tl::unexpected(fits.error());
  const CommandTopic& topic = *commandTopic(channel.topic);
  const std::unique_ptr<Message> message(topic.type().New());
  const std::string type = message->GetTypeName();
  if (channel.encoding == "protobuf") {
    if (!message->ParseFromArray(payload.data(), static_cast<int>(payload.size())))
      return wrongCommand("a message on " + channel.topic + " is no " + type);
  } else {
    const auto status = google::protobuf::util::JsonStringToMessage(
        google::protobuf::StringPiece(payload.data(), payload.size()), message.get());
    if (!status.ok())
      return wrongCommand("a message on " + channel.topic + " is no " + type + ": " + status.ToString());
  }
  Request request;
  request.set_robot(channel.topic.substr(0, channel.topic.find('/')));
  topic.fill(request, *message);
  if (std::string wrong = wrongWith(request); !wrong.empty()) return wrongCommand(std::move(wrong));
  return request;
}

}  // namespace robotlink::websocket
