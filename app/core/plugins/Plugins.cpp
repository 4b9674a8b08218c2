// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/plugins/Plugins.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "robotlink/base/Registrations.h"
#include "robotlink/base/Resources.h"

namespace app {
namespace {

/// The variable with the plug-ins of a program for those that it starts, separated by colons as in PATH.
constexpr char kVariable[] = "ROBOTCONTROL_PLUGINS";

std::vector<LoadedPlugin>& plugins() {
  static std::vector<LoadedPlugin> loaded;
  return loaded;
}

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".so") files.push_back(it->path());
  }
  std::ranges::sort(files);
  return files;
}

std::vector<std::filesystem::path> filesOfParent() {
  std::vector<std::filesystem::path> files;
  const char* value = std::getenv(kVariable);
  std::string_view rest = value == nullptr ? "" : value;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (end > 0) files.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return files;
}

void load(const std::filesystem::path& file) {
  auto& all = plugins();
  std::error_code error;
  const auto isSame = [&](const LoadedPlugin& other) {
    return std::filesystem::equivalent(other.file, file, error);
  };
  if (std::ranges::any_of(all, isSame)) return;
  all.push_back(loadPlugin(file));
}

/// Makes the programs that this one starts load the same plug-ins.
void passOn() {
  std::string value;
  for (const LoadedPlugin& plugin : plugins()) {
    if (plugin.problem.empty()) value += (value.empty() ? "" : ":") + plugin.file.string();
  }
  ::setenv(kVariable, value.c_str(), 1);
}

}  // namespace

PluginOptions pluginOptions(int argc, const char* const* argv) {
  constexpr std::string_view kOption = "--plugin";
  PluginOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--") break;
    if (word == "--no-plugins") options.usesFolder = false;
    if (word == kOption && i + 1 < argc) options.files.emplace_back(argv[++i]);
    if (word.starts_with(kOption) && word.substr(kOption.size()).starts_with("="))
      options.files.emplace_back(word.substr(kOption.size() + 1));
  }
  return options;
}

std::filesystem::path pluginFolder() {
  return robotlink::userDirectory() / "plugins";
}

const std::vector<LoadedPlugin>& loadPlugins(const PluginOptions& options) {
  if (options.usesFolder) {
    for (const auto& file : filesIn(pluginFolder())) load(file);
  }
  for (const auto& file : options.files) load(file);
  robotlink::Registrations::seal();
  passOn();
  return plugins();
}

const std::vector<LoadedPlugin>& loadPluginsOfParent() {
  for (const auto& file : filesOfParent()) load(file);
  robotlink::Registrations::seal();
  return plugins();
}

const std::vector<LoadedPlugin>& loadedPlugins() {
  return plugins();
}

std::vector<std::string> pluginProblems() {
  std::vector<std::string> lines;
  for (const LoadedPlugin& plugin : plugins()) {
    if (!plugin.problem.empty()) lines.push_back(plugin.file.string() + ": " + plugin.problem);
  }
  return lines;
}

}  // namespace app
