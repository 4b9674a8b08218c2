// SPDX-License-Identifier: GPL-3.0-or-later
// SimulationFeed: how a scene is opened, with what was chosen before.
#include <utility>

#include "app/core/platform/HostingMemory.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "robotlink/debugging/RegisteredTasks.h"

namespace app {
namespace {

/// The options of the last simulation, as the adapter's memory keeps them; at first, programs run where they
/// did in the last run of the workbench.
std::shared_ptr<RunOptions> lastSimulation(const PlatformContext& context) {
  std::any& memory = context.memory;
  if (!memory.has_value()) {
    const auto first = std::make_shared<RunOptions>(defaultSimulation());
    first->scene.clear();
    if (context.hosting != nullptr) {
      first->hosting = context.hosting->choices(SimulationFeed::kAdapter);
      first->models = context.hosting->modelFolders();
    }
    memory = first;
  }
  return std::any_cast<std::shared_ptr<RunOptions>>(memory);
}

/// Layouts, solutions and rules belong to a scene: what was chosen in it when it was open before, as far as
/// it still exists, takes the place of what was chosen in the last one.
void useTeamPrograms(const PlatformContext& context, const std::filesystem::path& scene,
                     RunOptions& options) {
  if (options.scene == scene) return;
  options.layouts.clear();
  options.robotLayouts.clear();
  options.solutions.clear();
  options.robotSolutions.clear();
  options.keptSolutions.clear();
  options.shadows.clear();
  options.game.clear();
  const auto kept = context.hosting != nullptr ? context.hosting->teamPrograms(scene) : std::nullopt;
  if (!kept) return;
  options.layouts = kept->layouts;
  options.robotLayouts = kept->robotLayouts;
  // In older settings the names of robots and teams are among those of kinds.
  for (auto one = options.layouts.begin(); one != options.layouts.end();) {
    std::error_code ignored;
    const auto next = std::next(one);
    if (!std::filesystem::exists(descriptionFile(one->first), ignored))
      options.robotLayouts.insert(options.layouts.extract(one));
    one = next;
  }
  for (auto* layouts : {&options.layouts, &options.robotLayouts}) {
    std::erase_if(*layouts, [](const auto& one) {
      std::error_code ignored;
      return !std::filesystem::exists(one.second, ignored);
    });
  }
  const auto catalog = robotlink::registeredTasks();
  options.keptSolutions = kept->solutions;
  for (auto& [name, solutions] : options.keptSolutions)
    std::erase_if(solutions, [&](const auto& one) { return catalog.find(one.first, one.second) == nullptr; });
}

/// Keeps the options of a simulation for the next one; and where the user lets programs run, as far as that
/// has changed since it was opened, for the next run of the workbench.
SimulationFeed::Choices keeperOf(std::shared_ptr<RunOptions> last, HostingMemory* hosting) {
  return [last = std::move(last), hosting,
          known = std::optional<HostingChoices>()](const RunOptions& running) mutable {
    *last = running;
    const HostingChoices& now = running.hosting;
    if (hosting != nullptr) hosting->chooseModelFolders(running.models);
    const TeamPrograms chosen{running.layouts, running.robotLayouts, running.keptSolutions};
    if (hosting != nullptr) hosting->chooseTeamPrograms(running.scene, chosen);
    if (hosting != nullptr && known && *known != now) hosting->choose(SimulationFeed::kAdapter, now);
    known = now;
  };
}

}  // namespace

PlatformOpening SimulationFeed::opening(const RunOptions& options) {
  return opening(options.scene, [options](RunOptions& last) { last = options; });
}

PlatformOpening SimulationFeed::opening(const std::filesystem::path& scene,
                                        std::function<void(RunOptions& options)> adapt) {
  const auto make = [scene,
                     adapt = std::move(adapt)](const PlatformContext& context) -> PlatformOpening::Made {
    const std::shared_ptr<RunOptions> last = lastSimulation(context);
    RunOptions options = *last;
    options.texts.clear();
    useTeamPrograms(context, scene, options);
    adapt(options);
    options.scene = scene;
    options.progress = context.progress;
    return create(std::move(options), context.session, context.recorder, keeperOf(last, context.hosting));
  };
  return {kAdapter, {scene.string()}, make, scene};
}

}  // namespace app
