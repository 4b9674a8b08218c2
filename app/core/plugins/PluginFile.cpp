// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/plugins/PluginFile.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <string_view>

#include "robotlink/base/Plugin.h"
#include "robotlink/base/Registrations.h"

namespace app {
namespace {

/// Longer than any interface's text.
constexpr std::size_t kLongestInterface = 80;

/// The interface for which a file was built, up to the end of its text; empty if there is none in the file.
/// Reads the file in pieces, whatever its length.
std::string interfaceOf(const std::filesystem::path& file) {
  constexpr std::string_view kMark = ROBOTCONTROL_PLUGIN_MARK;
  std::ifstream stream(file, std::ios::binary);
  std::string window;
  std::array<char, 1 << 16> piece{};
  do {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    window.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    const std::size_t at = window.find(kMark);
    // The text is whole if enough follows, or nothing does.
    if (at != std::string::npos && (window.size() >= at + kLongestInterface || !stream))
      return window.substr(at, window.find('\0', at) - at).substr(0, kLongestInterface);
    if (at == std::string::npos && window.size() > kMark.size())
      window.erase(0, window.size() - kMark.size());
  } while (stream);
  return {};
}

/// Empty if the file may be loaded.
std::string problemOfFile(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return "there is no such file";
  if (!std::ifstream(file)) return "this file cannot be read; check its permissions";
  const std::string built = interfaceOf(file);
  if (built.empty())
    return "this is no plug-in of RobotControl; remove it from the folder of plug-ins, or ask its author for "
           "one";
  if (built == ROBOTCONTROL_PLUGIN_INTERFACE) return {};
  return "it was built for the '" + built +
         "', but this is the '" ROBOTCONTROL_PLUGIN_INTERFACE
         "'; build the plug-in again with the headers of this version";
}

/// Returns why it failed; empty if it did not.
std::string registerAll(const robotlink::PluginDescription& plugin) {
  try {
    plugin.registerAll();
  } catch (const std::exception& thrown) {
    return std::string("it has failed: ") + thrown.what();
  } catch (...) {
    return "it has failed with an exception without a text";
  }
  return robotlink::RegistrationTrial::problem();
}

std::string orEmpty(const char* text) {
  return text == nullptr ? std::string() : text;
}

}  // namespace

LoadedPlugin loadPlugin(const std::filesystem::path& file) {
  LoadedPlugin plugin;
  plugin.file = std::filesystem::absolute(file);
  plugin.problem = problemOfFile(plugin.file);
  if (!plugin.problem.empty()) return plugin;
  robotlink::RegistrationTrial trial;
  void* library = ::dlopen(plugin.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    plugin.problem = std::string("it cannot be loaded: ") + ::dlerror();
    return plugin;
  }
  const auto* description =
      static_cast<const robotlink::PluginDescription*>(::dlsym(library, "robotcontrolPlugin"));
  if (description == nullptr || description->registerAll == nullptr) {
    plugin.problem =
        "it has no description; write ROBOTCONTROL_PLUGIN (robotlink/base/Plugin.h) into one source";
    return plugin;
  }
  plugin.name = orEmpty(description->name);
  plugin.version = orEmpty(description->version);
  plugin.help = orEmpty(description->help);
  plugin.problem = registerAll(*description);
  if (plugin.problem.empty()) trial.keep();
  return plugin;
}

}  // namespace app
