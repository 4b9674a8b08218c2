// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/color/ColorFrameFinder.h"

class QAction;
class QLabel;
class QMenu;
class QProgressBar;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace widgets {

class EmptyHint;

/// The frames of a log, or of what a robot sent lately, in which the colour table does most that is
/// suspicious, worst first: where the next stroke is worth most. A click or Enter shows a frame.
class ColorFramesView final : public View {
  Q_OBJECT
 public:
  explicit ColorFramesView(ViewContext& context, QWidget* parent = nullptr);
  ~ColorFramesView() override;

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createViews();
  QWidget* createToolRow();
  QWidget* createFooter();
  void connectSignals();

  void search();
  void showFrame(const QModelIndex& index);
  void listClasses();
  void showState();
  QString stateText() const;

  ColorBench& bench_;
  ColorFrameFinder& finder_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QLabel *state_ = nullptr, *stale_ = nullptr, *problem_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QAction *search_ = nullptr, *cancel_ = nullptr, *live_ = nullptr;
  QToolButton *classes_ = nullptr, *liveButton_ = nullptr;
  QMenu* classMenu_ = nullptr;
};

}  // namespace widgets
