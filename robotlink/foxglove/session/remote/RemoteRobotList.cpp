// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/remote/RemoteRobotList.h"

#include <algorithm>

#include "robotlink/base/Printable.h"

namespace robotlink::websocket {
namespace {

constexpr std::size_t kMaxRobots = 64, kMaxRobotName = 64;

/// A name from anywhere as a robot's name, which is a part of paths.
std::string asRobotName(const std::string& text) {
  std::string name = printable(text.substr(0, kMaxRobotName));
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == ' '; }, '_');
  return name.empty() ? "robot" : name;
}

}  // namespace

std::string RemoteRobotList::freeName(const std::string& wanted) const {
  const std::string base = asRobotName(wanted);
  std::string name = base;
  for (int i = 2; (isTaken_ && isTaken_(name)) || std::ranges::find(names_, name) != names_.end(); ++i)
    name = base + "-" + std::to_string(i);
  return name;
}

void RemoteRobotList::add(const std::string& remote, const std::string& wantedName) {
  if (const auto known = robots_.find(remote); known != robots_.end()) {
    known->second.isStale = false;
    return;
  }
  if (robots_.size() >= kMaxRobots) return;
  Robot robot;
  robot.remote = remote;
  robot.local = freeName(wantedName);
  names_.push_back(robot.local);
  robots_.emplace(remote, std::move(robot));
  ++version_;
}

void RemoteRobotList::remove(const std::string& remote) {
  const auto node = robots_.extract(remote);
  if (node.empty()) return;
  std::erase(names_, node.mapped().local);
  ++version_;
}

void RemoteRobotList::setStale() {
  for (auto& [name, robot] : robots_) robot.isStale = true;
}

void RemoteRobotList::removeStale() {
  std::vector<std::string> gone;
  for (const auto& [name, robot] : robots_)
    if (robot.isStale) gone.push_back(name);
  for (const std::string& name : gone) remove(name);
}

RemoteRobotList::Place RemoteRobotList::placeOf(const std::string& topic) {
  // A foreign server's topics begin with a slash.
  if (Robot* foreign = findRemote("")) return {foreign, topic.substr(topic.starts_with('/') ? 1 : 0)};
  const std::size_t slash = topic.find('/');
  if (slash != std::string::npos)
    if (Robot* robot = findRemote(topic.substr(0, slash))) return {robot, topic.substr(slash + 1)};
  return {nullptr, topic};
}

RemoteRobotList::Robot* RemoteRobotList::findRemote(const std::string& name) {
  const auto found = robots_.find(name);
  return found == robots_.end() ? nullptr : &found->second;
}

RemoteRobotList::Robot* RemoteRobotList::findLocal(const std::string& name) {
  for (auto& [remote, robot] : robots_)
    if (robot.local == name) return &robot;
  return nullptr;
}

}  // namespace robotlink::websocket
