// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/process/Platform.h"

namespace google::protobuf {
class Descriptor;
}

namespace logplayer {

/// The platform of a logged robot: sends the packages that a log holds, at the instants at which they were
/// told.
///
/// Each in its turn: those of the platform first, those of a process when that process would have sent them,
/// so that a process before it in the order of a step sees them as late as it did. turnOf() is to be run
/// before the process for which it stands, or in its place. Nothing is actuated. The clock must outlive it;
/// lockstep only.
class LogPlatform final : public robotlink::Platform {
 public:
  struct Package {
    std::string name;
    std::string process;  ///< in whose turn it is sent; empty: the platform's
    const google::protobuf::Descriptor* type = nullptr;
  };
  LogPlatform(const robotlink::Clock& clock, std::vector<Package> packages);
  ~LogPlatform() override;

  /// Sends it at the next turn. False, and nothing happens, if the log is not asked for this package or the
  /// value is of another type.
  bool put(const std::string& package, const robotlink::PackagePtr& value);
  /// Null if no package is sent in the turn of that process.
  robotlink::Process* turnOf(const std::string& process);

  void actuate() override {}
  void engageStop(bool) override {}

 protected:
  void execute() override;

 private:
  class Turn;
  struct Entry {
    Package package;
    std::unique_ptr<robotlink::AnySender> sender;
    std::vector<robotlink::PackagePtr> waiting;  // to be sent in this instant
  };
  void sendTurn(const std::string& process);

  std::map<std::string, Entry> entries_;                // by package
  std::map<std::string, std::unique_ptr<Turn>> turns_;  // by process
};

}  // namespace logplayer
