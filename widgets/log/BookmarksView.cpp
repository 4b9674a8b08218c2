// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/BookmarksView.h"

#include <QAction>
#include <QBoxLayout>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>

#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"

namespace widgets {
namespace {

const ViewRegistration kBookmarksViewRegistration{
    {"bookmarks", QT_TRANSLATE_NOOP("View", "Bookmarks"),
     QT_TRANSLATE_NOOP("View",
                       "Lists the bookmarks of the open logs; lets you jump to them, edit and remove them."),
     "bookmark", false, create<BookmarksView>}};

}  // namespace

BookmarksView::BookmarksView(ViewContext& context, QWidget* parent)
    : View(context, parent), logs_(openLogs(context)), filtered_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("bookmarksView"));
  createActions();
  createViews();
  connectSignals();
  tick();
}

void BookmarksView::createActions() {
  add_ = makeAction(this, "bookmark", {"bookmarkAdd", tr("Bookmark"), tr("Adds a bookmark at this moment")});
  remove_ = makeAction(this, "remove",
                       {"bookmarkRemove", tr("Remove"), tr("Removes the chosen bookmark"), Qt::Key_Delete});
  undo_ = makeAction(
      this, "undo",
      {"bookmarkUndo", tr("Undo"), tr("Undoes the last change of the bookmarks"), QKeySequence::Undo});
  redo_ = makeAction(this, "redo",
                     {"bookmarkRedo", tr("Redo"), tr("Redoes what was undone"), QKeySequence::Redo});
}

void BookmarksView::createViews() {
  auto* search = makeFilterField(
      this, {"bookmarksSearch", tr("Search bookmarks"), tr("Shows only bookmarks whose text contains this")},
      *filtered_, model_);
  filtered_->setFilterKeyColumn(BookmarkModel::kText);
  filtered_->setSortRole(BookmarkModel::kSortRole);
  table_ =
      makeTable(this, {"bookmarksTable", tr("Bookmarks"), tr("Enter jumps to a bookmark, F2 edits its text")},
                filtered_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(BookmarkModel::kTime, Qt::AscendingOrder);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  table_->setFrameShape(QFrame::NoFrame);
  new ColumnFit(*table_, {ColumnKind::kNumber, ColumnKind::kNumber, ColumnKind::kText, ColumnKind::kName});
  hint_ = new EmptyHint(table_);

  auto* row = makeToolRow(this, 0);
  row->setSpacing(2);
  row->addWidget(search, 1);
  for (QAction* action : {add_, remove_, undo_, redo_}) row->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 0}, 4);
  layout->addWidget(row->parentWidget());
  layout->addWidget(table_, 1);
}

const BookmarkRow* BookmarksView::chosen() const {
  const QModelIndex index = table_->currentIndex();
  return index.isValid() ? &model_.row(filtered_->mapToSource(index).row()) : nullptr;
}

void BookmarksView::connectSignals() {
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    const auto& row = model_.row(filtered_->mapToSource(index).row());
    logs_.replay().jumpTo(row.bookmark.from + row.offset);
  });
  connect(&model_, &BookmarkModel::changeWanted, this,
          [this](const std::string& path, const logplayer::Bookmark& bookmark) {
            if (auto* log = logs_.find(path)) logs_.changeBookmark(*log, bookmark);
          });
  connect(add_, &QAction::triggered, this, [this] { logs_.addBookmarkHere(); });
  connect(remove_, &QAction::triggered, this, [this] {
    const auto* row = chosen();
    auto* log = row != nullptr ? logs_.find(row->log) : nullptr;
    if (log != nullptr) logs_.removeBookmark(*log, row->bookmark.id);
  });
  connect(undo_, &QAction::triggered, &logs_.undoStack(), &QUndoStack::undo);
  connect(redo_, &QAction::triggered, &logs_.undoStack(), &QUndoStack::redo);
}

void BookmarksView::tick() {
  std::vector<BookmarkRow> rows;
  bool there = false;
  for (const auto& log : logs_.logs()) {
    if (!log->bookmarks) continue;
    there = true;
    for (const auto& bookmark : log->bookmarks->all()) rows.push_back({log->path, log->offset, bookmark});
  }
  // Changes from elsewhere must not disturb the editing of a text.
  if (table_->indexWidget(table_->currentIndex()) == nullptr)
    model_.setRows(std::move(rows), session().timeline().origin());
  table_->setColumnHidden(BookmarkModel::kLog, logs_.logs().size() < 2);
  add_->setEnabled(there);
  remove_->setEnabled(table_->currentIndex().isValid());
  undo_->setEnabled(logs_.undoStack().canUndo());
  redo_->setEnabled(logs_.undoStack().canRedo());
  hint_->setHint(logs_.logs().empty() ? tr("No log is open.")
                 : model_.rowCount() > 0
                     ? QString()
                     : tr("There are no bookmarks. Press Ctrl+B to mark the moment that is shown."));
}

}  // namespace widgets
