// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/behavior/BehaviorModel.h"

#include <QCoreApplication>
#include <algorithm>

#include "robotcontrol/Motion.pb.h"

namespace widgets {
namespace {

struct BehaviorTexts {
  Q_DECLARE_TR_FUNCTIONS(BehaviorModel)
};

}  // namespace

int BehaviorModel::findOption(const QString& name) const {
  const auto found = std::ranges::find(options_, name, &Option::name);
  return found == options_.end() ? -1 : static_cast<int>(found - options_.begin());
}

int BehaviorModel::findState(const Option& option, const QString& name) {
  const auto found = std::ranges::find(option.states, name, &State::name);
  return found == option.states.end() ? -1 : static_cast<int>(found - option.states.begin());
}

int BehaviorModel::optionNamed(const QString& name) {
  const int known = findOption(name);
  if (known >= 0) return known;
  options_.push_back({name, {}, {}, {}});
  changed_ = true;
  return static_cast<int>(options_.size()) - 1;
}

int BehaviorModel::stateNamed(int option, const QString& name) {
  Option& in = options_[static_cast<std::size_t>(option)];
  const int known = findState(in, name);
  if (known >= 0) return known;
  in.states.push_back({name, {}, {}});
  changed_ = true;
  return static_cast<int>(in.states.size()) - 1;
}

bool BehaviorModel::setGraph(const robotcontrol::BehaviorGraph* graph) {
  if (graph == nullptr && options_.empty()) return false;
  options_.clear();
  active_.clear();
  hasGraph_ = graph != nullptr;
  solution_ = graph == nullptr ? QString() : QString::fromStdString(graph->solution());
  if (graph == nullptr) return true;
  for (const auto& option : graph->options())
    options_.push_back(
        {QString::fromStdString(option.name()), QString::fromStdString(option.help()), {}, {}});
  for (int i = 0; i < graph->options_size(); ++i) {
    const auto& from = graph->options(i);
    Option& to = options_[static_cast<std::size_t>(i)];
    for (const auto& state : from.states()) {
      to.states.push_back({QString::fromStdString(state.name()), QString::fromStdString(state.help()), {}});
      for (const std::string& activated : state.options()) {
        const int index = findOption(QString::fromStdString(activated));
        if (index >= 0) to.states.back().options.push_back(index);
      }
    }
    for (const auto& transition : from.transitions()) {
      const int target = findState(to, QString::fromStdString(transition.to())),
                source = findState(to, QString::fromStdString(transition.from()));
      // Only one without a state to begin with leads from all others.
      if (target < 0 || (source < 0 && !transition.from().empty())) continue;
      to.transitions.push_back({source, target, QString::fromStdString(transition.reason())});
    }
  }
  return true;
}

bool BehaviorModel::setState(const robotcontrol::BehaviorState* state) {
  changed_ = false;
  active_.clear();
  if (state == nullptr) return false;
  const QString solution = QString::fromStdString(state->solution());
  if (solution != solution_) {
    // The graph of another behavior may arrive later.
    changed_ = !options_.empty();
    options_.clear();
    hasGraph_ = false;
    solution_ = solution;
  }
  const auto add = [&](const QString& option, const QString& name, const QString& reason, double seconds,
                       bool forced) {
    const int index = optionNamed(option);
    active_.push_back({index, stateNamed(index, name), reason, seconds, forced});
  };
  for (const auto& active : state->active())
    add(QString::fromStdString(active.option()), QString::fromStdString(active.state()),
        QString::fromStdString(active.reason()), active.seconds(), active.forced());
  if (state->active().empty())
    add(solution, QString::fromStdString(state->state()), QString::fromStdString(state->reason()),
        state->seconds(), false);
  return changed_;
}

const BehaviorModel::Active* BehaviorModel::activeIn(int option) const {
  const auto found = std::ranges::find(active_, option, &Active::option);
  return found == active_.end() ? nullptr : &*found;
}

bool BehaviorModel::search(int option, const Place& place, std::vector<Place>& path) const {
  // A path that is longer than there are options goes in a circle.
  if (path.size() >= options_.size()) return false;
  if (option == place.option) {
    path.push_back(place);
    return true;
  }
  const auto& states = options_[static_cast<std::size_t>(option)].states;
  // The active state is the first, so that as little as possible changes.
  std::vector<int> order;
  if (const Active* now = activeIn(option)) order.push_back(now->state);
  for (int i = 0; i < static_cast<int>(states.size()); ++i) order.push_back(i);
  for (const int state : order) {
    for (const int below : states[static_cast<std::size_t>(state)].options) {
      path.push_back({option, state});
      if (search(below, place, path)) return true;
      path.pop_back();
    }
  }
  return false;
}

std::vector<BehaviorModel::Place> BehaviorModel::pathTo(const Place& place) const {
  std::vector<Place> path;
  const auto count = static_cast<int>(options_.size());
  if (place.option < 0 || place.option >= count || place.state < 0 ||
      place.state >= static_cast<int>(options_[static_cast<std::size_t>(place.option)].states.size()))
    return path;
  (void)search(0, place, path);
  return path;
}

QString BehaviorModel::forcedText(const std::vector<Place>& places) const {
  QStringList pairs;
  for (const Place& place : places) {
    const Option& option = options_[static_cast<std::size_t>(place.option)];
    pairs << option.name + QLatin1Char('=') + option.states[static_cast<std::size_t>(place.state)].name;
  }
  return pairs.join(QLatin1String(", "));
}

QString BehaviorModel::description() const {
  QStringList lines;
  for (const Active& active : active_) {
    const Option& option = options_[static_cast<std::size_t>(active.option)];
    const QString state = option.states[static_cast<std::size_t>(active.state)].name;
    QString line =
        BehaviorTexts::tr("%1: %2 for %3 s").arg(option.name, state).arg(active.seconds, 0, 'f', 1);
    if (active.forced) {
      line = BehaviorTexts::tr("%1, forced").arg(line);
    } else if (!active.reason.isEmpty()) {
      line = BehaviorTexts::tr("%1, because %2").arg(line, active.reason);
    }
    lines << line;
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace widgets
