// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramSetups.h"

#include <algorithm>
#include <map>

#include "app/core/program/HostedProgram.h"
#include "app/core/program/HostedRobot.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/process/Platform.h"

namespace app {

using robotcontrol::ProgramSetup;

namespace {

/// Maps task to solution.
using Choices = std::map<std::string, std::string>;

/// "layouts/compact.yaml" if it is below the resources, else its whole path.
std::string layoutNameOf(const std::filesystem::path& file) {
  const auto relative = file.lexically_relative(robotlink::resourceDirectory());
  const bool shipped = !relative.empty() && *relative.begin() != "..";
  return (shipped ? relative : file).generic_string();
}

/// Fills in name and text of a file; an empty path leaves both empty.
void fill(ProgramSetup::File& to, const std::filesystem::path& file) {
  if (file.empty()) return;
  to.set_name(layoutNameOf(file));
  if (auto text = robotlink::readFile(file)) to.set_text(std::move(*text));
}

Choices choicesIn(const robotlink::Layout& layout) {
  Choices choices;
  for (const auto& process : layout.processes) {
    for (const auto& task : process.tasks) choices[task.task] = task.solution;
  }
  return choices;
}

Choices choicesIn(const ProgramSetup& setup) {
  Choices choices;
  for (const auto& choice : setup.solutions()) choices[choice.task()] = choice.solution();
  return choices;
}

void assignChoices(ProgramSetup& setup, const Choices& choices) {
  setup.clear_solutions();
  for (const auto& [task, solution] : choices) {
    auto& choice = *setup.add_solutions();
    choice.set_task(task);
    choice.set_solution(solution);
  }
}

/// The solutions in the text of the setup's layout, without those that were chosen instead.
Choices defaultsOf(const ProgramSetup& setup) {
  const auto layout = robotlink::parseLayout(setup.layout().text(), setup.layout().name());
  return layout ? choicesIn(*layout) : Choices{};
}

/// Adds the packages that a process offers to the program, except those for debugging.
void addOffered(ProgramSetup& setup, const robotlink::Process& process) {
  for (const robotlink::AnySender* sender : process.senders()) {
    if (!sender->package().starts_with("debug/")) setup.add_offered(sender->package());
  }
}

/// Keeps in the setup only the solutions that differ from the layout's.
bool followSolutions(ProgramSetup& setup, const robotcontrol::SolutionTable& table) {
  const Choices before = choicesIn(setup);
  const Choices defaults = defaultsOf(setup);
  Choices after = before;
  for (const auto& task : table.tasks()) {
    const auto own = defaults.find(task.name());
    if (own != defaults.end() && own->second == task.active()) {
      after.erase(task.name());
    } else {
      after[task.name()] = task.active();
    }
  }
  if (after == before) return false;
  assignChoices(setup, after);
  return true;
}

/// The file that they are from means nothing where the log is read.
void addParameters(ProgramSetup& setup, robotcontrol::ParameterValues values) {
  values.clear_file();
  *setup.add_parameters() = std::move(values);
}

/// Applies reported parameters to a setup; those of a solution that it lacks are added. Returns whether it
/// changed.
bool followParameters(ProgramSetup& setup, const robotcontrol::ParameterValues& reported) {
  for (auto& values : *setup.mutable_parameters()) {
    if (values.task() != reported.task() || values.solution() != reported.solution()) continue;
    if (values.value().data() == reported.value().data()) return false;
    *values.mutable_value() = reported.value();
    return true;
  }
  addParameters(setup, reported);
  return true;
}

}  // namespace

tl::expected<robotlink::Layout, robotlink::Errors> readLayoutWith(
    const std::filesystem::path& file, const std::map<std::string, std::string>& solutions) {
  auto layout = robotlink::readLayout(file);
  if (!layout) return layout;
  for (auto& process : layout->processes) {
    for (auto& task : process.tasks) {
      const auto chosen = solutions.find(task.task);
      if (chosen != solutions.end()) task.choose(chosen->second);
    }
  }
  return layout;
}

ProgramSetup programSetup(const HostedRobot& robot, const HostedProgram& program,
                          const robotlink::Platform& platform, const ProgramFiles& files) {
  ProgramSetup setup;
  setup.set_robot(robot.name);
  setup.set_team(robot.team);
  fill(*setup.mutable_layout(), files.layout);
  fill(*setup.mutable_description(), files.description);
  fill(*setup.mutable_field(), files.field);
  Choices chosen = choicesIn(program.layout());
  for (const auto& [task, solution] : defaultsOf(setup)) {
    if (const auto found = chosen.find(task); found != chosen.end() && found->second == solution)
      chosen.erase(found);
  }
  assignChoices(setup, chosen);
  for (auto& values : program.parameters()) addParameters(setup, std::move(values));
  setup.set_executor(files.executor);
  addOffered(setup, platform);
  addOffered(setup, program.debugProcess());
  return setup;
}

bool follow(ProgramSetup& setup, const robotlink::SharedDebugMessage& message) {
  if (const auto* parameters = message.as<robotcontrol::ParameterValues>())
    return followParameters(setup, *parameters);
  const auto* solutions = message.as<robotcontrol::SolutionTable>();
  return solutions != nullptr && followSolutions(setup, *solutions);
}

}  // namespace app
