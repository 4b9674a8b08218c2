// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace app {

/// How recomputed packages differ from those logged at the same instants. An instant that is gone over again counts with what it
/// gave last. One thread.
class PackageDifferences {
 public:
  // Of the current instant.
  void addLogged(const std::string& package, const robotlink::PackagePtr& value) { logged_[package].push_back(value); }
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
  /// The largest difference of a number.
  struct Largest {
    std::string field;
    double difference = 0;
  };
  struct Outcome {
    std::uint32_t compared = 0;
    std::uint32_t different = 0;
    std::uint32_t onlyLogged = 0;
    std::uint32_t onlyRecomputed = 0;
    Largest largest;
  };
  using Values = std::vector<robotlink::PackagePtr>;
  static Outcome compare(const Values& logged, const Values& recomputed);
  static void compareNumbers(const google::protobuf::Message& logged, const google::protobuf::Message& recomputed,
                             Largest& largest);

  std::map<std::string, Values> logged_, recomputed_;
  std::map<std::string, std::map<robotlink::Instant, Outcome>> outcomes_;  // by package
};

}  // namespace app
