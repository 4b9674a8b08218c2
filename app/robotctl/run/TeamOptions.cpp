// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/TeamOptions.h"

#include <CLI/CLI.hpp>

#include "app/core/program/ColorTables.h"
#include "app/core/program/PresetOverrides.h"
#include "app/core/program/SolutionChoices.h"
#include "robotlink/session/Presets.h"

namespace app {
namespace {

using robotlink::Errors;

/// WHAT for all, whose name is empty, or NAME=WHAT.
std::pair<std::string, std::string> nameAndFile(const std::string& text) {
  std::error_code ignored;
  const auto choice = assignmentOf(text);
  // A file may be called so.
  return choice && !std::filesystem::exists(text, ignored) ? *choice : std::pair(std::string(), text);
}

tl::expected<void, Errors> choosePreset(const std::string& text, RunOptions& run) {
  const auto [name, file] = nameAndFile(text);
  auto preset = presetToStartWith(file);
  if (!preset) return tl::unexpected(std::move(preset.error()));
  auto& chosen = name.empty() ? run.preset : run.robotPresets[name];
  chosen = std::make_shared<const robotlink::Preset>(std::move(*preset));
  return {};
}

robotlink::Result<void> chooseColorTable(const std::string& text, RunOptions& run) {
  const auto [name, file] = nameAndFile(text);
  auto table = readColorTable(file);
  if (!table) return tl::unexpected(std::move(table.error()));
  run.colorTables[name] = std::move(*table);
  return {};
}

}  // namespace

void TeamOptions::addTo(CLI::App& command) {
  command
      .add_option("--layout", layouts,
                  "A process layout: a file, or the name of a shipped one, for all robots that can be run in "
                  "it; or NAME=LAYOUT for one robot, team or kind of robots; may be given several times")
      ->expected(1)
      ->take_all();
  command.add_option("--solution", solutions,
                     "TASK=SOLUTION to start with, instead of the layout's; NAME/TASK=SOLUTION for one robot "
                     "or team");
  command
      .add_option("--preset", presets,
                  "A preset (a file, or a name of one of yours) with the keys, solutions and parameters that "
                  "all programs start with; NAME=PRESET for one robot or team")
      ->expected(1)
      ->take_all();
  command
      .add_option("--color-table", colorTables,
                  "A color table (.c64, or another team's) that all programs start with, instead of one made "
                  "from the field's colors; NAME=TABLE for one robot or team")
      ->expected(1)
      ->take_all();
  command.add_option(
      "--shadow", shadows,
      "TASK=SOLUTION to run in all programs in the shadow of the active one, on the same inputs; "
      "NAME/TASK=SOLUTION for one robot or team; --errors gives it its own figures");
  command.add_option("--game", game,
                     "The rules of the game: the name of shipped ones (2002), or a file; none: without a "
                     "referee (default: as the scene says)");
}

robotlink::Result<void> TeamOptions::check(const SimulatedRun& run) {
  const auto find = [&](const auto& chosen, const std::string& option) -> robotlink::Result<void> {
    for (const auto& [name, what] : chosen) {
      if (run.hasRobotOrTeam(name)) continue;
      return robotlink::failure("sim.no-robot",
                                "there is no robot, team or kind of robots " + name +
                                    " in this scene, for which " + option + " chooses one",
                                {}, {name});
    }
    return {};
  };
  if (auto found = find(run.options().robotLayouts, "--layout"); !found) return found;
  if (auto found = find(run.options().robotSolutions, "--solution"); !found) return found;
  if (auto found = find(run.options().robotPresets, "--preset"); !found) return found;
  auto shadows = run.options().shadows;
  shadows.erase("");
  if (auto found = find(shadows, "--shadow"); !found) return found;
  auto tables = run.options().colorTables;
  tables.erase("");
  return find(tables, "--color-table");
}

tl::expected<void, Errors> TeamOptions::applyTo(RunOptions& run) const {
  Errors errors;
  if (auto chosen = chooseLayouts(layouts, run); !chosen) errors.push_back(chosen.error());
  if (auto chosen = chooseSolutions(solutions, run); !chosen) errors.push_back(chosen.error());
  for (const std::string& preset : presets) {
    if (auto chosen = choosePreset(preset, run); !chosen)
      errors.insert(errors.end(), chosen.error().begin(), chosen.error().end());
  }
  for (const std::string& table : colorTables) {
    if (auto chosen = chooseColorTable(table, run); !chosen) errors.push_back(chosen.error());
  }
  if (auto chosen = chooseShadows(shadows, run); !chosen) errors.push_back(chosen.error());
  run.game = game;
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return {};
}

}  // namespace app
