// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/Steering.h"

#include <sstream>

namespace robotlink::websocket {
namespace {

using robotcontrol::MotionRequest;
using robotcontrol::Request;

constexpr char kThisMachine[] = "this machine";
/// The time between two attempts of a request that a robot did not accept.
constexpr Duration kAskAgain = std::chrono::milliseconds(100);

/// Returns what stays the same when a client reconnects: its name and its machine, without the port.
std::string personOf(const ClientInfo& client) {
  return client.name + " at " + client.address.substr(0, client.address.rfind(':'));
}

std::string inSeconds(Duration duration) {
  std::ostringstream text;
  text << seconds(duration) << " s";
  return text.str();
}

}  // namespace

bool Steering::isSteering(const Request& request) {
  const auto& control = request.control_drive();
  return request.has_motion() || request.has_set_goal() ||
         (request.has_control_drive() && (control.motors() || control.packets_size() > 0));
}

// ---- The actions of users

/// Whether the client may steer without taking over.
bool Steering::isFree(const Robot& robot, const ClientInfo& client, Instant now) const {
  const bool isIdle = !robot.goal && now - robot.commandedAt > limits_.idleTime;
  if (robot.who.empty() || robot.client == client.id || robot.silentSince || isIdle) return true;
  if (robot.client == 0) return false;
  const auto heardAt = actions_.heardAt(robot.client);
  return !heardAt || (robot.person == personOf(client) && isOutdated(robot.client, *heardAt, now));
}

/// Data that a dead link held back arrives late, and makes a connection that its user gave up look alive.
bool Steering::isOutdated(std::uint64_t client, Instant heardAt, Instant now) const {
  const auto silent = silentAt_.find(client);
  const bool wasSilent = silent != silentAt_.end() && now - silent->second <= limits_.resumeTime;
  return wasSilent || now - heardAt > limits_.linkTime;
}

std::string Steering::admit(const ClientInfo& client, const Request& request, Instant now) {
  Robot& robot = robots_[request.robot()];
  if (!isFree(robot, client, now))
    return request.robot() + " is steered by " + robot.who + ": take over first (service " + request.robot() +
           "/steer)";
  // A client that only lets it stand does not keep others from steering.
  const bool isStand = request.has_motion() && request.motion().motion().kind() == MotionRequest::STAND;
  if (robot.client != client.id && isStand) return {};
  if (robot.client != client.id) {
    // A goal that the same person has set over another connection holds.
    const bool isSame = robot.person == personOf(client) && !robot.silentSince;
    auto goal = isSame ? robot.goal : std::nullopt;
    begin(request.robot(), robot, client, now);
    robot.goal = std::move(goal);
  }
  note(robot, request, now);
  if (robot.silentSince) {
    robot.silentSince.reset();
    publish(request.robot(), robot, robot.who + " steers");
  }
  return {};
}

void Steering::takeOver(const ClientInfo& client, const std::string& name, Instant now) {
  Robot& robot = robots_[name];
  if (robot.client == client.id) return;
  stand(name, robot);
  robot.goal.reset();
  begin(name, robot, client, now);
}

void Steering::giveUp(const ClientInfo& client, const std::string& name, Instant) {
  const auto found = robots_.find(name);
  if (found == robots_.end() || found->second.client != client.id) return;
  stand(name, found->second);
  found->second.goal.reset();
  found->second.who.clear();
  found->second.client = 0;
  publish(name, found->second, "nobody steers");
}

void Steering::noteLocal(const Request& request, Instant now) {
  if (!isSteering(request)) return;
  Robot& robot = robots_[request.robot()];
  if (robot.who != kThisMachine) {
    robot.client = 0;
    robot.who = robot.person = kThisMachine;
    robot.silentSince.reset();
    publish(request.robot(), robot, robot.who + " steers");
  }
  // Local control needs no watchdog: there is no link that could be lost.
  robot.motion.reset();
  robot.goal.reset();
  robot.toAsk.clear();
  robot.commandedAt = now;
}

void Steering::takeOverHere(const std::string& name, Instant now) {
  Robot& robot = robots_[name];
  stand(name, robot);
  robot.goal.reset();
  robot.client = 0;
  robot.who = robot.person = kThisMachine;
  robot.silentSince.reset();
  robot.commandedAt = now;
  publish(name, robot, robot.who + " steers");
}

void Steering::giveUpHere(const std::string& name) {
  const auto found = robots_.find(name);
  if (found == robots_.end() || found->second.who != kThisMachine) return;
  found->second.who.clear();
  publish(name, found->second, "nobody steers");
}

void Steering::joined(const ClientInfo& client) {
  for (auto& [name, robot] : robots_) {
    const bool isBack =
        robot.client != 0 && robot.goal && robot.silentSince && robot.person == personOf(client);
    if (!isBack) continue;
    robot.client = client.id;
    robot.who = shownName(client);
  }
}

void Steering::begin(const std::string& name, Robot& robot, const ClientInfo& client, Instant now) {
  robot.client = client.id;
  robot.who = shownName(client);
  robot.person = personOf(client);
  robot.commandedAt = now;
  robot.motion.reset();
  robot.goal.reset();
  robot.silentSince.reset();
  publish(name, robot, robot.who + " steers");
}

void Steering::note(Robot& robot, const Request& request, Instant now) {
  robot.commandedAt = now;
  // Late answers to earlier requests no longer count.
  robot.asking = 0;
  if (request.has_motion()) {
    const bool isMoving = request.motion().motion().kind() != MotionRequest::STAND;
    robot.motion = isMoving ? std::optional(request) : std::nullopt;
    // The new motion replaces the pending local ones.
    std::erase_if(robot.toAsk, [](const Request& asked) { return asked.has_motion(); });
  }
  if (request.has_set_goal()) {
    robot.goal = request.set_goal().cancelled() ? std::nullopt : std::optional(request);
    std::erase_if(robot.toAsk, [](const Request& asked) { return asked.has_set_goal(); });
  }
}

// ---- The supervision of links

void Steering::stand(const std::string& name, Robot& robot) {
  robot.toAsk.clear();
  if (robot.motion) {
    Request& request = robot.toAsk.emplace_back(*robot.motion);
    request.mutable_motion()->clear_motion();  // stand; the head stays as it is
    robot.motion.reset();
  }
  if (robot.goal) {
    Request& request = robot.toAsk.emplace_back();
    request.set_robot(name);
    request.mutable_set_goal()->set_cancelled(true);
  }
  robot.asking = 0;
  robot.askAt = Instant::min();
}

void Steering::watchMotion(const std::string& name, Robot& robot, Instant now) {
  if (robot.client == 0 || !robot.motion || now - robot.commandedAt <= limits_.commandTime) return;
  stand(name, robot);
  if (robot.goal) robot.toAsk.pop_back();  // the robot continues to it
  publish(name, robot,
          robot.who + " did not repeat its motion for " + inSeconds(limits_.commandTime) +
              ": the robot was stopped");
}

void Steering::watchLink(const std::string& name, Robot& robot, Instant now) {
  if (robot.client == 0) return;
  const auto heardAt = actions_.heardAt(robot.client);
  const bool isSilent = !heardAt || now - *heardAt > limits_.linkTime;
  if (isSilent) silentAt_[robot.client] = now;
  if (isSilent && !robot.silentSince) {
    robot.silentSince = now;
    const bool moved = robot.motion || robot.goal;
    stand(name, robot);
    publish(name, robot,
            robot.who + (heardAt ? " is silent" : " is gone") + (moved ? ": the robot was stopped" : ""));
  } else if (!isSilent && robot.silentSince) {
    robot.silentSince.reset();
    publish(name, robot, robot.who + " steers");
    if (!robot.goal) return;
    robot.toAsk = {*robot.goal};
    robot.asking = 0;
    robot.askAt = Instant::min();
  }
}

void Steering::forgetIdle(const std::string& name, Robot& robot, Instant now) {
  if (robot.who.empty()) return;
  const bool isLost = robot.silentSince && now - *robot.silentSince > limits_.resumeTime;
  const bool isGone = robot.client != 0 && !robot.goal && !actions_.heardAt(robot.client);
  if (isLost) robot.goal.reset();
  const bool isIdle = !robot.goal && now - robot.commandedAt > limits_.idleTime;
  if (!isIdle && !isLost && !isGone) return;
  if (!robot.toAsk.empty()) return;
  robot.client = 0;
  robot.who.clear();
  robot.silentSince.reset();
  publish(name, robot, "nobody steers");
}

void Steering::tick(Instant now) {
  for (auto& [name, robot] : robots_) {
    watchLink(name, robot, now);
    watchMotion(name, robot, now);
    ask(name, robot, now);
    forgetIdle(name, robot, now);
  }
  std::erase_if(silentAt_, [&](const auto& silent) { return now - silent.second > limits_.resumeTime; });
}

void Steering::end() {
  for (auto& [name, robot] : robots_) {
    if (robot.client == 0) continue;
    stand(name, robot);
    for (const Request& request : std::exchange(robot.toAsk, {})) actions_.request(request, [](bool) {});
  }
}

void Steering::ask(const std::string& name, Robot& robot, Instant now) {
  if (robot.toAsk.empty() || robot.asking != 0 || now < robot.askAt) return;
  const std::uint64_t asking = robot.asking = nextAsking_++;
  robot.askAt = now + kAskAgain;
  actions_.request(robot.toAsk.front(), [this, name, asking](bool isDone) {
    const auto found = robots_.find(name);
    if (found == robots_.end() || found->second.asking != asking) return;
    found->second.asking = 0;
    if (!isDone || found->second.toAsk.empty()) return;
    found->second.toAsk.pop_front();
    found->second.askAt = Instant::min();
  });
}

void Steering::publish(const std::string& name, Robot& robot, const std::string& text) {
  Status status{robot.who, robot.client, robot.silentSince.has_value(), text};
  if (status == robot.published) return;
  robot.published = status;
  actions_.changed(name, status);
}

Steering::Status Steering::status(const std::string& robot) const {
  const auto found = robots_.find(robot);
  return found == robots_.end() ? Status() : found->second.published;
}

std::set<std::uint64_t> Steering::clients() const {
  std::set<std::uint64_t> ids;
  for (const auto& [name, robot] : robots_) ids.insert(robot.client);
  ids.erase(0);
  return ids;
}

}  // namespace robotlink::websocket
