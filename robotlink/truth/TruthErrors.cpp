// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/TruthErrors.h"

#include <google/protobuf/message.h>
#include <google/protobuf/timestamp.pb.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/truth/PackageComparison.h"

namespace robotlink {
namespace {

// The truth of an image that a slow process has looked at is still there.
constexpr std::size_t kMaxTruths = 1000;
/// Slightly more than arrive in the time by which the truth may be late.
constexpr std::size_t kMaxWaiting = 2000;
// Between two truths that follow each other.
constexpr Duration kSameTime = std::chrono::milliseconds(20);
constexpr std::string_view kShadowPrefix = "shadow/";

bool isTruth(std::string_view path) {
  return path == kOracleWorld.name || path == kOracleState.name;
}

/// The solution of a shadow's stream, and where the path of what it publishes begins; empty if it is none.
std::pair<std::string_view, std::string_view> shadowIn(std::string_view path) {
  if (!path.starts_with(kShadowPrefix)) return {{}, path};
  path.remove_prefix(kShadowPrefix.size());
  const std::size_t end = std::min(path.find('/'), path.size());
  return {path.substr(0, end), path.substr(std::min(end + 1, path.size()))};
}

bool isSolutionTable(std::string_view path) {
  return path.starts_with(streams::kSolutions);
}

/// When the readings were taken that a package is based on.
std::optional<Instant> timeOf(const google::protobuf::Message& package) {
  const auto* field = package.GetDescriptor()->FindFieldByName("timestamp");
  if (field == nullptr || field->is_repeated() || field->message_type() == nullptr) return std::nullopt;
  const auto* time =
      dynamic_cast<const google::protobuf::Timestamp*>(&package.GetReflection()->GetMessage(package, field));
  if (time == nullptr || !package.GetReflection()->HasField(package, field)) return std::nullopt;
  return instant(*time);
}

}  // namespace

TruthErrors::TruthErrors() = default;
TruthErrors::~TruthErrors() = default;

const std::vector<std::string>& TruthErrors::packages() {
  static const std::vector<std::string> kPackages = comparablePackages();
  return kPackages;
}

const std::vector<std::string>& TruthErrors::neededPackages() {
  static const std::vector<std::string> kNeeded = [] {
    std::vector<std::string> names{kOracleWorld.name, kOracleState.name, kGameState.name};
    names.insert(names.end(), packages().begin(), packages().end());
    return names;
  }();
  return kNeeded;
}

std::string_view TruthErrors::comparedPackage(std::string_view path) {
  const std::string_view package = shadowIn(path).second;
  return std::ranges::find(packages(), package) == packages().end() ? std::string_view() : package;
}

bool TruthErrors::reads(std::string_view path) {
  return isTruth(path) || path == kGameState.name || isSolutionTable(path) || !comparedPackage(path).empty();
}

void TruthErrors::add(const std::string& robot, const SharedDebugQueue& queue) {
  for (const SharedDebugMessage& message : queue.messages)
    if (message.time) add(robot, message.path, *message.time, message.content);
}

void TruthErrors::add(const std::string& name, const std::string& path, Instant published,
                      const PackagePtr& value) {
  if (!value || !reads(path)) return;
  Robot& robot = robots_[name];
  if (isSolutionTable(path)) {
    addSolutions(robot, published, value);
    return;
  }
  if (path == kGameState.name) {
    addGameState(robot, value);
    return;
  }
  Truths& truths = robot.truths[isTruth(path) ? path : truthOf(comparedPackage(path))];
  if (!isTruth(path)) {
    truths.waiting.push_back({path, published, value});
    if (truths.waiting.size() > kMaxWaiting) truths.waiting.pop_front();
    return;
  }
  if (const auto time = timeOf(*value)) truths.known.emplace_back(*time, value);
  if (truths.known.size() > kMaxTruths) truths.known.pop_front();
  compareWaiting(name, robot, truths);
}

void TruthErrors::addGameState(Robot& robot, const PackagePtr& value) {
  const auto* game = dynamic_cast<const robotcontrol::GameState*>(value.get());
  const std::optional<Instant> time = timeOf(*value);
  if (game == nullptr || !time) return;
  const bool wasPenalized = robot.penalizedAt && !robot.playsAgainAt;
  if (game->penalized() && !wasPenalized) {
    robot.penalizedAt = time;
    robot.playsAgainAt.reset();
  } else if (!game->penalized() && wasPenalized) {
    robot.playsAgainAt = time;
  }
}

void TruthErrors::addSolutions(Robot& robot, Instant time, const PackagePtr& value) {
  const auto* table = dynamic_cast<const robotcontrol::SolutionTable*>(value.get());
  if (table == nullptr) return;
  for (const auto& task : table->tasks()) {
    const auto running = std::ranges::find(task.solutions(), task.active(),
                                           [](const auto& solution) { return solution.name(); });
    if (running == task.solutions().end()) continue;
    for (const std::string& package : running->outputs()) {
      const auto [known, isNew] =
          robot.active.try_emplace(package, Active{task.active(), task.active(), time});
      Active& active = known->second;
      if (active.solution != task.active()) active = {task.active(), active.solution, time};
    }
  }
}

std::string TruthErrors::solutionOf(const Robot& robot, const Waiting& one) {
  const auto [shadow, package] = shadowIn(one.path);
  if (!shadow.empty()) return std::string(shadow);
  const auto known = robot.active.find(package);
  if (known == robot.active.end()) return {};
  return one.published < known->second.since ? known->second.before : known->second.solution;
}

bool TruthErrors::isPenalized(const Robot& robot, Instant time) {
  return robot.penalizedAt && time >= *robot.penalizedAt &&
         (!robot.playsAgainAt || time < *robot.playsAgainAt);
}

void TruthErrors::compareWaiting(const std::string& name, const Robot& robot, Truths& truths) {
  if (truths.known.empty()) return;
  const Instant newest = truths.known.back().first;
  std::erase_if(truths.waiting, [&](const Waiting& one) {
    const std::optional<Instant> time = timeOf(*one.value);
    if (!time) return true;
    if (*time > newest) return false;
    const auto* truth = isPenalized(robot, *time) ? nullptr : truthAt(truths, *time);
    if (truth != nullptr) compare(name, robot, one, *time, *truth);
    return true;
  });
}

const google::protobuf::Message* TruthErrors::truthAt(const Truths& truths, Instant time) {
  const auto later =
      std::ranges::lower_bound(truths.known, time, {}, [](const auto& truth) { return truth.first; });
  auto best = later;
  if (later != truths.known.begin()) {
    const auto before = std::prev(later);
    if (later == truths.known.end() || time - before->first < later->first - time) best = before;
  }
  if (best == truths.known.end()) return nullptr;
  const auto distance = best->first > time ? best->first - time : time - best->first;
  return distance > kSameTime ? nullptr : best->second.get();
}

void TruthErrors::compare(const std::string& name, const Robot& robot, const Waiting& one, Instant time,
                          const google::protobuf::Message& truth) {
  PackageErrors& errors = errors_[name][{one.path, solutionOf(robot, one)}];
  comparePackage(std::string(comparedPackage(one.path)), *one.value, truth, field_.get(), errors);
  errors.latency.add(seconds(one.published - time));
}

void TruthErrors::clear() {
  robots_.clear();
  errors_.clear();
}

}  // namespace robotlink
