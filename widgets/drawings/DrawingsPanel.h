// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QListView;
class QSortFilterProxyModel;

namespace widgets {

class DrawingsModel;

/// The list next to a picture in which the user selects drawings by name, searches for them and orders them.
/// Lower ones in the list are painted on top. The panel edits the DrawingsModel directly; the view listens
/// to the model's shownChanged(). Object names: drawingsSearch, drawingsList, drawingsUp, drawingsDown,
/// drawingsAll, drawingsNone, drawingsOff. GUI thread.
class DrawingsPanel final : public QWidget {
  Q_OBJECT
 public:
  /// `model` must outlive the panel.
  explicit DrawingsPanel(DrawingsModel& model, QWidget* parent = nullptr);

 private:
  void createViews();
  /// The row of buttons below the list.
  QWidget* createButtons();
  /// Moves the current drawing past its neighbor in the filtered list; `by` is -1 (up) or 1 (down).
  void moveCurrent(int by);

  DrawingsModel& model_;
  /// The model filtered by the search field.
  QSortFilterProxyModel* filtered_ = nullptr;
  QListView* list_ = nullptr;
};

}  // namespace widgets
