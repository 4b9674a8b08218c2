// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/RobotSearch.h"

#include <algorithm>
#include <chrono>

#include "robotlink/dds/LocalAddresses.h"

namespace app {
namespace {

using robotlink::dds::AnnouncedRobots;
using robotlink::dds::RobotDiscovery;

/// The period of checks for announcements; and the number of these per check for other networks.
constexpr std::chrono::milliseconds kSearchLook{100};
constexpr int kLooksPerNetworks = 20;

/// Listens on all networks, and again if there are others.
class NetworkSource final : public RobotSearch::Source {
 public:
  explicit NetworkSource(RobotSearch::Nodes nodes) : nodes_(std::move(nodes)) {}

  std::vector<AnnouncedRobots> robots() override {
    if (looks_++ % kLooksPerNetworks == 0) follow(robotlink::dds::localAddresses());
    return discovery_ ? discovery_->robots() : std::vector<AnnouncedRobots>();
  }
  std::string problem() const override { return problem_; }

 private:
  void follow(std::vector<std::string> addresses) {
    std::ranges::sort(addresses);
    if (std::exchange(addresses_, addresses) == addresses && discovery_) return;
    discovery_.reset();
    auto nodes = nodes_({});
    if (nodes.empty()) {
      problem_ =
          "This computer is not on a network, where robots "
          "could announce themselves. Enter the URL instead.";
      return;
    }
    auto opened = RobotDiscovery::open(std::move(nodes));
    problem_ = opened ? std::string() : opened.error().text;
    if (opened) discovery_ = std::move(*opened);
  }

  const RobotSearch::Nodes nodes_;
  int looks_ = 0;
  std::vector<std::string> addresses_;
  std::unique_ptr<RobotDiscovery> discovery_;
  std::string problem_;
};

}  // namespace

RobotSearch::Open RobotSearch::onNetworks(Nodes nodes) {
  return [nodes = std::move(nodes)] { return std::make_unique<NetworkSource>(nodes); };
}

RobotSearch::RobotSearch(Open open, std::shared_ptr<const robotlink::Clock> clock)
    : clock_(std::move(clock)), open_(std::move(open)) {}

void RobotSearch::listenBy(Open open) {
  const std::lock_guard lock(mutex_);
  open_ = std::move(open);
}

void RobotSearch::setWanted(bool wanted) {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(isWanted_, wanted) == wanted) return;
    if (!wanted) {
      isListening_ = false;
      heard_.clear();
      problem_.clear();
    }
  }
  if (thread_) return thread_->wake();
  thread_.emplace(robotlink::PacedThread::Work{
      .due = [this] { return due(); }, .step = [this] { step(); }, .end = [this] { source_.reset(); }});
}

RobotSearch::State RobotSearch::state() const {
  const std::lock_guard lock(mutex_);
  const robotlink::Instant now = clock_->now();
  State state;
  state.isListening = isListening_;
  if (isListening_) state.age = now - since_;
  for (const auto& [url, heard] : heard_) state.found.push_back({heard.robots, now - heard.since});
  std::ranges::stable_sort(state.found, {}, [](const Found& found) { return found.robots.names(); });
  state.problem = problem_;
  return state;
}

std::optional<robotlink::PacedThread::Clock::time_point> RobotSearch::due() {
  const std::lock_guard lock(mutex_);
  if (isWanted_) return lookAt_;
  lookAt_ = {};
  return source_ ? std::optional(lookAt_) : std::nullopt;
}

void RobotSearch::step() {
  std::unique_lock lock(mutex_);
  if (!isWanted_) {
    lock.unlock();
    source_.reset();
    return;
  }
  const Open open = open_;
  lock.unlock();
  std::vector<AnnouncedRobots> robots;
  std::string problem;
  try {
    if (!source_) source_ = open();
    robots = source_->robots();
    problem = source_->problem();
  } catch (const std::exception& error) {
    // The search is tried again, in case the network comes back.
    source_.reset();
    problem = std::string("Robots cannot be searched for (") + error.what() + "). Enter the URL instead.";
  }
  lookAt_ = robotlink::PacedThread::Clock::now() + kSearchLook;
  lock.lock();
  note(std::move(robots), std::move(problem));
}

void RobotSearch::note(std::vector<AnnouncedRobots> robots, std::string problem) {
  if (!isWanted_) return;
  const robotlink::Instant now = clock_->now();
  if (!std::exchange(isListening_, true)) since_ = now;
  problem_ = std::move(problem);
  const auto before = std::exchange(heard_, {});
  for (AnnouncedRobots& one : robots) {
    std::string url = one.url();
    const auto known = before.find(url);
    heard_[std::move(url)] = {std::move(one), known == before.end() ? now : known->second.since};
  }
}

}  // namespace app
