// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/own/StandInProcess.h"
#include "robotcontrol/ProgramWire.pb.h"
#include "robotlink/base/Clock.h"
#include "robotlink/process/Platform.h"

namespace app {

/// Stands for the platform in the process of a robot's program: has the same senders and receivers, sends
/// what the platform has sent, and takes what goes to it. The clock must outlive it.
class MirrorPlatform final : public robotlink::Platform {
 public:
  MirrorPlatform(const robotcontrol::WireSetup& setup, const robotlink::Clock& clock);

  /// Sets the packages that the next frame sends, and the turns.
  void setPackages(google::protobuf::RepeatedPtrField<robotcontrol::WirePackage> packages);
  /// Returns what is executed in the turn of a process: the platform then sends its packages. Null if there
  /// are none.
  robotlink::Process* turnOf(const std::string& process);
  /// Adds what has arrived since the last call.
  void takeTo(google::protobuf::RepeatedPtrField<robotcontrol::WirePackage>& packages);
  /// Adds the indices of senders, or of receivers, that are connected.
  void connectedTo(google::protobuf::RepeatedField<std::uint32_t>& senders) const;
  void fedTo(google::protobuf::RepeatedField<std::uint32_t>& receivers) const;

  /// Called when a package has arrived, in the thread that sent it. Before the program runs.
  void setWakeUp(std::function<void()> wakeUp) { wakeUp_ = std::move(wakeUp); }

  void wake() override;
  void actuate() override {}
  void engageStop(bool) override {}
  std::vector<robotlink::AnySender*> onRequest() override { return onRequest_; }

 protected:
  void execute() override;

 private:
  /// Sends the packages of a turn; those of none if it is empty.
  void sendTurn(const std::string& turn);

  std::vector<std::unique_ptr<robotlink::AnySender>> senders_;
  std::vector<std::string> turnOfSender_;
  std::map<std::string, std::unique_ptr<StandInProcess>> turns_;
  std::vector<std::unique_ptr<robotlink::AnyReceiver>> receivers_;
  /// The number of packages that each receiver had taken when takeTo() was last called.
  std::vector<std::uint64_t> taken_;
  std::vector<robotlink::AnySender*> onRequest_;
  google::protobuf::RepeatedPtrField<robotcontrol::WirePackage> packages_;
  std::function<void()> wakeUp_;
};

/// A package in its form on the wire, and back: null if its type is unknown.
void assign(robotcontrol::WirePackage& to, std::size_t port, const google::protobuf::Message& package);
robotlink::PackagePtr packageIn(const robotcontrol::WirePackage& wire);

}  // namespace app
