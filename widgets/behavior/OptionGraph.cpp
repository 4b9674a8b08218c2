// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/behavior/OptionGraph.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"

namespace widgets {
namespace {

struct OptionTexts {
  Q_DECLARE_TR_FUNCTIONS(OptionGraph)
};

constexpr double kLineRoom = 4;  // pixels between a line and a box next to it

/// The longest way from the root to each option.
std::vector<int> depths(const BehaviorModel& model) {
  const auto& options = model.options();
  std::vector<int> depth(options.size(), 0);
  // There are as many rounds as options, so that it ends for cycles, too.
  for (std::size_t round = 0; round < options.size(); ++round) {
    for (std::size_t i = 0; i < options.size(); ++i)
      for (const auto& state : options[i].states)
        for (const int below : state.options) {
          int& known = depth[static_cast<std::size_t>(below)];
          known = std::min(std::max(known, depth[i] + 1), static_cast<int>(options.size()));
        }
  }
  return depth;
}

}  // namespace

OptionGraph::OptionGraph(const BehaviorModel& model) {
  const auto& options = model.options();
  const std::vector<int> depth = depths(model);
  std::map<int, double> bottoms;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const auto states = static_cast<int>(options[i].states.size());
    double& y = bottoms.try_emplace(depth[i], kMargin).first->second;
    const QRectF box(kMargin + depth[i] * (kWidth + kColumnGap), y, kWidth, kHeader + states * kRow + 4);
    y += box.height() + kRowGap;
    boxes_.push_back(box);
    rows_.push_back(states);
    columns_.push_back(depth[i]);
    bounds_ |= box.adjusted(-kMargin, -kMargin, kMargin, kMargin);
  }
  findGaps();
  routeLines(model);
}

void OptionGraph::findGaps() {
  // The boxes of a column are in the order of their heights.
  std::map<int, double> tops;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    double& top = tops.try_emplace(columns_[i], 0).first->second;
    gaps_[columns_[i]].push_back({top + kLineRoom, boxes_[i].top() - kLineRoom});
    top = boxes_[i].bottom();
  }
  for (const auto& [column, top] : tops)
    gaps_[column].push_back({top + kLineRoom, std::max(top + kMargin, bounds_.bottom()) - kLineRoom});
}

double OptionGraph::passage(int column, double near) {
  const auto found = gaps_.find(column);
  if (found == gaps_.end()) return near;
  auto& gaps = found->second;
  const auto distance = [&](const Gap& gap) {
    return std::abs(near - std::clamp(near, gap.top, gap.bottom));
  };
  Gap& gap = *std::ranges::min_element(gaps, {}, distance);
  // Lines run side by side, as far as there is room; then the first place is used again.
  constexpr double kBeside = 4;
  const double room = std::max(1.0, gap.bottom - gap.top + 1);
  const double at = std::clamp(near, gap.top, gap.bottom) - gap.top + kBeside * gap.lines++;
  return gap.top + std::fmod(at, room);
}

QPainterPath OptionGraph::route(const BehaviorModel::Place& from, int to) {
  const QRectF row = stateRect(from), box = optionRect(to);
  const int begin = columns_[static_cast<std::size_t>(from.option)],
            end = columns_[static_cast<std::size_t>(to)];
  const QPointF start(row.right(), row.center().y()), target(box.left(), box.top() + 0.5 * kHeader);
  QPainterPath path(start);
  // Leaves to the right and arrives from the left; a turn needs less room than the way to another column.
  constexpr double kTurn = 20;
  const auto curveTo = [&](const QPointF& next, double leave, double arrive) {
    path.cubicTo(path.currentPosition() + QPointF(leave, 0), next - QPointF(arrive, 0), next);
  };
  const bool isBack = end <= begin;
  const int step = isBack ? -1 : 1;
  bool isFirst = true;
  for (int column = isBack ? begin : begin + 1; isBack ? column >= end : column < end; column += step) {
    const double y = passage(column, (path.currentPosition().y() + target.y()) / 2);
    const double left = leftOf(column), right = left + kWidth;
    const double way = step * 0.5 * kColumnGap;
    curveTo({isBack ? right : left, y}, isBack && isFirst ? kTurn : way, isBack && isFirst ? -kTurn : way);
    path.lineTo(isBack ? left : right, y);
    isFirst = false;
  }
  isBack ? curveTo(target, -kTurn, kTurn) : curveTo(target, 0.5 * kColumnGap, 0.5 * kColumnGap);
  return path;
}

void OptionGraph::routeLines(const BehaviorModel& model) {
  for (int option = 0; option < static_cast<int>(boxes_.size()); ++option) {
    const auto& states = model.options()[static_cast<std::size_t>(option)].states;
    for (int state = 0; state < static_cast<int>(states.size()); ++state)
      for (const int below : states[static_cast<std::size_t>(state)].options)
        lines_.push_back({{option, state}, below, route({option, state}, below)});
  }
}

QRectF OptionGraph::optionRect(int option) const {
  if (option < 0 || option >= static_cast<int>(boxes_.size())) return {};
  return boxes_[static_cast<std::size_t>(option)];
}

QRectF OptionGraph::stateRect(const BehaviorModel::Place& place) const {
  const QRectF box = optionRect(place.option);
  if (box.isEmpty() || place.state < 0 || place.state >= rows_[static_cast<std::size_t>(place.option)])
    return {};
  return {box.left(), box.top() + kHeader + place.state * kRow, box.width(), kRow};
}

BehaviorModel::Place OptionGraph::at(const QPointF& point) const {
  for (int i = 0; i < static_cast<int>(boxes_.size()); ++i) {
    if (!optionRect(i).contains(point)) continue;
    for (int state = 0; state < rows_[static_cast<std::size_t>(i)]; ++state)
      if (stateRect({i, state}).contains(point)) return {i, state};
    return {i, -1};
  }
  return {};
}

QString OptionGraph::toolTip(const BehaviorModel& model, const BehaviorModel::Place& place) {
  if (place.option < 0 || place.option >= static_cast<int>(model.options().size())) return {};
  const auto& option = model.options()[static_cast<std::size_t>(place.option)];
  if (place.state < 0)
    return QStringLiteral("<b>%1</b><br>%2").arg(option.name.toHtmlEscaped(), option.help.toHtmlEscaped());
  const auto& state = option.states[static_cast<std::size_t>(place.state)];
  QString text =
      QStringLiteral("<b>%1</b><br>%2").arg(state.name.toHtmlEscaped(), state.help.toHtmlEscaped());
  for (const auto& transition : option.transitions) {
    if (transition.to == place.state || (transition.from >= 0 && transition.from != place.state)) continue;
    text += QStringLiteral("<br>") +
            OptionTexts::tr("to %1: %2")
                .arg(option.states[static_cast<std::size_t>(transition.to)].name, transition.reason)
                .toHtmlEscaped();
  }
  return text;
}

void OptionGraph::paintActivations(QPainter& painter, const BehaviorModel& model,
                                   const QPalette& palette) const {
  const auto isActive = [&](const Line& line) {
    const auto* active = model.activeIn(line.from.option);
    return active != nullptr && active->state == line.from.state && model.activeIn(line.to) != nullptr;
  };
  // Active lines are on top.
  for (const bool active : {false, true}) {
    painter.setPen(QPen(colorOf(active ? Meaning::kGood : Meaning::kMuted, palette), active ? 2.5 : 1));
    for (const Line& line : lines_)
      if (isActive(line) == active) painter.drawPath(line.path);
  }
}

void OptionGraph::paintTransitions(QPainter& painter, const BehaviorModel& model, int option,
                                   const QPalette& palette) const {
  painter.setPen(QPen(colorOf(Meaning::kNote, palette), 1));
  for (const auto& transition : model.options()[static_cast<std::size_t>(option)].transitions) {
    if (transition.from < 0) continue;
    const QRectF from = stateRect({option, transition.from}), to = stateRect({option, transition.to});
    // Down on the left, up on the right, so that both directions are seen.
    const bool down = transition.to > transition.from;
    const double side = down ? -1 : 1, x = down ? from.left() : from.right();
    const double bulge = side * (6 + 3.0 * std::abs(transition.to - transition.from));
    const QPointF end(x, to.center().y() - (down ? 3 : -3));
    QPainterPath path(QPointF(x, from.center().y() + (down ? 3 : -3)));
    path.cubicTo(path.currentPosition() + QPointF(bulge, 0), end + QPointF(bulge, 0), end);
    painter.drawPath(path);
    painter.drawLine(end, end + QPointF(side * 5, -4));
    painter.drawLine(end, end + QPointF(side * 5, 4));
  }
}

void OptionGraph::paintOption(QPainter& painter, const BehaviorModel& model, int option,
                              const BehaviorModel::Place& selected, const QPalette& palette) const {
  const auto& described = model.options()[static_cast<std::size_t>(option)];
  const QRectF box = optionRect(option);
  const auto* active = model.activeIn(option);
  const QColor good = colorOf(Meaning::kGood, palette);
  // The palette's own color for frames does not show on a dark base.
  const QColor frame = mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.4);
  painter.setPen(QPen(active != nullptr ? good : frame, active != nullptr ? 2 : 1));
  painter.setBrush(palette.base());
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(palette.color(QPalette::Text));
  QFont bold = painter.font();
  bold.setBold(true);
  const QFont usual = painter.font();
  painter.setFont(bold);
  painter.drawText(QRectF(box.left() + 8, box.top(), box.width() - 16, kHeader), Qt::AlignVCenter,
                   described.name);
  painter.setFont(usual);
  for (int s = 0; s < static_cast<int>(described.states.size()); ++s) {
    const QRectF row = stateRect({option, s}).adjusted(3, 1, -3, -1);
    const bool isActive = active != nullptr && active->state == s;
    if (isActive)
      painter.fillRect(row, mixed(palette.color(QPalette::Base),
                                  active->forced ? colorOf(Meaning::kWarning, palette) : good, 0.35));
    if (selected == BehaviorModel::Place{option, s}) {
      painter.setPen(QPen(palette.color(QPalette::Highlight), 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(row);
    }
    painter.setPen(palette.color(QPalette::Text));
    painter.drawText(row.adjusted(6, 0, -6, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     described.states[static_cast<std::size_t>(s)].name);
    if (isActive)
      painter.drawText(row.adjusted(6, 0, -6, 0), Qt::AlignVCenter | Qt::AlignRight,
                       OptionTexts::tr("%1 s").arg(active->seconds, 0, 'f', 1));
  }
}

void OptionGraph::paint(QPainter& painter, const BehaviorModel& model, const BehaviorModel::Place& selected,
                        const QPalette& palette) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  paintActivations(painter, model, palette);
  for (int i = 0; i < static_cast<int>(boxes_.size()); ++i) {
    paintOption(painter, model, i, selected, palette);
    painter.setBrush(Qt::NoBrush);
    paintTransitions(painter, model, i, palette);
  }
}

}  // namespace widgets
