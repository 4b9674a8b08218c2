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

/// How recomputed packages differ from those logged at the same instants. An instant that is gone over again
/// counts with what it gave last. Costs 16 bytes an instant and package, more where they differ. One thread.
class PackageDifferences {
 public:
  // Of the current instant.
  void addLogged(const std::string& package, const robotlink::PackagePtr& value) {
    logged_[package].push_back(value);
  }
  void addRecomputed(const std::string& package, const robotlink::PackagePtr& value) {
    recomputed_[package].push_back(value);
  }
  /// Compares what was added, the n-th of a package with the n-th.
  void endInstant(robotlink::Instant now);
  /// Forgets what was added.
  void dropInstant();
  /// Forgets everything.
  void clear();

  /// By package; times are moved by `offset`.
  void describe(const std::string& robot, robotlink::Duration offset, robotcontrol::ReplayStatus& to) const;

 private:
  using Values = std::vector<robotlink::PackagePtr>;
  struct Counts {
    std::uint16_t compared = 0;
    std::uint16_t different = 0;
    std::uint16_t onlyLogged = 0;
    std::uint16_t onlyRecomputed = 0;
  };
  /// The largest difference of a number.
  struct Largest {
    std::string field;
    double difference = 0;
    robotlink::Instant time;
  };
  /// What there is to tell of a package.
  class Summary {
   public:
    void add(robotlink::Instant now, const Counts& counts, Largest largest);
    void describe(robotlink::Duration offset, robotcontrol::ReplayStatus::Difference& to) const;

   private:
    struct Entry {
      robotlink::Instant time;
      Counts counts;
    };
    void count(const Counts& counts, std::uint64_t sign);
    void findLargest();

    std::vector<Entry> entries_;  // by time
    std::map<robotlink::Instant, Largest> differing_;
    std::uint64_t compared_ = 0, different_ = 0, onlyLogged_ = 0, onlyRecomputed_ = 0;
    Largest largest_;
  };
  static Counts compare(const Values& logged, const Values& recomputed, Largest& largest);
  static void compareNumbers(const google::protobuf::Message& logged,
                             const google::protobuf::Message& recomputed, Largest& largest);

  std::map<std::string, Values> logged_, recomputed_;
  std::map<std::string, Summary> summaries_;  // by package
};

}  // namespace app
