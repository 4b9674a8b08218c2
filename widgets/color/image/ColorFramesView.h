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

/// The frames of a log, or of what a robot sent lately, with the most suspicious segmentation, worst first:
/// where the next stroke is worth most. A click or Enter shows a frame. The search itself is done by the
/// window's ColorFrameFinder.
///
/// Registered as "color-frames". GUI thread.
class ColorFramesView final : public View {
  Q_OBJECT
 public:
  explicit ColorFramesView(ViewContext& context, QWidget* parent = nullptr);
  ~ColorFramesView() override;

  /// Updates the origin of the times and the state line.
  void tick() override;

 private:
  void createActions();
  void createViews();
  /// Search, cancel, the menu of classes.
  QWidget* createToolRow();
  /// State, progress, and the note that the table has changed.
  QWidget* createFooter();
  void connectSignals();

  /// Starts a search; shows why it is not possible.
  void search();
  /// Moves the timeline to the frame at `index`.
  void showFrame(const QModelIndex& index);
  /// Fills the menu of the classes that are looked at.
  void listClasses();
  /// Updates progress, notes and hint.
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
  QToolButton* liveButton_ = nullptr;
  QMenu* classMenu_ = nullptr;
};

}  // namespace widgets
