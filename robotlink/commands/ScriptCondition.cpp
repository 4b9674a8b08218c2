// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/ScriptCondition.h"

#include <algorithm>
#include <utility>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/RobotTables.h"

namespace robotlink {
namespace {

const std::string kTimeStream = streams::kSimulation;

}  // namespace

ScriptCondition::ScriptCondition(Session& session, std::string expression, Observer observe)
    : session_(session), text_(std::move(expression)), observe_(std::move(observe)) {
  listener_ = session_.addListener({.message = [this](const StreamMessage& message) { take(message); }});
  bind();
}

ScriptCondition::~ScriptCondition() {
  session_.removeListener(listener_);
}

void ScriptCondition::bind() {
  StreamStore& store = session_.store();
  const bool isSame = generation_ == store.generation() && robot_ == session_.selectedRobot();
  // New streams do not matter to an expression that is bound already.
  if (wrong_ || (isSame && (bound_ || listVersion_ == store.listVersion()))) return;
  listVersion_ = store.listVersion();
  generation_ = store.generation();
  robot_ = session_.selectedRobot();
  std::vector<std::string> paths{kTimeStream};
  for (const auto* stream : store.streams()) {
    if (stream->path != kTimeStream) paths.push_back(stream->path);
  }
  std::vector<std::string> robots;
  if (!robot_.empty()) robots.push_back(robot_);
  bound_.reset();
  auto bound = BoundExpression::bind(text_, paths, robots);
  if (bound) {
    missing_.reset();
    bound_ = std::move(bound->front());
    usesTime_ = std::ranges::find(bound_->streams(), kTimeStream) != bound_->streams().end();
    takeNewest();
    return;
  }
  const bool mayAppear = bound.error().id == "expression.stream" || bound.error().id == "expression.robot";
  if (mayAppear) bound.error().text += hintFor(bound.error());
  (mayAppear ? missing_ : wrong_) = bound.error();
}

std::string ScriptCondition::hintFor(const Error& error) const {
  if (error.arguments.empty()) return {};
  std::string stream = error.arguments.front();
  if (!robot_.empty() && stream.starts_with(robot_ + "/")) stream.erase(0, robot_.size() + 1);
  const std::string key = "package/" + stream;
  const auto known = keyNames(session_);
  return std::ranges::find(known, key) == known.end() ? "" : "; robot.key " + key + " has it published";
}

void ScriptCondition::takeNewest() {
  for (const std::string& stream : bound_->streams()) {
    const StreamMessage* message = session_.store().latest(stream, Instant::max());
    if (stream != kTimeStream && message != nullptr) takeValue(stream, *message->value);
  }
  takeTime(session_.timeline().newest());
  wasTrue_ |= isTrue();
}

void ScriptCondition::take(const StreamMessage& message) {
  if (!bound_ || wrong_ || (wasTrue_ && !observe_)) return;
  const auto& streams = bound_->streams();
  const bool isUsed =
      message.path != kTimeStream && std::ranges::find(streams, message.path) != streams.end();
  if (!isUsed && !usesTime_) return;
  if (isUsed) takeValue(message.path, *message.value);
  takeTime(message.time);
  const auto value = bound_->value();
  wasTrue_ |= value && *value != 0;
  if (value && observe_) observe_(*value, message.time);
}

void ScriptCondition::takeTime(Instant time) {
  if (!usesTime_) return;
  const auto* known = session_.store().latestAs<robotcontrol::SimulationStatus>(kTimeStream, Instant::max());
  robotcontrol::SimulationStatus status;
  if (known != nullptr) status = *known;
  status.set_time(seconds(session_.timeline().sinceOrigin(time)));
  takeValue(kTimeStream, status);
}

void ScriptCondition::takeValue(const std::string& stream, const google::protobuf::Message& value) {
  if (auto taken = bound_->take(stream, value); !taken && !wrong_) wrong_ = taken.error();
}

bool ScriptCondition::isTrue() {
  const auto value = bound_->value();
  return value && *value != 0;
}

Result<bool> ScriptCondition::look() {
  bind();
  if (wrong_) return tl::unexpected(*wrong_);
  return std::exchange(wasTrue_, false);
}

Result<bool> ScriptCondition::now() {
  bind();
  if (bound_) takeNewest();
  if (wrong_ || missing_) return tl::unexpected(wrong_ ? *wrong_ : *missing_);
  return isTrue();
}

Result<std::string> ScriptCondition::valueNow() {
  return now().map([this](bool) { return bound_->resultInWords(); });
}

std::string ScriptCondition::values() const {
  if (missing_) return missing_->text;
  return bound_ ? bound_->valuesInWords() : std::string();
}

}  // namespace robotlink
