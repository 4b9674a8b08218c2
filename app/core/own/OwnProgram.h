// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/core/own/OwnProgramOptions.h"
#include "app/core/program/HostedProgram.h"

namespace app {

/// A robot's program in a process of the operating system of its own (OWN_PROCESS.md). Whatever ends that
/// process, or keeps it busy, concerns only this robot: the platform then is unattended, and the robot
/// stands still. In lockstep it computes the same as an InsideProgram, byte by byte. One thread at a time.
class OwnProgram final : public HostedProgram {
 public:
  using Options = OwnProgramOptions;
  static Maker maker(Options options);
  ~OwnProgram() override;

  void setListeners(Listeners listeners) override;
  std::vector<robotcontrol::ParameterValues> parameters() const override;
  void recordPackages(const std::set<std::string>& packages) override;
  void setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes) override;
  const robotlink::Layout& layout() const override;
  std::vector<std::string> yieldedPackages() const override;
  const std::vector<robotlink::Process*>& processes() const override;
  const robotlink::Process& debugProcess() const override;
  void offer(const robotlink::PackagePtr& package) override;
  void tap(const std::set<std::string>& packages, PackageTap tap) override;
  bool request(const robotcontrol::Request& request) override;
  std::string refusal() const override;
  std::unique_ptr<ProgramPreview> preview() override;
  void startStep() override;
  std::string missingProcess() const override;
  robotcontrol::HostingStatus hosting() const override;
  void stop() override;

 private:
  struct Implementation;
  explicit OwnProgram(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace app
