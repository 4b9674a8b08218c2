// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/LatchedMessages.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <array>

#include "robotlink/debugging/Streams.h"

namespace robotlink {

bool isLatched(std::string_view path, std::string_view type) {
  constexpr std::array<std::string_view, 13> kTypes{
      "robotcontrol.BodyOffer",        "robotcontrol.ColorTable",    "robotcontrol.ControllerInputs",
      "robotcontrol.ControllerStates", "robotcontrol.HostingStatus", "robotcontrol.KeySubscribers",
      "robotcontrol.KeyTable",         "robotcontrol.MotionTable",   "robotcontrol.ParameterValues",
      "robotcontrol.ProcessTable",     "robotcontrol.ProgramSetup",  "robotcontrol.SolutionTable",
      "robotcontrol.SteeringStatus"};
  return path == streams::kScene || path.starts_with(streams::kControllerInputs) || path == streams::kMap ||
         path == streams::kObjects || path == streams::kSolids ||
         std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

bool isLatched(const StreamMessage& message) {
  return message.value && isLatched(message.path, message.value->GetDescriptor()->full_name());
}

bool LatchedMessages::take(const StreamMessage& message) {
  if (!isLatched(message)) return false;
  const std::pair key(message.path, message.process);
  if (messages_.size() >= kMaxStreams && !messages_.contains(key)) return false;
  messages_[key] = message;
  return true;
}

void LatchedMessages::forget(const std::string& robot) {
  const std::string prefix = robot + "/";
  std::erase_if(messages_, [&](const auto& entry) { return entry.first.first.starts_with(prefix); });
}

std::vector<StreamMessage> LatchedMessages::all() const {
  std::vector<StreamMessage> result;
  for (const auto& [key, message] : messages_) result.push_back(message);
  return result;
}

}  // namespace robotlink
