// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedRun: what its robots are, each with its own kind, field and layout.
#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "app/core/program/PresetOverrides.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/program/SolutionChoices.h"
#include "app/platforms/simulated/SceneResources.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "simcore/Scene.h"
#include "simcore/world/WorldDescription.h"

namespace app {

using robotlink::Errors;

namespace {

/// The solutions of a robot, by task; those of it go before those of its team.
std::map<std::string, std::string> solutionsFor(const TeamSolutions& all, const HostedRobot& robot) {
  std::map<std::string, std::string> solutions;
  for (const std::string& name : {robot.name, robot.team}) {
    const auto own = all.find(name);
    if (!name.empty() && own != all.end()) solutions.insert(own->second.begin(), own->second.end());
  }
  return solutions;
}

}  // namespace

robotlink::Result<void> chooseLayouts(const std::vector<std::string>& texts, RunOptions& options) {
  std::error_code ignored;
  for (const std::string& text : texts) {
    const auto choice = assignmentOf(text);
    // A file may have this name.
    if (!choice || std::filesystem::exists(text, ignored)) {
      if (text.find('=') == text.size() - 1 || text.starts_with('='))
        return robotlink::failure("usage", "--layout takes LAYOUT or NAME=LAYOUT, not '" + text + "'");
      options.layout = layoutNamed(text);
    } else if (std::filesystem::exists(descriptionFile(choice->first), ignored)) {
      options.layouts[choice->first] = layoutNamed(choice->second);
    } else {
      options.robotLayouts[choice->first] = layoutNamed(choice->second);
    }
  }
  return {};
}

robotlink::Result<void> chooseSolutions(const std::vector<std::string>& texts, RunOptions& options) {
  for (const std::string& text : texts) {
    const auto choice = solutionChoiceOf(text, "--solution");
    if (!choice) return tl::unexpected(choice.error());
    auto& solutions = choice->name.empty() ? options.solutions : options.robotSolutions[choice->name];
    solutions[choice->task] = choice->solution;
  }
  return {};
}

robotlink::Result<void> chooseShadows(const std::vector<std::string>& texts, RunOptions& options) {
  for (const std::string& text : texts) {
    const auto choice = solutionChoiceOf(text, "--shadow");
    if (!choice) return tl::unexpected(choice.error());
    auto& shadows = options.shadows[choice->name];
    shadows.push_back({choice->task, choice->solution});
    if (auto known = checkShadow(shadows.back()); !known) return known;
  }
  return {};
}

tl::expected<SimulatedRun::Hosts, Errors> SimulatedRun::newHosts(const simcore::Scene& scene) const {
  struct Kind {
    std::shared_ptr<const robotlink::RobotDescription> description;
    robotlink::RobotUse use;
    std::shared_ptr<const robotlink::FieldDescription> field;
    std::filesystem::path fieldFile;
  };
  std::map<std::string, Kind> kinds;
  const auto kindOf = [&](const std::string& name) -> tl::expected<const Kind*, Errors> {
    if (const auto known = kinds.find(name); known != kinds.end()) return &known->second;
    auto description = readRobot(name);
    if (!description) return tl::unexpected(description.error());
    auto use = readUse(name);
    if (!use) return tl::unexpected(use.error());
    // Without a field in the scene, a robot has the one that its description names.
    const auto file = fieldFile(scene.field().empty() ? use->field : scene.field());
    auto field = readField(file);
    if (!field) return tl::unexpected(field.error());
    return &(kinds[name] = {std::move(*description), std::move(*use), std::move(*field), file});
  };
  const auto usesLayoutOf = [&](const simcore::SceneRobot& robot) {
    return options_.layout.empty() && !options_.layouts.contains(robot.description) &&
           !options_.robotLayouts.contains(robot.name) && !options_.robotLayouts.contains(robot.team);
  };
  if (Errors missing = missingField(scene); !missing.empty()) return tl::unexpected(std::move(missing));
  const auto& present = world_->simulation().scene().robots();
  Hosts hosts;
  for (const auto& robot : scene.robots()) {
    if (find(robot.name) != nullptr && std::ranges::find(present, robot) != present.end()) continue;
    Errors missing = missingKind(scene, robot);
    if (missing.empty() && usesLayoutOf(robot)) missing = missingLayout(scene, robot);
    if (!missing.empty()) return tl::unexpected(std::move(missing));
    const auto kind = kindOf(robot.description);
    if (!kind) return tl::unexpected(kind.error());
    const Kind& its = **kind;
    const HostedRobot hosted{robot.name,
                             robot.team,
                             its.description,
                             its.field,
                             map(),
                             its.fieldFile,
                             map() ? scene.file() : std::filesystem::path(),
                             presetOf(robot.name, robot.team),
                             presetFile(robot.name)};
    hosts.push_back(std::make_unique<RobotHost>(
        hosted,
        RobotHost::Listeners{listeners_.queue, listeners_.trouble, listeners_.platform,
                             [chosen = chosenSolutions_](const auto& request) { chosen->note(request); },
                             listeners_.hosting},
        tap_.get(), overridesOf(hosted)));
  }
  return hosts;
}

Errors SimulatedRun::describeRobots() {
  const simcore::Scene& scene = world_->simulation().scene();
  auto hosts = newHosts(scene);
  if (!hosts) return hosts.error();
  robots_ = std::move(*hosts);
  // Without a field in the scene, it is that of the first robot that has one.
  const auto knows =
      std::ranges::find_if(robots_, [](const auto& robot) { return !robot->robot().field->name.empty(); });
  if (knows != robots_.end()) {
    field_ = (*knows)->robot().field;
    return {};
  }
  auto read = readField(fieldFile(scene.field()));
  if (!read) return read.error();
  field_ = std::move(*read);
  return {};
}

Errors SimulatedRun::distributeLayout() {
  if (options_.layout.empty()) return {};
  const std::filesystem::path file = std::exchange(options_.layout, {});
  std::set<std::string> kinds;
  for (const auto& robot : robots_) kinds.insert(robot->description().name);
  Errors reasons;
  bool isUsed = false;
  for (const std::string& kind : kinds) {
    Errors why = kinds.size() > 1 ? whyNot(kind, file) : Errors{};
    if (why.empty()) {
      options_.layouts[kind] = file;
      isUsed = true;
    } else if (reasons.empty()) {
      reasons = std::move(why);
    }
  }
  return isUsed ? Errors{} : reasons;
}

std::filesystem::path SimulatedRun::layoutOf(const RobotHost& robot, const Layouts& chosen) const {
  const auto own = options_.robotLayouts.find(robot.name());
  if (own != options_.robotLayouts.end()) return own->second;
  const auto ofTeam = options_.robotLayouts.find(robot.robot().team);
  if (!robot.robot().team.empty() && ofTeam != options_.robotLayouts.end()) return ofTeam->second;
  const auto found = chosen.find(robot.description().name);
  if (found != chosen.end()) return found->second;
  const auto& placed = world_->simulation().scene().robots();
  const auto here = std::ranges::find(placed, robot.name(), &simcore::SceneRobot::name);
  return here != placed.end() && !here->layout.empty() ? layoutNamed(here->layout)
                                                       : layoutFile(robot.description());
}

std::shared_ptr<const robotlink::Preset> SimulatedRun::presetOf(const std::string& robot,
                                                                const std::string& team) const {
  auto preset = options_.preset;
  for (const std::string& name : {team, robot}) {
    const auto own = options_.robotPresets.find(name);
    if (!name.empty() && own != options_.robotPresets.end()) preset = own->second;
  }
  for (const std::string& name : std::set<std::string>{{}, team, robot}) {
    const auto shadows = options_.shadows.find(name);
    if (shadows != options_.shadows.end()) preset = withShadows(preset, shadows->second);
  }
  return preset;
}

ProgramOverrides SimulatedRun::overridesOf(const HostedRobot& robot) const {
  ProgramOverrides overrides;
  for (const std::string& name : {robot.name, robot.team, std::string()}) {
    const auto table = options_.colorTables.find(name);
    if (table == options_.colorTables.end()) continue;
    overrides.chooseColorTable(table->second);
    break;
  }
  for (const auto& [task, solution] : keptSolutionsOf(robot)) overrides.chooseSolution(task, solution);
  // A robot that was removed and put back continues with what was chosen for it.
  for (const auto& [task, solution] : solutionsFor(chosenSolutions_->all(), robot))
    overrides.chooseSolution(task, solution);
  return overrides;
}

std::map<std::string, std::string> SimulatedRun::keptSolutionsOf(const HostedRobot& robot) const {
  auto solutions = solutionsFor(options_.keptSolutions, robot);
  // Current choices take precedence over earlier ones.
  for (const auto& asked : {options_.solutions, solutionsFor(options_.robotSolutions, robot)})
    std::erase_if(solutions, [&](const auto& one) { return asked.contains(one.first); });
  return solutions;
}

RunOptions SimulatedRun::optionsToKeep() const {
  RunOptions kept = options_;
  kept.robotSolutions.clear();
  for (const auto& robot : robots_) {
    kept.keptSolutions.erase(robot->robot().team);
    kept.keptSolutions.erase(robot->name());
  }
  TeamSolutions chosen = chosenSolutions_->all();
  // Solutions for all robots would override those of a single robot, so each robot gets an entry of its own.
  std::set<std::string> tasks;
  for (const auto& [robot, solutions] : chosen)
    for (const auto& [task, solution] : solutions) tasks.insert(task);
  for (const auto& robot : robots_) {
    auto& solutions = chosen[robot->name()];
    for (const auto& [task, solution] : options_.solutions)
      if (tasks.contains(task)) solutions.emplace(task, solution);
    solutions.merge(solutionsFor(options_.robotSolutions, robot->robot()));
    solutions.merge(keptSolutionsOf(robot->robot()));
  }
  std::erase_if(kept.solutions, [&](const auto& one) { return tasks.contains(one.first); });
  for (auto& [name, solutions] : chosen) {
    if (solutions.empty()) continue;
    auto& all = kept.keptSolutions[name];
    solutions.merge(all);
    all = std::move(solutions);
  }
  return kept;
}

std::map<std::string, std::string> SimulatedRun::solutionsOf(const RobotHost& robot) const {
  auto solutions = solutionsFor(options_.robotSolutions, robot.robot());
  solutions.insert(options_.solutions.begin(), options_.solutions.end());
  return solutions;
}

tl::expected<robotlink::Layout, Errors> SimulatedRun::readLayoutOf(const RobotHost& robot,
                                                                   const std::filesystem::path& file) const {
  return readLayoutWith(file, solutionsOf(robot));
}

std::filesystem::path SimulatedRun::layoutOf(const std::string& robot) const {
  const RobotHost* host = find(robot);
  return host == nullptr ? std::filesystem::path() : layoutOf(*host, options_.layouts);
}

std::filesystem::path SimulatedRun::layout() const {
  return robots_.empty() ? std::filesystem::path() : layoutOf(*robots_.front(), options_.layouts);
}

std::map<std::string, std::filesystem::path> SimulatedRun::otherLayouts() const {
  std::map<std::string, std::filesystem::path> others;
  for (const auto& robot : robots_) {
    const auto file = layoutOf(*robot, options_.layouts);
    if (file != layout()) others[robot->name()] = file;
  }
  return others;
}

Errors SimulatedRun::checkChosenSolutions() const {
  if (options_.solutions.empty() && options_.robotSolutions.empty() && options_.shadows.empty()) return {};
  std::vector<robotlink::Layout> layouts;
  for (const auto& robot : robots_) {
    auto layout = readLayoutOf(*robot, layoutOf(*robot, options_.layouts));
    // The error is reported when its program is made.
    if (!layout) return {};
    layouts.push_back(std::move(*layout));
  }
  const auto layoutsOf = [&](const std::string& whose) {
    std::vector<const robotlink::Layout*> known;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const HostedRobot& robot = robots_[i]->robot();
      if (whose.empty() || whose == robot.name || whose == robot.team) known.push_back(&layouts[i]);
    }
    return known;
  };
  const auto check = [&](const std::map<std::string, std::string>& solutions, const std::string& whose) {
    return checkSolutions(solutions, robotlink::registeredTasks(), layoutsOf(whose));
  };
  Errors errors = check(options_.solutions, {});
  for (const auto& [name, solutions] : options_.robotSolutions) {
    // A robot that is not in the scene may be added to it later.
    if (hasRobotOrTeam(name)) std::ranges::move(check(solutions, name), std::back_inserter(errors));
  }
  for (const auto& [name, shadows] : options_.shadows) {
    if (name.empty() || hasRobotOrTeam(name))
      std::ranges::move(checkShadows(shadows, robotlink::registeredTasks(), layoutsOf(name)),
                        std::back_inserter(errors));
  }
  return errors;
}

Errors SimulatedRun::whyNot(const std::string& kind, const std::filesystem::path& layout) {
  for (const auto& robot : robots_) {
    if (robot->description().name != kind) continue;
    auto read = readLayoutOf(*robot, layout);
    if (!read) return read.error();
    auto made = makeProgram(*robot, layout, *read);
    if (!made) return made.error();
    made->program->stop();
    return {};
  }
  return {};
}

Errors SimulatedRun::setLayout(const std::filesystem::path& file) {
  Errors errors;
  std::set<std::string> kinds, changed;
  for (const auto& robot : robots_) kinds.insert(robot->description().name);
  for (const std::string& kind : kinds) {
    if (Errors reasons = whyNot(kind, file); reasons.empty()) {
      changed.insert(kind);
    } else if (errors.empty()) {
      errors = std::move(reasons);
    }
  }
  if (changed.empty()) return errors;
  Layouts layouts = options_.layouts;
  for (const std::string& kind : changed) layouts[kind] = file;
  // The layout is set for each robot, including those that had their own or their team's.
  const auto own = options_.robotLayouts;
  for (const auto& robot : robots_) {
    if (!changed.contains(robot->description().name)) continue;
    options_.robotLayouts.erase(robot->name());
    options_.robotLayouts.erase(robot->robot().team);
  }
  // A robot that keeps the layout of its team keeps it as its own.
  for (const auto& robot : robots_) {
    const auto ofTeam = own.find(robot->robot().team);
    if (!changed.contains(robot->description().name) && ofTeam != own.end())
      options_.robotLayouts.emplace(robot->name(), ofTeam->second);
  }
  auto programs = makePrograms(layouts);
  if (!programs) {
    options_.robotLayouts = own;
    return programs.error();
  }
  options_.layouts = std::move(layouts);
  spoilJournal("the layout was changed");
  startPrograms(std::move(*programs));
  return {};
}

Errors SimulatedRun::setLayoutOf(const std::string& name, const std::filesystem::path& file) {
  if (!hasRobotOrTeam(name))
    return {{"sim.no-robot", "there is no robot or team " + name + " in this scene", {name}, {}}};
  const auto before = options_.robotLayouts;
  std::vector<RobotHost*> meant;
  for (const auto& robot : robots_) {
    if (robot->name() != name && robot->robot().team != name) continue;
    meant.push_back(robot.get());
    // The robot may have had a layout of its own; its team's new one replaces it.
    options_.robotLayouts.erase(robot->name());
  }
  options_.robotLayouts[name] = file;
  Errors errors = exchangePrograms(meant);
  if (!errors.empty()) options_.robotLayouts = before;
  return errors;
}

std::vector<std::string> SimulatedRun::robots() const {
  std::vector<std::string> names;
  for (const auto& robot : robots_) names.push_back(robot->name());
  return names;
}

bool SimulatedRun::hasRobotOrTeam(const std::string& name) const {
  return std::ranges::any_of(robots_, [&](const auto& host) {
    return host->name() == name || (!name.empty() && host->robot().team == name);
  });
}

RobotHost* SimulatedRun::find(const std::string& name) const {
  const auto found = std::ranges::find_if(robots_, [&](const auto& robot) { return robot->name() == name; });
  return found == robots_.end() ? nullptr : found->get();
}

std::shared_ptr<const robotlink::RobotDescription> SimulatedRun::description(const std::string& name) const {
  const RobotHost* robot = find(name);
  return robot != nullptr ? robot->robot().description : nullptr;
}

}  // namespace app
