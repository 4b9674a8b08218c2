// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PackageDifferences.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "robotlink/session/Numbers.h"

namespace app {

void PackageDifferences::endInstant(robotlink::Instant now) {
  std::set<std::string> packages;
  for (const auto& [package, values] : logged_) packages.insert(package);
  for (const auto& [package, values] : recomputed_) packages.insert(package);
  for (const std::string& package : packages) {
    outcomes_[package][now] = compare(logged_[package], recomputed_[package]);
  }
  dropInstant();
}

void PackageDifferences::dropInstant() {
  logged_.clear();
  recomputed_.clear();
}

void PackageDifferences::clear() {
  dropInstant();
  outcomes_.clear();
}

PackageDifferences::Outcome PackageDifferences::compare(const Values& logged, const Values& recomputed) {
  Outcome outcome;
  const std::size_t both = std::min(logged.size(), recomputed.size());
  outcome.compared = static_cast<std::uint32_t>(both);
  outcome.onlyLogged = static_cast<std::uint32_t>(logged.size() - both);
  outcome.onlyRecomputed = static_cast<std::uint32_t>(recomputed.size() - both);
  for (std::size_t i = 0; i < both; ++i) {
    if (logged[i]->GetDescriptor() == recomputed[i]->GetDescriptor() &&
        logged[i]->SerializeAsString() == recomputed[i]->SerializeAsString()) {
      continue;
    }
    ++outcome.different;
    compareNumbers(*logged[i], *recomputed[i], outcome.largest);
  }
  return outcome;
}

/// What only one of them has differs in its presence, not in a number.
void PackageDifferences::compareNumbers(const google::protobuf::Message& logged,
                                        const google::protobuf::Message& recomputed, Largest& largest) {
  for (const std::string& field : robotlink::numericFields(recomputed)) {
    const auto before = robotlink::numberAt(logged, field);
    const auto after = robotlink::numberAt(recomputed, field);
    if (!before || !after) continue;
    double difference = std::abs(*after - *before);
    // Only one is not a number: nothing differs more.
    if (std::isnan(difference)) {
      difference = std::isnan(*before) == std::isnan(*after) ? 0 : std::numeric_limits<double>::infinity();
    }
    if (difference > largest.difference) largest = {field, difference};
  }
}

void PackageDifferences::describe(const std::string& robot, robotlink::Duration offset,
                                  robotcontrol::ReplayStatus& to) const {
  const auto time = [&](robotlink::Instant instant) { return (instant + offset).time_since_epoch().count(); };
  for (const auto& [package, outcomes] : outcomes_) {
    auto& row = *to.add_differences();
    row.set_package(robot + "/" + package);
    bool any = false;
    for (const auto& [instant, outcome] : outcomes) {
      row.set_compared(row.compared() + outcome.compared);
      row.set_different(row.different() + outcome.different);
      row.set_only_logged(row.only_logged() + outcome.onlyLogged);
      row.set_only_recomputed(row.only_recomputed() + outcome.onlyRecomputed);
      const bool differs = outcome.different + outcome.onlyLogged + outcome.onlyRecomputed > 0;
      if (differs && !std::exchange(any, true)) row.set_first_time(time(instant));
      if (outcome.largest.difference <= row.largest()) continue;
      row.set_largest(outcome.largest.difference);
      row.set_largest_field(outcome.largest.field);
      row.set_largest_time(time(instant));
    }
  }
}

}  // namespace app
