// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/truth/TruthErrors.h"

#include <google/protobuf/message.h>
#include <google/protobuf/timestamp.pb.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "app/core/truth/PackageComparison.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/Packages.h"

namespace app {
namespace {

using robotlink::Instant;

// The truth of an image that a slow process has looked at is still there.
constexpr std::size_t kMaxTruths = 1000;
/// Some more than come in the time in which the truth may be late.
constexpr std::size_t kMaxWaiting = 2000;
// Between two truths that follow each other.
constexpr robotlink::Duration kSameTime = std::chrono::milliseconds(20);
constexpr std::string_view kShadowPrefix = "shadow/";

/// The package of a stream: that of "shadow/kalman/models/ball" is models/ball. Empty if it is not compared.
std::string_view comparedPackage(std::string_view path) {
  if (path.starts_with(kShadowPrefix)) {
    path.remove_prefix(kShadowPrefix.size());
    path.remove_prefix(std::min(path.find('/'), path.size() - 1) + 1);
  }
  const auto& all = TruthErrors::packages();
  return std::ranges::find(all, path) == all.end() ? std::string_view() : path;
}

/// When the readings were taken that a package is based on.
std::optional<Instant> timeOf(const google::protobuf::Message& package) {
  const auto* field = package.GetDescriptor()->FindFieldByName("timestamp");
  if (field == nullptr || field->is_repeated() || field->message_type() == nullptr) return std::nullopt;
  const auto* time =
      dynamic_cast<const google::protobuf::Timestamp*>(&package.GetReflection()->GetMessage(package, field));
  if (time == nullptr || !package.GetReflection()->HasField(package, field)) return std::nullopt;
  return robotlink::instant(*time);
}

}  // namespace

TruthErrors::TruthErrors() = default;
TruthErrors::~TruthErrors() = default;

const std::vector<std::string>& TruthErrors::packages() {
  static const std::vector<std::string> kPackages = comparablePackages();
  return kPackages;
}

void TruthErrors::add(const std::string& robot, const robotlink::SharedDebugQueue& queue) {
  for (const robotlink::SharedDebugMessage& message : queue.messages)
    if (message.time) add(robot, message.path, *message.time, message.content);
}

void TruthErrors::add(const std::string& name, const std::string& path, Instant published,
                      const robotlink::PackagePtr& value) {
  const bool isTruth = path == robotlink::kOracleWorld.name, isGame = path == robotlink::kGameState.name;
  if (!value || (!isTruth && !isGame && comparedPackage(path).empty())) return;
  Robot& robot = robots_[name];
  if (isGame) {
    addGameState(robot, value);
    return;
  }
  if (!isTruth) {
    robot.waiting.push_back({path, published, value});
    if (robot.waiting.size() > kMaxWaiting) robot.waiting.pop_front();
    return;
  }
  if (const auto time = timeOf(*value)) robot.truths.emplace_back(*time, value);
  if (robot.truths.size() > kMaxTruths) robot.truths.pop_front();
  compareWaiting(name, robot);
}

void TruthErrors::addGameState(Robot& robot, const robotlink::PackagePtr& value) {
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

bool TruthErrors::isPenalized(const Robot& robot, Instant time) {
  return robot.penalizedAt && time >= *robot.penalizedAt &&
         (!robot.playsAgainAt || time < *robot.playsAgainAt);
}

void TruthErrors::compareWaiting(const std::string& name, Robot& robot) {
  if (robot.truths.empty()) return;
  const Instant newest = robot.truths.back().first;
  std::erase_if(robot.waiting, [&](const Waiting& one) {
    const std::optional<Instant> time = timeOf(*one.value);
    if (!time) return true;
    if (*time > newest) return false;
    const auto* truth = isPenalized(robot, *time) ? nullptr : truthAt(robot, *time);
    if (truth != nullptr) compare(name, one, *time, *truth);
    return true;
  });
}

const robotcontrol::OracleWorld* TruthErrors::truthAt(const Robot& robot, Instant time) {
  const auto later =
      std::ranges::lower_bound(robot.truths, time, {}, [](const auto& truth) { return truth.first; });
  auto best = later;
  if (later != robot.truths.begin()) {
    const auto before = std::prev(later);
    if (later == robot.truths.end() || time - before->first < later->first - time) best = before;
  }
  if (best == robot.truths.end()) return nullptr;
  const auto distance = best->first > time ? best->first - time : time - best->first;
  return distance > kSameTime ? nullptr : dynamic_cast<const robotcontrol::OracleWorld*>(best->second.get());
}

void TruthErrors::compare(const std::string& robot, const Waiting& one, Instant time,
                          const robotcontrol::OracleWorld& truth) {
  PackageErrors& errors = errors_[robot][one.path];
  comparePackage(std::string(comparedPackage(one.path)), *one.value, truth, field_.get(), errors);
  errors.latency.add(robotlink::seconds(one.published - time));
}

void TruthErrors::clear() {
  robots_.clear();
  errors_.clear();
}

}  // namespace app
