// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/core/program/HostedProgram.h"
#include "app/core/remote/BodyInbox.h"

namespace app {

/// Stands in for the program of a robot that is only a body, because its program runs remotely
/// (REMOTE_BODY.md). In each frame it publishes what the platform has sent, and gives the platform the newest
/// commands from the BodyInbox.
///
/// The watchdog: commands say which readings they answer. When the newest one answers readings that are older
/// than `watchdog`, or says that STOP is engaged there, the robot stops, whether commands are lost or late.
/// Only the body's own clock counts.
class BodyProgram final : public HostedProgram {
 public:
  struct Options {
    /// The inbox; not null.
    std::shared_ptr<BodyInbox> inbox;
    robotlink::Duration watchdog = std::chrono::milliseconds(500);
    /// The time between two frames; 0: one in each step, for lockstep.
    robotlink::Duration period{0};
  };
  static Maker maker(Options options);
  ~BodyProgram() override;

  void setListeners(Listeners listeners) override;
  std::vector<robotcontrol::ParameterValues> parameters() const override { return {}; }
  void recordPackages(const std::set<std::string>&) override {}
  void setKeys(const std::map<std::string, robotcontrol::KeyMode>&) override {}
  /// A layout without processes.
  const robotlink::Layout& layout() const override;
  std::vector<std::string> yieldedPackages() const override { return {}; }
  const std::vector<robotlink::Process*>& processes() const override;
  const robotlink::Process& debugProcess() const override;
  /// Ignores the request: what needs a program is refused before, and the rest concerns none.
  bool request(const robotcontrol::Request&) override { return true; }
  std::string refusal() const override;
  std::unique_ptr<ProgramPreview> preview() override;
  robotcontrol::HostingStatus hosting() const override;
  void stop() override;

 private:
  struct Implementation;
  explicit BodyProgram(std::unique_ptr<Implementation> implementation);
  const std::unique_ptr<Implementation> implementation_;
};

}  // namespace app
