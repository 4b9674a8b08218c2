// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/OptionMachine.h"

#include <algorithm>
#include <stdexcept>

#include "robotlink/base/Spelling.h"

namespace modules {

OptionMachine::State& OptionMachine::State::does(Action action) {
  action_ = std::move(action);
  return *this;
}

OptionMachine::State& OptionMachine::State::begins(Action action) {
  entry_ = std::move(action);
  return *this;
}

OptionMachine::State& OptionMachine::State::activates(Option& option) {
  option_ = &option;
  return *this;
}

OptionMachine::State& OptionMachine::State::to(std::string state, std::string reason, Condition when) {
  transitions_.push_back({std::move(state), std::move(reason), std::move(when)});
  return *this;
}

OptionMachine::State& OptionMachine::State::isDone() {
  done_ = true;
  return *this;
}

OptionMachine::State& OptionMachine::Option::state(std::string name, std::string help) {
  return states_.emplace_back(std::move(name), std::move(help));
}

OptionMachine::Option& OptionMachine::Option::always(std::string state, std::string reason, Condition when) {
  common_.push_back({std::move(state), std::move(reason), std::move(when)});
  return *this;
}

std::size_t OptionMachine::Option::find(const std::string& state) const {
  return static_cast<std::size_t>(
      std::distance(states_.begin(), std::ranges::find(states_, state, &State::name_)));
}

OptionMachine::Option& OptionMachine::option(std::string name, std::string help) {
  sealed_ = false;
  return options_.emplace_back(std::move(name), std::move(help));
}

namespace {

/// The parts between the commas of a text, and what is before and after their first "="; without spaces
/// around. Parts without it have nothing after it. A text without anything in it has no parts.
std::vector<std::pair<std::string, std::string>> forcedPairs(const std::string& text) {
  const auto trimmed = [](const std::string& word) {
    const auto first = word.find_first_not_of(' ');
    return first == std::string::npos ? "" : word.substr(first, word.find_last_not_of(' ') - first + 1);
  };
  std::vector<std::pair<std::string, std::string>> pairs;
  if (trimmed(text).empty()) return pairs;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string pair = text.substr(begin, end - begin);
    const std::size_t equal = std::min(pair.find('='), pair.size());
    pairs.emplace_back(trimmed(pair.substr(0, equal)),
                       equal < pair.size() ? trimmed(pair.substr(equal + 1)) : "");
    begin = end + 1;
  }
  return pairs;
}

template <typename Named>
std::vector<std::string> namesOf(const std::deque<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name());
  return names;
}

}  // namespace

std::map<std::string, std::string> OptionMachine::forcedStates(const std::string& text) {
  std::map<std::string, std::string> forced;
  for (auto& [option, state] : forcedPairs(text))
    if (!option.empty() && !state.empty()) forced[option] = state;
  return forced;
}

std::string OptionMachine::wrongWith(const std::string& text) const {
  for (const auto& [option, state] : forcedPairs(text)) {
    if (option.empty() && state.empty()) return "it has an empty part; write \"OPTION=STATE, OPTION=STATE\"";
    const auto known = std::ranges::find(options_, option, &Option::name_);
    if (known == options_.end())
      return "there is no option '" + option + "'" + robotlink::suggestion(option, namesOf(options_));
    if (known->find(state) == known->states_.size())
      return "the option " + option + " has no state '" + state + "'" +
             robotlink::suggestion(state, namesOf(known->states_));
  }
  return {};
}

void OptionMachine::seal(Option& option) const {
  const auto resolve = [&](Transition& transition) {
    transition.target = option.find(transition.to);
    if (transition.target == option.states_.size())
      throw std::logic_error("option '" + option.name_ + "' has no state '" + transition.to + "'");
  };
  if (option.states_.empty()) throw std::logic_error("option '" + option.name_ + "' has no states");
  for (Transition& transition : option.common_) resolve(transition);
  for (State& state : option.states_)
    for (Transition& transition : state.transitions_) resolve(transition);
}

/// A path of options that is longer than there are options contains one twice.
void OptionMachine::checkDepth(const Option& option, std::size_t depth) const {
  if (depth > options_.size())
    throw std::logic_error("option '" + option.name_ + "' activates itself, directly or not");
  for (const State& state : option.states_)
    if (state.option_ != nullptr) checkDepth(*state.option_, depth + 1);
}

void OptionMachine::seal() {
  if (options_.empty()) throw std::logic_error("a behavior without options");
  for (Option& option : options_) seal(option);
  checkDepth(options_.front(), 1);
  sealed_ = true;
}

void OptionMachine::advance(double time) {
  if (!sealed_) seal();
  time_ = time;
  ++frame_;
  active_.clear();
  if (control_.hold && held_) {
    if (control_.steps > counted_) granted_ += control_.steps - counted_;
  } else {
    granted_ = 0;
  }
  counted_ = control_.steps;
  held_ = control_.hold;
  run(options_.front());
  current_ = nullptr;
}

void OptionMachine::restart() {
  for (Option& option : options_) option.ranIn_ = 0;
}

void OptionMachine::enter(Option& option, std::size_t state, const std::string& reason) const {
  option.current_ = state;
  option.reason_ = reason;
  option.stateSince_ = time_;
  option.enteredIn_ = frame_;
}

void OptionMachine::begin(Option& option) const {
  option.optionSince_ = time_;
  enter(option, 0, "the option begins");
}

const std::string* OptionMachine::forcedState(const Option& option) const {
  const auto found = control_.forced.find(option.name_);
  if (found == control_.forced.end() || option.find(found->second) == option.states_.size()) return nullptr;
  return &found->second;
}

void OptionMachine::move(Option& option) {
  if (const std::string* forced = forcedState(option)) {
    const std::size_t state = option.find(*forced);
    if (option.current_ != state) enter(option, state, "forced");
    return;
  }
  if (held_ && granted_ == 0) return;
  const auto due = [&](const Transition& transition) {
    return transition.target != option.current_ && transition.when();
  };
  const auto& own = option.states_[option.current_].transitions_;
  auto taken = std::ranges::find_if(option.common_, due);
  if (taken == option.common_.end()) {
    const auto mine = std::ranges::find_if(own, due);
    if (mine == own.end()) return;
    enter(option, mine->target, mine->reason);
  } else {
    enter(option, taken->target, taken->reason);
  }
  if (held_) --granted_;
}

void OptionMachine::run(Option& option) {
  current_ = &option;
  if (option.ranIn_ != frame_ - 1) begin(option);
  move(option);
  option.ranIn_ = frame_;
  State& state = option.states_[option.current_];
  active_.push_back({&option, &state, option.reason_, option.stateSince_, forcedState(option) != nullptr});
  if (option.enteredIn_ == frame_ && state.entry_) state.entry_();
  if (state.action_) state.action_();
  if (state.option_ != nullptr) run(*state.option_);
}

double OptionMachine::stateTime() const {
  return current_ == nullptr ? 0 : time_ - current_->stateSince_;
}

double OptionMachine::optionTime() const {
  return current_ == nullptr ? 0 : time_ - current_->optionSince_;
}

bool OptionMachine::subDone() const {
  if (current_ == nullptr || current_->enteredIn_ == frame_) return false;
  const Option* sub = current_->states_[current_->current_].option_;
  return sub != nullptr && sub->ranIn_ == frame_ - 1 && sub->states_[sub->current_].done_;
}

std::vector<OptionMachine::Active> OptionMachine::changes() const {
  std::vector<Active> changed;
  for (const Active& active : active_)
    if (active.option->enteredIn_ == frame_) changed.push_back(active);
  return changed;
}

}  // namespace modules
