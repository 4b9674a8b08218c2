// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QObject>
#include <set>

class QModelIndex;
class QTreeView;

namespace widgets {

class DataModel;

/// Remembers which rows of the tree of all data are unfolded, by their kRowRole: rows that come back, with
/// another message or after a restart, are unfolded as they were. Robots are unfolded unless the user folds
/// them. Tells the model which rows it has to bring up to date. While a search filters the tree nothing is
/// remembered. Owned by the tree. GUI thread.
class UnfoldedRows final : public QObject {
  Q_OBJECT
 public:
  /// The tree must already show the model.
  UnfoldedRows(QTreeView& tree, DataModel& model);

  /// Unfolds the rows above found ones, up to some hundred rows.
  void unfoldFound();

  QJsonValue save() const;
  /// Unfolds what is there of what save() returned, and the rest as it comes.
  void restore(const QJsonValue& state);

 private:
  void noteChange(const QModelIndex& index, bool isUnfolded);
  /// Unfolds the children of a row that were unfolded before.
  void unfold(const QModelIndex& parent, int first, int last);
  void unfoldFound(const QModelIndex& parent, int& budget);

  QTreeView& tree_;
  DataModel& model_;
  std::set<QString> unfolded_;
  std::set<QString> foldedRobots_;
};

}  // namespace widgets
