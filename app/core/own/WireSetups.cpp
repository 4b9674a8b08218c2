// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/WireSetups.h"

#include <chrono>

#include "app/core/program/HostedRobot.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/MapConversions.h"
#include "robotlink/process/Platform.h"

namespace app {

using robotcontrol::WireLayout;
using robotlink::Layout;

namespace {

using WireInputs = google::protobuf::RepeatedPtrField<WireLayout::Input>;

void add(WireInputs& to, const std::vector<Layout::Input>& inputs) {
  for (const auto& input : inputs) {
    auto& wire = *to.Add();
    wire.set_package(input.package);
    wire.set_pace_only(input.paceOnly);
  }
}

std::vector<Layout::Input> inputsIn(const WireInputs& from) {
  std::vector<Layout::Input> inputs;
  for (const auto& wire : from) inputs.push_back({wire.package(), {}, wire.pace_only()});
  return inputs;
}

void assignProcess(WireLayout::Process& to, const Layout::Process& process) {
  to.set_name(process.name);
  to.set_priority(process.priority);
  to.set_period(process.period.count());
  to.set_debug(process.debug);
  for (const auto& task : process.tasks) {
    auto& wire = *to.add_tasks();
    wire.set_task(task.task);
    wire.set_solution(task.solution);
    wire.set_own_solution(task.ownSolution);
  }
  add(*to.mutable_blocking(), process.blocking);
  add(*to.mutable_blocking_outputs(), process.blockingOutputs);
}

Layout::Process processIn(const WireLayout::Process& wire) {
  Layout::Process process;
  process.name = wire.name();
  process.priority = wire.priority();
  process.period = robotlink::Duration(wire.period());
  process.debug = wire.debug();
  for (const auto& task : wire.tasks())
    process.tasks.push_back({task.task(), task.solution(), {}, task.own_solution()});
  process.blocking = inputsIn(wire.blocking());
  process.blockingOutputs = inputsIn(wire.blocking_outputs());
  return process;
}

void assignLayout(WireLayout& to, const Layout& layout) {
  to.set_name(layout.name);
  to.set_help(layout.help);
  to.set_file(layout.file);
  for (const auto& process : layout.processes) assignProcess(*to.add_processes(), process);
  for (const auto& absence : layout.absent) {
    auto& wire = *to.add_absent();
    wire.set_process(absence.process);
    wire.set_task(absence.task);
    wire.set_reason(absence.reason);
  }
  to.mutable_withheld()->Assign(layout.withheld.begin(), layout.withheld.end());
}

/// For a robot that no files describe.
void assignTexts(robotcontrol::WireSetup& setup, const HostedProgram::Parts& parts,
                 const OwnProgramOptions& options) {
  assignLayout(*setup.mutable_layout(), parts.layout);
  *setup.mutable_texts()->mutable_description() = options.texts->description();
  *setup.mutable_texts()->mutable_field() = options.texts->field();
  if (parts.robot.map) robotlink::assign(*setup.mutable_map(), *parts.robot.map);
  setup.mutable_order()->Assign(options.order.begin(), options.order.end());
}

}  // namespace

robotcontrol::WireSetup wireSetup(const HostedProgram::Parts& parts, const OwnProgramOptions& options) {
  const HostedRobot& robot = parts.robot;
  robotcontrol::WireSetup setup;
  setup.set_robot(robot.name);
  setup.set_team(robot.team);
  setup.set_kind(robot.description->name);
  setup.set_field_file(robot.fieldFile.string());
  setup.set_map_file(robot.mapFile.string());
  setup.set_layout_file(parts.file.string());
  for (const auto& process : parts.layout.processes) {
    for (const auto& task : process.tasks) {
      if (task.ownSolution.empty()) continue;
      auto& choice = *setup.add_solutions();
      choice.set_task(task.task);
      choice.set_solution(task.solution);
    }
  }
  for (const auto& values : parts.parameters.recorded) *setup.add_parameters() = values;
  if (options.texts) assignTexts(setup, parts, options);
  setup.set_time(parts.platform.clock().now().time_since_epoch().count());
  setup.set_memory_limit(options.memoryLimit);
  setup.set_threads(options.threads);
  setup.set_real_time(options.inRealTime);
  setup.set_patience(std::chrono::duration<double>(options.patience).count());
  return setup;
}

Layout layoutIn(const WireLayout& wire) {
  Layout layout;
  layout.name = wire.name();
  layout.help = wire.help();
  layout.file = wire.file();
  for (const auto& process : wire.processes()) layout.processes.push_back(processIn(process));
  for (const auto& absence : wire.absent())
    layout.absent.push_back({absence.process(), absence.task(), absence.reason()});
  layout.withheld.insert(wire.withheld().begin(), wire.withheld().end());
  return layout;
}

}  // namespace app
