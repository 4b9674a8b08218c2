// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace modules {

/// A hierarchy of state machines. An option is a state machine; each of its states may activate another
/// option, so that the active options form a path from the root to the one that acts. The idea is XABSL's
/// (M. Lötzsch, J. Bach, H.-D. Burkhard, M. Jüngel: "Designing agent behavior with the extensible agent
/// behavior specification language XABSL", RoboCup 2003); here, options are written in C++:
///
///     OptionMachine::Option& search = machine.option("search", "Finds the ball.");
///     search.state("look about", "Stands and moves its head.")
///         .does([this] { look(); })
///         .to("turn", "the ball is not within the head's reach", [&] { return machine.stateTime() > 2; });
///
/// In each frame, from the root on, an active option takes its first transition that is due, runs the action
/// of its state, and then the option that the state activates. An option that was not active in the frame
/// before begins in its first state. Names of states are resolved by the first advance(), which throws
/// std::logic_error for unknown ones and for options that activate each other in a circle. Deterministic. Not
/// thread-safe.
class OptionMachine {
 public:
  using Condition = std::function<bool()>;
  using Action = std::function<void()>;
  class Option;

  /// The way from a state to another one of the same option.
  struct Transition {
    std::string to;
    /// The reason for taking it, in words for people: "the ball is lost".
    std::string reason;
    Condition when;
    /// Index of the state; known after the first advance().
    std::size_t target = 0;
  };

  /// A state of an option, described by a chain of calls.
  class State {
   public:
    State(std::string name, std::string help) : name_(std::move(name)), help_(std::move(help)) {}
    /// The action in each frame, before the option that the state activates runs.
    State& does(Action action);
    /// The action in the frame in which the state is entered, before that of does().
    State& begins(Action action);
    /// The option that is active while the state is.
    State& activates(Option& option);
    /// Adds a transition; those that were added first are tried first.
    State& to(std::string state, std::string reason, Condition when);
    /// Marks the state as one in which the option has reached its aim, see subDone().
    State& isDone();

    const std::string& name() const { return name_; }
    const std::string& help() const { return help_; }
    const std::vector<Transition>& transitions() const { return transitions_; }
    /// Null if the state activates none.
    const Option* activated() const { return option_; }

   private:
    friend class OptionMachine;
    std::string name_, help_;
    Action action_, entry_;
    Option* option_ = nullptr;
    bool done_ = false;
    std::vector<Transition> transitions_;
  };

  /// A state machine of the hierarchy.
  class Option {
   public:
    Option(std::string name, std::string help) : name_(std::move(name)), help_(std::move(help)) {}
    /// Adds a state; the first one is that in which the option begins. The reference stays valid.
    State& state(std::string name, std::string help);
    /// Adds a transition from all other states, tried before theirs.
    Option& always(std::string state, std::string reason, Condition when);

    const std::string& name() const { return name_; }
    const std::string& help() const { return help_; }
    const std::deque<State>& states() const { return states_; }
    const std::vector<Transition>& common() const { return common_; }

   private:
    friend class OptionMachine;
    /// The index of a state; the number of states if there is none.
    std::size_t find(const std::string& state) const;

    std::string name_, help_;
    std::deque<State> states_;
    std::vector<Transition> common_;
    std::size_t current_ = 0;
    std::string reason_;
    /// Times of entering, s.
    double stateSince_ = 0, optionSince_ = 0;
    /// Frames in which it ran last, and in which its state was entered.
    std::uint64_t ranIn_ = 0, enteredIn_ = 0;
  };

  /// The user's control of a machine for debugging: forced states, hold and step.
  struct Control {
    /// States in which options stay while they are active, by the option's name. Unknown names are ignored.
    std::map<std::string, std::string> forced = {};
    /// Whether no transition is taken, except those that `steps` grants.
    bool hold = false;
    /// Each increase grants one transition while it holds.
    std::uint32_t steps = 0;
  };

  /// Reads the states of Control::forced from a text: "playing=goalie, strike=kick"; anything else
  /// is skipped.
  static std::map<std::string, std::string> forcedStates(const std::string& text);
  /// Returns the problem with such a text for this machine, as a sentence that lists valid names; empty if it
  /// is valid.
  std::string wrongWith(const std::string& text) const;

  /// An option that is active, with its state.
  struct Active {
    const Option* option = nullptr;
    const State* state = nullptr;
    std::string reason;
    /// The time at which the state was entered, s.
    double since = 0;
    bool forced = false;
  };

  /// Adds an option; the first one is the root. The reference stays valid.
  Option& option(std::string name, std::string help);
  /// Takes effect with the next advance().
  void setControl(Control control) { control_ = std::move(control); }
  /// Runs a frame; `time` is that of any clock, s, and does not decrease.
  void advance(double time);
  /// Forgets all states, so that the root begins with the next frame.
  void restart();

  /// Time since the state was entered, s; in conditions and actions, that of their option.
  double stateTime() const;
  /// Time since the option became active, s; likewise.
  double optionTime() const;
  /// Whether the option that the state activates has reached its aim; likewise.
  bool subDone() const;

  /// The options that were active in the last frame, the root first.
  const std::vector<Active>& active() const { return active_; }
  /// The active options whose states were entered in the last frame.
  std::vector<Active> changes() const;
  const std::deque<Option>& options() const { return options_; }

 private:
  void seal();
  void seal(Option& option) const;
  void checkDepth(const Option& option, std::size_t depth) const;
  void run(Option& option);
  void begin(Option& option) const;
  /// Takes a transition, if one is due and may be taken.
  void move(Option& option);
  /// The state that a person demands; null if none.
  const std::string* forcedState(const Option& option) const;
  void enter(Option& option, std::size_t state, const std::string& reason) const;

  std::deque<Option> options_;
  std::vector<Active> active_;
  Control control_;
  bool sealed_ = false;
  double time_ = 0;
  std::uint64_t frame_ = 1;
  /// The option whose conditions and actions are called.
  const Option* current_ = nullptr;
  /// Transitions that may still be taken while it holds, and how many of `Control::steps` are counted.
  std::uint32_t granted_ = 0, counted_ = 0;
  bool held_ = false;
};

}  // namespace modules
