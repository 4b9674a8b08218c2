// SPDX-License-Identifier: GPL-3.0-or-later
// robotctl plugins: what plug-ins there are.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
#include "app/core/plugins/Plugins.h"
#include "app/robotctl/Commands.h"
#include "robotlink/base/Plugin.h"
#include "robotlink/base/Printable.h"

namespace app {
namespace {

void printPlugins() {
  std::cout << ROBOTCONTROL_PLUGIN_INTERFACE << ", folder " << pluginFolder().string() << "\n";
  for (const LoadedPlugin& plugin : loadedPlugins()) {
    const std::string said = plugin.problem.empty() ? plugin.name + " " + plugin.version + "  " + plugin.help
                                                    : "not loaded: " + plugin.problem;
    std::cout << robotlink::printable(plugin.file.string() + "  " + said) << "\n";
  }
}

void printPluginsAsJson() {
  nlohmann::json list = nlohmann::json::array();
  for (const LoadedPlugin& plugin : loadedPlugins()) {
    list.push_back({{"file", plugin.file.string()},
                    {"name", plugin.name},
                    {"version", plugin.version},
                    {"help", plugin.help},
                    {"problem", plugin.problem}});
  }
  const nlohmann::json object{{"interface", ROBOTCONTROL_PLUGIN_INTERFACE},
                              {"folder", pluginFolder().string()},
                              {"plugins", std::move(list)}};
  std::cout << jsonOutput(object);
}

}  // namespace

void addPluginOptions(CLI::App& app) {
  app.add_option_function<std::vector<std::string>>(
         "--plugin", [](const auto&) {}, "Also load this plug-in; may be given several times")
      ->expected(1)
      ->take_all();
  app.add_flag_function(
      "--no-plugins", [](auto) {}, "Do not load the plug-ins in the user's folder");
}

void addPluginsCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "plugins", "List the plug-ins, and why any was not loaded; the exit status is 1 if so");
  const auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, "Print a JSON object");
  command->callback([asJson, &status] {
    *asJson ? printPluginsAsJson() : printPlugins();
    status = pluginProblems().empty() ? kDone : kFailed;
  });
}

}  // namespace app
