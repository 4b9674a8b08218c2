// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>

#include "app/core/program/HostedProgram.h"

namespace app {

/// A robot's program in a process of the operating system of its own (OWN_PROCESS.md). Whatever ends that
/// process, or keeps it busy, concerns only this robot: the platform then is unattended, and the robot
/// stands. In lockstep it computes the same as an InsideProgram, byte by byte.
class OwnProgram final : public HostedProgram {
 public:
  struct Options {
    /// What is started; the executable's main() begins with ownProgramMain().
    std::filesystem::path executable = "/proc/self/exe";
    /// How long a step, or the answer to a question, may take before the program counts as not answering.
    std::chrono::milliseconds patience{2000};
    /// How long it may take to be made.
    std::chrono::milliseconds startLimit{20'000};
    /// How much memory it may allocate, bytes; 0: as much as there is.
    std::uint64_t memoryLimit = std::uint64_t{2} << 30U;
  };
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
  bool request(const robotcontrol::Request& request) override;
  std::string refusal() const override;
  std::unique_ptr<ProgramPreview> preview() override;
  void startStep() override;
  robotcontrol::HostingStatus hosting() const override;
  void stop() override;

 private:
  struct Implementation;
  explicit OwnProgram(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace app
