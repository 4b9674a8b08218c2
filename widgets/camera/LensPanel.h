// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringListModel>
#include <QWidget>
#include <optional>

#include "robotlink/calibration/LensModel.h"
#include "widgets/camera/BoardViews.h"

class QAction;
class QLabel;
class QListView;
class QSpinBox;
class QDoubleSpinBox;

namespace widgets {

/// The controls for the calibration of a lens: the board, the views that were taken, and the result. Object
/// names begin with "lens". GUI thread.
class LensPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit LensPanel(QWidget* parent = nullptr);

  robotlink::Chessboard board() const;
  void setBoard(const robotlink::Chessboard& board);
  /// Space: takes a view. T, checkable: takes every view that adds something. Delete: removes the selected
  /// one. Then all of them; and the result becomes parameters.
  QAction *take = nullptr, *automatic = nullptr, *remove = nullptr, *clear = nullptr, *use = nullptr;
  /// The number of the selected view; -1: none is.
  int selected() const;
  /// Lists the views, with their errors if there is a fit of them.
  void show(const BoardViews& views, const std::optional<robotlink::LensFit>& fit);
  QLabel& outcome() const { return *outcome_; }

 private:
  QSpinBox *columns_ = nullptr, *rows_ = nullptr;
  QDoubleSpinBox* square_ = nullptr;
  QStringListModel listed_;
  QListView* list_ = nullptr;
  QLabel *result_ = nullptr, *outcome_ = nullptr;
};

}  // namespace widgets
