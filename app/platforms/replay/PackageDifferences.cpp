// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/PackageDifferences.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string_view>

#include "robotlink/expressions/FieldPath.h"
#include "robotlink/expressions/NumericFields.h"

namespace app {

using robotlink::Instant;

namespace {

/// Whether a field is a direction in rad, for which a full turn makes no difference; by its name, as the
/// packages use it.
bool isDirection(std::string_view field) {
  constexpr std::array<std::string_view, 4> kDirections{"heading", "bearing", "compass", "yaw"};
  const std::string_view name = field.substr(field.rfind('.') + 1);
  return std::ranges::find(kDirections, name) != kDirections.end();
}

}  // namespace

void PackageDifferences::endInstant(Instant now) {
  std::set<std::string> packages;
  for (const auto& [package, values] : logged_) packages.insert(package);
  for (const auto& [package, values] : recomputed_) packages.insert(package);
  for (const std::string& package : packages) {
    Largest largest;
    const Counts counts = compare(logged_[package], recomputed_[package], largest);
    summaries_[package].add(now, counts, std::move(largest));
  }
  dropInstant();
}

void PackageDifferences::dropInstant() {
  logged_.clear();
  recomputed_.clear();
}

void PackageDifferences::clear() {
  dropInstant();
  summaries_.clear();
}

void PackageDifferences::describe(const std::string& robot, robotlink::Duration offset,
                                  robotcontrol::ReplayStatus& to) const {
  for (const auto& [package, summary] : summaries_) {
    auto& row = *to.add_differences();
    row.set_package(robot + "/" + package);
    summary.describe(offset, row);
  }
}

// ---- An instant

PackageDifferences::Counts PackageDifferences::compare(const Values& logged, const Values& recomputed,
                                                       Largest& largest) {
  const std::size_t both = std::min(logged.size(), recomputed.size());
  Counts counts;
  counts.compared = static_cast<std::uint16_t>(both);
  counts.onlyLogged = static_cast<std::uint16_t>(logged.size() - both);
  counts.onlyRecomputed = static_cast<std::uint16_t>(recomputed.size() - both);
  for (std::size_t i = 0; i < both; ++i) {
    if (logged[i]->GetDescriptor() == recomputed[i]->GetDescriptor() &&
        logged[i]->SerializeAsString() == recomputed[i]->SerializeAsString()) {
      continue;
    }
    ++counts.different;
    compareNumbers(*logged[i], *recomputed[i], largest);
  }
  return counts;
}

// Fields that only one of the messages has do not count here: they differ in presence, not in a number.
void PackageDifferences::compareNumbers(const google::protobuf::Message& logged,
                                        const google::protobuf::Message& recomputed, Largest& largest) {
  for (const std::string& field : robotlink::numericFields(recomputed)) {
    const auto before = robotlink::numberAt(logged, field);
    const auto after = robotlink::numberAt(recomputed, field);
    if (!before || !after) continue;
    double difference = std::abs(*after - *before);
    if (isDirection(field)) difference = std::abs(std::remainder(*after - *before, 2 * std::numbers::pi));
    // If only one of them is NaN, no difference is larger.
    if (std::isnan(difference)) {
      difference = std::isnan(*before) == std::isnan(*after) ? 0 : std::numeric_limits<double>::infinity();
    }
    if (difference <= largest.difference) continue;
    largest.field = field;
    largest.difference = difference;
  }
}

// ---- A package

// `sign` is 1 to add, or all ones (-1) to subtract, since unsigned numbers wrap around.
void PackageDifferences::Summary::count(const Counts& counts, std::uint64_t sign) {
  compared_ += sign * counts.compared;
  different_ += sign * counts.different;
  onlyLogged_ += sign * counts.onlyLogged;
  onlyRecomputed_ += sign * counts.onlyRecomputed;
}

void PackageDifferences::Summary::add(Instant now, const Counts& counts, Largest largest) {
  const auto at = std::ranges::lower_bound(entries_, now, {}, &Entry::time);
  if (at != entries_.end() && at->time == now) {
    count(at->counts, ~std::uint64_t{0});
    at->counts = counts;
  } else {
    entries_.insert(at, {now, counts});
  }
  count(counts, 1);
  largest.time = now;
  const bool differs = counts.different + counts.onlyLogged + counts.onlyRecomputed > 0;
  const bool wasLargest = largest_.difference > 0 && largest_.time == now;
  if (differs) {
    differing_[now] = largest;
  } else {
    differing_.erase(now);
  }
  if (largest.difference > largest_.difference) {
    largest_ = std::move(largest);
  } else if (wasLargest) {
    findLargest();
  }
}

void PackageDifferences::Summary::findLargest() {
  largest_ = {};
  for (const auto& [time, candidate] : differing_) {
    if (candidate.difference > largest_.difference) largest_ = candidate;
  }
}

void PackageDifferences::Summary::describe(robotlink::Duration offset,
                                           robotcontrol::ReplayStatus::Difference& to) const {
  const auto time = [&](Instant instant) { return (instant + offset).time_since_epoch().count(); };
  to.set_compared(compared_);
  to.set_different(different_);
  to.set_only_logged(onlyLogged_);
  to.set_only_recomputed(onlyRecomputed_);
  if (!differing_.empty()) to.set_first_time(time(differing_.begin()->first));
  if (largest_.difference <= 0) return;
  to.set_largest(largest_.difference);
  to.set_largest_field(largest_.field);
  to.set_largest_time(time(largest_.time));
}

}  // namespace app
