// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <vector>

namespace robotcontrol {
class BehaviorGraph;
class BehaviorState;
}  // namespace robotcontrol

namespace widgets {

/// The options of a behavior with their states, and what is active, as a robot reports them. Of a behavior
/// that publishes no graph it knows only what is active. A plain value with an update; GUI thread.
class BehaviorModel {
 public:
  struct Transition {
    /// Index of the state; -1: all others.
    int from = -1;
    int to = 0;
    QString reason;
  };
  struct State {
    QString name, help;
    /// Indices of the options that it may activate.
    std::vector<int> options;
  };
  struct Option {
    QString name, help;
    std::vector<State> states;
    std::vector<Transition> transitions;
  };
  /// An option that is active.
  struct Active {
    int option = 0;
    int state = 0;
    QString reason;
    /// s, in that state.
    double seconds = 0;
    bool forced = false;
  };
  /// A state of an option, by their indices.
  struct Place {
    int option = -1;
    int state = -1;
    bool operator==(const Place&) const = default;
  };

  /// Null: nothing is known. True if the options or states are others than before.
  bool setGraph(const robotcontrol::BehaviorGraph* graph);
  /// The same for what is active; adds options and states that the graph lacks.
  bool setState(const robotcontrol::BehaviorState* state);

  const QString& solution() const { return solution_; }
  const std::vector<Option>& options() const { return options_; }
  const std::vector<Active>& active() const { return active_; }
  /// The active state of an option; null if it is not active.
  const Active* activeIn(int option) const;
  /// Whether the behavior has a graph, so that its states can be forced.
  bool hasGraph() const { return hasGraph_; }

  /// The states in which options must be so that a state is active, the root's first and itself last; empty
  /// if there is no way to it.
  std::vector<Place> pathTo(const Place& place) const;
  /// The parameter that forces these states: "playing=goalie, keep goal=clear".
  QString forcedText(const std::vector<Place>& places) const;
  /// The active states, one line for each option: option, state, since when, why.
  QString description() const;

 private:
  int findOption(const QString& name) const;
  static int findState(const Option& option, const QString& name);
  /// Returns the index of an option; an unknown one is added.
  int optionNamed(const QString& name);
  int stateNamed(int option, const QString& name);
  bool search(int option, const Place& place, std::vector<Place>& path) const;

  QString solution_;
  std::vector<Option> options_;
  std::vector<Active> active_;
  bool hasGraph_ = false;
  bool changed_ = false;
};

}  // namespace widgets
