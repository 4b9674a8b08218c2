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

/// The platform of a replayed robot: sends the packages that a log contains, at the times at which they were
/// published.
///
/// The order within an instant is that of the recording: the packages of the platform first, those of a
/// process when that process would have sent them, so that processes that run before it in a step see them as
/// late as they did. turnOf() is to be executed before the process that it represents, or instead of it.
/// Actuation has no effect. The clock must outlive this object; only for lockstep execution.
class LogPlatform final : public robotlink::Platform {
 public:
  /// A package that comes from the log.
  struct Package {
    std::string name;
    /// The process in whose turn it is sent; empty: the platform.
    std::string process;
    /// The type that receivers expect.
    const google::protobuf::Descriptor* type = nullptr;
  };
  LogPlatform(const robotlink::Clock& clock, std::vector<Package> packages);
  ~LogPlatform() override;

  /// Enqueues a value for the next turn. Returns false without any effect if the package is not among those
  /// of the constructor or the value has another type.
  bool put(const std::string& package, const robotlink::PackagePtr& value);
  /// Returns the stand-in for a process; null if none of its packages comes from the log.
  robotlink::Process* turnOf(const std::string& process);

  /// A replayed robot cannot move.
  void actuate() override {}
  void engageStop(bool) override {}
  std::string refusal() const override {
    return "a logged robot cannot be controlled; pause the log instead";
  }

 protected:
  /// Sends the packages of the platform.
  void execute() override;

 private:
  /// The stand-in for a process in the order of execution.
  class Turn;
  /// A package with its sender and its queue.
  struct Entry {
    Package package;
    std::unique_ptr<robotlink::AnySender> sender;
    /// Values to be sent in this instant.
    std::vector<robotlink::PackagePtr> waiting;
  };
  /// Sends the waiting values of all packages of a process.
  void sendTurn(const std::string& process);

  /// Keyed by package.
  std::map<std::string, Entry> entries_;
  /// Keyed by process.
  std::map<std::string, std::unique_ptr<Turn>> turns_;
};

}  // namespace logplayer
