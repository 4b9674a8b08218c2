// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace app {

/// Counts and measures how recomputed packages differ from those that were logged at the same instants. If an
/// instant is passed again, its new result replaces the old one. Needs 16 bytes for each instant and package,
/// more where they differ. One thread.
class PackageDifferences {
 public:
  /// Adds a logged package of the current instant.
  void addLogged(const std::string& package, const robotlink::PackagePtr& value) {
    logged_[package].push_back(value);
  }
  /// Adds a recomputed package of the current instant.
  void addRecomputed(const std::string& package, const robotlink::PackagePtr& value) {
    recomputed_[package].push_back(value);
  }
  /// Compares what was added since the last instant, the n-th value of a package with the n-th.
  void endInstant(robotlink::Instant now);
  /// Drops what was added since the last instant.
  void dropInstant();
  /// Drops everything.
  void clear();

  /// Adds a row for each package; `offset` is added to all times.
  void describe(const std::string& robot, robotlink::Duration offset, robotcontrol::ReplayStatus& to) const;

 private:
  using Values = std::vector<robotlink::PackagePtr>;
  /// The values of a package in one instant: how many could be compared, how many of these differ, and how
  /// many have no counterpart.
  struct Counts {
    std::uint16_t compared = 0;
    std::uint16_t different = 0;
    std::uint16_t onlyLogged = 0;
    std::uint16_t onlyRecomputed = 0;
  };
  /// The number that differs most, with its field's path.
  struct Largest {
    std::string field;
    double difference = 0;
    robotlink::Instant time;
  };
  /// All instants of a package.
  class Summary {
   public:
    /// Adds an instant, or replaces it.
    void add(robotlink::Instant now, const Counts& counts, Largest largest);
    /// Fills in sums, the first difference and the largest one.
    void describe(robotlink::Duration offset, robotcontrol::ReplayStatus::Difference& to) const;

   private:
    /// Kept for each instant, so that it can be replaced; therefore small.
    struct Entry {
      robotlink::Instant time;
      Counts counts;
    };
    /// Adds counts to the sums, or subtracts them.
    void count(const Counts& counts, std::uint64_t sign);
    /// Finds the largest difference again, after it was replaced.
    void findLargest();

    /// In order of time.
    std::vector<Entry> entries_;
    /// The instants that differ.
    std::map<robotlink::Instant, Largest> differing_;
    std::uint64_t compared_ = 0, different_ = 0, onlyLogged_ = 0, onlyRecomputed_ = 0;
    /// The largest difference of all instants; 0 if there was none.
    Largest largest_;
  };
  /// Compares the values of a package in one instant.
  static Counts compare(const Values& logged, const Values& recomputed, Largest& largest);
  /// Updates `largest` with the numbers of two messages.
  static void compareNumbers(const google::protobuf::Message& logged,
                             const google::protobuf::Message& recomputed, Largest& largest);

  /// The current instant, by package.
  std::map<std::string, Values> logged_, recomputed_;
  /// Keyed by package.
  std::map<std::string, Summary> summaries_;
};

}  // namespace app
