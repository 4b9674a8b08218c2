// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/program/HostedProgram.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

/// A robot's program in the process of the operating system that hosts it: all costs nothing, and whatever
/// crashes in it crashes all.
class InsideProgram final : public HostedProgram {
 public:
  static Made create(Parts parts) { return create(std::move(parts), {}); }
  /// Creates one of several programs, the one with the debug process.
  static Made create(Parts parts, const robotlink::RobotProgram::Part& part);
  ~InsideProgram() override;

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
  robotlink::RobotProgram* inside() override { return program_.get(); }
  bool request(const robotcontrol::Request& request) override;
  std::unique_ptr<ProgramPreview> preview() override;
  std::string missingProcess() const override;
  robotcontrol::HostingStatus hosting() const override { return {}; }
  void stop() override;

 private:
  explicit InsideProgram(std::unique_ptr<robotlink::RobotProgram> program);

  const std::unique_ptr<robotlink::RobotProgram> program_;
};

}  // namespace app
