// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/core/program/HostedProgram.h"
#include "app/core/spread/SpreadNetwork.h"
#include "robotlink/dds/FollowedClock.h"
#include "robotlink/dds/ProgramNet.h"
#include "robotlink/dds/ProgramPresence.h"

namespace app {

/// The part of a robot's program that has the debug process and the platform, while other programs of the
/// operating system run the other processes of its layout (LAYOUTS.md, "programs"). It announces its clock to
/// them. Its clock must outlive it and all programs that it has made.
class SpreadProgram {
 public:
  /// Called with sentences for the user, from any thread; must not block.
  using Report = std::function<void(const std::string& text)>;

  /// Fails as spreadNetworkOf() does, if the program is not the one with the debug process, or if DDS does
  /// not work.
  static robotlink::Result<std::unique_ptr<SpreadProgram>> open(const SpreadOptions& options,
                                                                const robotlink::Layout& layout,
                                                                const std::string& robot,
                                                                const robotlink::Clock& clock,
                                                                const Report& report);

  /// Makes the program; this object must outlive the maker's calls.
  HostedProgram::Maker maker();
  /// Returns why programs that are spread cannot change to the layout of a file.
  static robotlink::Error refusalOfLayout(const std::filesystem::path& file);

 private:
  SpreadProgram() = default;

  std::string program_;
  std::unique_ptr<robotlink::dds::ProgramPresence> presence_;
  std::unique_ptr<robotlink::dds::ProgramNet> net_;
  std::unique_ptr<robotlink::dds::ClockSource> clock_;
};

}  // namespace app
