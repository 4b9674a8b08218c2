// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/core/plugins/PluginFile.h"

namespace app {

/// The command-line options about plug-ins, which all programs have.
struct PluginOptions {
  /// `--plugin FILE`, in this order.
  std::vector<std::filesystem::path> files;
  /// Whether those in the user's folder are loaded, too; false with `--no-plugins`.
  bool usesFolder = true;
};

/// Looks for the options of plug-ins among the arguments of main(), before these can be parsed: plug-ins may
/// bring options of their own.
PluginOptions pluginOptions(int argc, const char* const* argv);

/// The user's folder of plug-ins, whose files end in ".so": "<userDirectory()>/plugins".
std::filesystem::path pluginFolder();

/// Loads those in the user's folder, by name, then those of the options, and seals registrations. Once, at
/// the start of main(). Plug-ins that fail are skipped.
const std::vector<LoadedPlugin>& loadPlugins(const PluginOptions& options);

/// The same for a process that was started by another one of ours to run a robot's program: it loads what
/// that has loaded.
const std::vector<LoadedPlugin>& loadPluginsOfParent();

/// The plug-ins that loadPlugins() has found; empty before.
const std::vector<LoadedPlugin>& loadedPlugins();

/// A line for each plug-in that failed: "/home/me/counter.so: it was built for ...".
std::vector<std::string> pluginProblems();

}  // namespace app
