// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/UnfoldedRows.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTreeView>

#include "widgets/data/DataModel.h"

namespace widgets {
namespace {

constexpr int kMaxUnfolded = 300;     // rows that a search unfolds
constexpr int kMaxRemembered = 1000;  // rows in a saved state

QJsonArray toJson(const std::set<QString>& texts) {
  QJsonArray array;
  for (const QString& text : texts) {
    if (array.size() < kMaxRemembered) array.append(text);
  }
  return array;
}

std::set<QString> textsOf(const QJsonValue& array) {
  std::set<QString> texts;
  for (const QJsonValue& text : array.toArray()) {
    if (text.isString() && texts.size() < kMaxRemembered) texts.insert(text.toString());
  }
  return texts;
}

}  // namespace

UnfoldedRows::UnfoldedRows(QTreeView& tree, DataModel& model) : QObject(&tree), tree_(tree), model_(model) {
  connect(&tree, &QTreeView::expanded, this, [this](const QModelIndex& index) { noteChange(index, true); });
  connect(&tree, &QTreeView::collapsed, this, [this](const QModelIndex& index) { noteChange(index, false); });
  connect(&model, &DataModel::rowsInserted, this, &UnfoldedRows::unfold);
}

void UnfoldedRows::noteChange(const QModelIndex& index, bool isUnfolded) {
  if (!model_.isFiltered()) {
    const bool isRobot = !index.parent().isValid();
    std::set<QString>& noted = isRobot ? foldedRobots_ : unfolded_;
    const QString row = index.data(DataModel::kRowRole).toString();
    if (isUnfolded != isRobot) {
      noted.insert(row);
    } else {
      noted.erase(row);
    }
  }
  model_.setFollowed(index, isUnfolded);
}

void UnfoldedRows::unfold(const QModelIndex& parent, int first, int last) {
  if (!parent.isValid()) {
    for (int row = first; row <= last; ++row) {
      const QModelIndex robot = model_.index(row, 0);
      if (!foldedRobots_.contains(robot.data(DataModel::kRowRole).toString())) tree_.expand(robot);
    }
    return;
  }
  if (unfolded_.empty() || model_.isFiltered()) return;
  for (int row = first; row <= last; ++row) {
    const QModelIndex index = model_.index(row, 0, parent);
    if (model_.hasChildren(index) && unfolded_.contains(index.data(DataModel::kRowRole).toString()))
      tree_.expand(index);
  }
}

void UnfoldedRows::unfoldFound() {
  int budget = kMaxUnfolded;
  unfoldFound({}, budget);
}

void UnfoldedRows::unfoldFound(const QModelIndex& parent, int& budget) {
  for (int row = 0; row < model_.rowCount(parent) && budget > 0; ++row) {
    const QModelIndex index = model_.index(row, 0, parent);
    if (index.data(DataModel::kFoundRole).toBool()) continue;
    --budget;
    tree_.expand(index);
    unfoldFound(index, budget);
  }
}

QJsonValue UnfoldedRows::save() const {
  return QJsonObject{{QStringLiteral("unfolded"), toJson(unfolded_)},
                     {QStringLiteral("foldedRobots"), toJson(foldedRobots_)}};
}

void UnfoldedRows::restore(const QJsonValue& state) {
  unfolded_ = textsOf(state.toObject().value(QStringLiteral("unfolded")));
  foldedRobots_ = textsOf(state.toObject().value(QStringLiteral("foldedRobots")));
  for (int row = 0; row < model_.rowCount(); ++row) {
    const QModelIndex robot = model_.index(row, 0);
    tree_.setExpanded(robot, !foldedRobots_.contains(robot.data(DataModel::kRowRole).toString()));
    unfold(robot, 0, model_.rowCount(robot) - 1);
  }
}

}  // namespace widgets
