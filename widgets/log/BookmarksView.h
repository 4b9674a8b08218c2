// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/log/BookmarkModel.h"
#include "widgets/log/OpenLogs.h"

class QAction;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// The bookmarks of the open logs as a list. Enter or a double click on a time jumps there, a text is edited
/// in place (F2), Delete removes. All changes can be undone.
///
/// Registered as "bookmarks". GUI thread.
class BookmarksView final : public View {
  Q_OBJECT
 public:
  explicit BookmarksView(ViewContext& context, QWidget* parent = nullptr);
  /// Lists the bookmarks if they changed.
  void tick() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// The current bookmark; null: none. Valid until the next tick.
  const BookmarkRow* chosen() const;

  /// The logs of the window, which own the bookmarks.
  OpenLogs& logs_;
  BookmarkModel model_;
  /// The bookmarks filtered by the search field.
  QSortFilterProxyModel* filtered_;
  QTableView* table_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* add_ = nullptr;
  QAction* remove_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
};

}  // namespace widgets
