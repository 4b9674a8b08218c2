// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ChangeSteps.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "app/core/OpenPlatform.h"
#include "logplayer/base/RobotNames.h"
#include "logplayer/search/ChangeSearch.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/expressions/BoundExpression.h"

namespace app {
namespace {

using robotlink::BoundExpression;
using robotlink::Duration;
using robotlink::Error;
using robotlink::failure;
using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamStore;

Error notFound(const std::string& expression, bool isForward) {
  return {"timeline.no-change",
          expression + (isForward ? " does not change any more" : " did not change before"),
          {expression},
          {}};
}

/// The state of an expression at an instant.
std::optional<robotlink::FieldValue> stateAt(BoundExpression& expression, const StreamStore& store,
                                             Instant time, std::optional<double> limit) {
  const std::set<std::string> streams(expression.streams().begin(), expression.streams().end());
  for (const std::string& stream : streams) {
    const auto* message = store.latest(stream, time);
    if (message == nullptr || !expression.take(stream, *message->value)) expression.forget(stream);
  }
  return expression.state(limit);
}

/// The expression with the streams as a log has them.
Result<std::string> inLog(const std::string& text, const logplayer::LogFile& log,
                          const std::vector<std::string>& robots) {
  const auto own = log.robots();
  std::vector<std::string> known;
  for (const auto& stream : log.streams())
    known.push_back(logplayer::renamedStream(stream.path, own, robots));
  const auto parsed = robotlink::Expression::parse(text, known);
  if (!parsed) return tl::unexpected(parsed.error());
  return parsed->withStreams(
      [&](const std::string& stream) { return logplayer::renamedStream(stream, robots, own); });
}

}  // namespace

ChangeSteps::ChangeSteps(OpenPlatform& open)
    : open_(open), worker_([this](const Plan& plan, const std::stop_token& stop) {
        auto found = findIn(plan, stop);
        if (!stop.stop_requested()) worker_.publish(std::move(found));
      }) {}

ChangeSteps::Found ChangeSteps::findIn(const Plan& plan, const std::stop_token& stop) {
  const auto goesOn = [&stop](double) { return !stop.stop_requested(); };
  std::optional<Instant> nearest;
  std::optional<Error> problem;
  bool isKnown = false;
  for (const Plan::Log& entry : plan.logs) {
    logplayer::LogFile::Options opening;
    opening.progress = goesOn;
    const auto log = logplayer::LogFile::open(entry.path, opening);
    if (!log) return tl::unexpected(log.error());
    const auto expression = inLog(plan.step.expression, **log, entry.robots);
    if (!expression) return tl::unexpected(expression.error());
    const std::string robot = logplayer::renamedRobot(plan.robot, entry.robots, (*log)->robots());
    const auto found = logplayer::findChange(
        *log, {*expression, robot, plan.step.limit, plan.from - entry.offset, plan.step.isForward}, goesOn);
    if (!found) problem = found.error();
    if (!found) continue;
    isKnown = true;
    if (!*found) continue;
    const Instant at = **found + entry.offset;
    nearest = !nearest ? at : plan.step.isForward ? std::min(*nearest, at) : std::max(*nearest, at);
  }
  if (nearest) return *nearest;
  if (!isKnown && problem) return tl::unexpected(*problem);
  return tl::unexpected(notFound(plan.step.expression, plan.step.isForward));
}

Result<void> ChangeSteps::begin(const Step& step) {
  auto& session = open_.session();
  failure_.reset();
  expression_ = step.expression;
  isForward_ = step.isForward;
  const auto* replay = session.store().latestAs<robotcontrol::ReplayStatus>(robotlink::streams::kReplay,
                                                                            session.timeline().newest());
  if (replay == nullptr) return beginLive(step);
  Plan plan{step, session.selectedRobot(), Instant(Duration(replay->time())), {}};
  for (const auto& log : replay->logs())
    plan.logs.push_back({log.path(), Duration(log.offset()), {log.robots().begin(), log.robots().end()}});
  isSearching_ = true;
  worker_.post(std::move(plan));
  return {};
}

Result<void> ChangeSteps::beginLive(const Step& step) {
  auto& session = open_.session();
  auto& store = session.store();
  std::vector<std::string> streams;
  for (const auto* stream : store.streams()) streams.push_back(stream->path);
  auto bound = BoundExpression::bind(step.expression, streams, {session.selectedRobot()});
  if (!bound) return tl::unexpected(bound.error());
  const auto expression = std::make_shared<BoundExpression>(std::move(bound->front()));
  if (expression->streams().empty()) return failure("expression.constant", "the expression names no stream");
  for (const std::string& stream : expression->streams()) {
    const auto* newest = store.latest(stream, store.newest());
    if (newest == nullptr) continue;
    if (const auto fits = expression->take(stream, *newest->value); !fits)
      return tl::unexpected(fits.error());
  }
  const auto changes = [&store, expression, limit = step.limit](Instant time) {
    const Instant before = time - Duration(1);
    return store.has(before) &&
           stateAt(*expression, store, before, limit) != stateAt(*expression, store, time, limit);
  };
  isStepping_ = true;
  const std::set<std::string> needed(expression->streams().begin(), expression->streams().end());
  session.history().stepUntil({needed.begin(), needed.end()}, step.isForward, changes);
  return {};
}

void ChangeSteps::fail(Error error) {
  open_.session().reportRefusal("step to a change", error.text);
  failure_ = std::move(error);
}

void ChangeSteps::tick() {
  auto& history = open_.session().history();
  if (isStepping_ && !history.isStepping()) {
    isStepping_ = false;
    if (history.isMissed()) fail(notFound(expression_, isForward_));
  }
  if (!isSearching_) return;
  auto found = worker_.take();
  if (!found) return;
  isSearching_ = false;
  if (!*found) return fail(found->error());
  robotcontrol::Request request;
  request.mutable_control_replay()->set_action(robotcontrol::ControlReplay::JUMP_TO_TIME);
  request.mutable_control_replay()->set_time((*found)->time_since_epoch().count());
  open_.ask(std::move(request));
}

Result<bool> ChangeSteps::working() {
  if (failure_) return tl::unexpected(*std::exchange(failure_, std::nullopt));
  return isSearching_ || isStepping_;
}

}  // namespace app
