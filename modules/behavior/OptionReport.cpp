// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/OptionReport.h"

#include "BehaviorParameters.pb.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

namespace {

constexpr robotlink::Duration kGraphPeriod = std::chrono::seconds(1);

void addTransitions(robotcontrol::BehaviorGraph::Option& option, const std::string& from,
                    const std::vector<OptionMachine::Transition>& transitions) {
  for (const OptionMachine::Transition& transition : transitions) {
    auto& added = *option.add_transitions();
    added.set_from(from);
    added.set_to(transition.to);
    added.set_reason(transition.reason);
  }
}

}  // namespace

OptionReport::OptionReport(robotlink::SolutionContext& context, std::string solution)
    : debug_(context.debug()),
      clock_(context.clock()),
      state_(context.output(robotlink::kBehaviorState)),
      graph_(context.output(robotlink::kBehaviorGraph)),
      solution_(std::move(solution)) {}

void OptionReport::send(const OptionMachine& machine) {
  const robotlink::Instant now = clock_.now();
  const double time = robotlink::seconds(now);
  auto report = std::make_shared<robotcontrol::BehaviorState>();
  robotlink::assign(*report->mutable_timestamp(), now);
  report->set_solution(solution_);
  for (const OptionMachine::Active& active : machine.active()) {
    auto& added = *report->add_active();
    added.set_option(active.option->name());
    added.set_state(active.state->name());
    added.set_reason(active.reason);
    robotlink::assign(*added.mutable_since(), robotlink::Instant(robotlink::fromSeconds(active.since)));
    added.set_seconds(time - active.since);
    added.set_forced(active.forced);
  }
  if (!machine.active().empty()) {
    const auto& last = report->active(report->active_size() - 1);
    report->set_state(last.option() + ": " + last.state());
    report->set_reason(last.reason());
    *report->mutable_since() = last.since();
    report->set_seconds(last.seconds());
  }
  state_.send(std::move(report));
  for (const OptionMachine::Active& entered : machine.changes())
    debug_.text(robotlink::Level::kInfo, "behavior",
                entered.option->name() + ": " + entered.state->name() + ", because " + entered.reason);
  if (graphSent_ && now - *graphSent_ < kGraphPeriod) return;
  graphSent_ = now;
  sendGraph(machine);
}

void OptionReport::sendGraph(const OptionMachine& machine) {
  auto graph = std::make_shared<robotcontrol::BehaviorGraph>();
  robotlink::assign(*graph->mutable_timestamp(), clock_.now());
  graph->set_solution(solution_);
  for (const OptionMachine::Option& option : machine.options()) {
    auto& added = *graph->add_options();
    added.set_name(option.name());
    added.set_help(option.help());
    // Transitions from any state have no state of origin.
    addTransitions(added, {}, option.common());
    for (const OptionMachine::State& state : option.states()) {
      auto& described = *added.add_states();
      described.set_name(state.name());
      described.set_help(state.help());
      if (state.activated() != nullptr) described.add_options(state.activated()->name());
      addTransitions(added, state.name(), state.transitions());
    }
  }
  graph_.send(std::move(graph));
}

OptionMachine::Control optionControl(const robotcontrol::BehaviorControl& from) {
  OptionMachine::Control control;
  control.forced = OptionMachine::forcedStates(from.forced());
  control.hold = from.hold();
  control.steps = from.steps();
  return control;
}

}  // namespace modules
