// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drawings/DrawingsPanel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/drawings/DrawingsModel.h"

namespace widgets {

DrawingsPanel::DrawingsPanel(DrawingsModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  setObjectName(QStringLiteral("drawingsPanel"));
  createViews();
}

void DrawingsPanel::createViews() {
  filtered_ = new QSortFilterProxyModel(this);
  auto* search = makeFilterField(
      this, {"drawingsSearch", tr("Search drawings"), tr("Shows only drawings whose name contains this")},
      *filtered_, model_);

  list_ = new QListView(this);
  describe(*list_, {"drawingsList", tr("Drawings"),
                    tr("Checked drawings are shown; those lower in the list are on top. Gray ones are off on "
                       "the robot: "
                       "check one to switch it on")});
  list_->setModel(filtered_);
  list_->setUniformItemSizes(true);
  list_->setFrameShape(QFrame::NoFrame);
  // The end of a name says what is drawn, its beginning says who draws it. Tooltips have the whole name.
  list_->setTextElideMode(Qt::ElideLeft);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* hint = new EmptyHint(list_);
  const auto update = [this, hint] {
    hint->setHint(model_.rowCount() == 0       ? tr("There is no robot that could draw anything here.")
                  : filtered_->rowCount() == 0 ? tr("No drawing has this in its name.")
                                               : QString());
  };
  connect(filtered_, &QAbstractItemModel::rowsInserted, hint, update);
  connect(filtered_, &QAbstractItemModel::rowsRemoved, hint, update);
  connect(filtered_, &QAbstractItemModel::modelReset, hint, update);
  update();

  auto* layout = makeColumn(this, {4, 0, 0, 0}, 2);
  layout->addWidget(search);
  layout->addWidget(list_, 1);
  layout->addWidget(createButtons());
}

QWidget* DrawingsPanel::createButtons() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  const auto add = [&](const char* icon, const ControlText& text, auto slot) {
    QAction* action = makeAction(list_, icon, text);
    connect(action, &QAction::triggered, this, slot);
    layout->addWidget(makeButton(row, action));
  };
  add("check-all", {"drawingsAll", tr("Show all"), tr("Shows all drawings")},
      [this] { model_.setAllShown(true); });
  add("check-none", {"drawingsNone", tr("Show none"), tr("Hides all drawings")},
      [this] { model_.setAllShown(false); });
  add("clear",
      {"drawingsOff", tr("Switch off"),
       tr("Switches the chosen drawing's debug key off: the robot no longer draws it")},
      [this] {
        const QModelIndex current = list_->currentIndex();
        if (current.isValid()) model_.switchKey(filtered_->mapToSource(current).row(), false);
      });
  layout->addStretch(1);
  add("up",
      {"drawingsUp", tr("Lower"), tr("Moves the drawing below the previous one"),
       QKeySequence(QStringLiteral("Alt+Up"))},
      [this] { moveCurrent(-1); });
  add("down",
      {"drawingsDown", tr("Raise"), tr("Moves the drawing on top of the next one"),
       QKeySequence(QStringLiteral("Alt+Down"))},
      [this] { moveCurrent(1); });
  return row;
}

void DrawingsPanel::moveCurrent(int by) {
  const QModelIndex current = list_->currentIndex();
  const QModelIndex neighbor = filtered_->index(current.row() + by, 0);
  if (!current.isValid() || !neighbor.isValid()) return;
  const int from = filtered_->mapToSource(current).row();
  model_.move(from, filtered_->mapToSource(neighbor).row() - from);
}

}  // namespace widgets
