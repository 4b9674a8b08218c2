// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace app {

/// A plug-in that was loaded, or why it was not. A plain value.
struct LoadedPlugin {
  std::filesystem::path file;
  /// The plug-in's statements about itself; empty if it could not be loaded.
  std::string name, version, help;
  /// In a sentence that says what to do; empty if the plug-in is in use.
  std::string problem;
};

/// Loads one plug-in (robotlink/base/Plugin.h) and registers what it has, before registrations are sealed. A
/// file that is none, or was built for another version of the interface, is not executed. What a plug-in that
/// fails has registered is undone. It is never unloaded, since its classes may be in use until the end. In
/// the thread of main().
LoadedPlugin loadPlugin(const std::filesystem::path& file);

}  // namespace app
