// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QListView;
class QSortFilterProxyModel;

namespace widgets {

class DrawingsModel;

/// The list beside a picture in which the user chooses drawings by name, searches for them and puts them in
/// order. Lower in the list is on top in the picture. Object names: drawingsSearch, drawingsList, drawingsUp,
/// drawingsDown, drawingsAll, drawingsNone, drawingsOff.
class DrawingsPanel final : public QWidget {
  Q_OBJECT
 public:
  /// `model` must outlive it.
  explicit DrawingsPanel(DrawingsModel& model, QWidget* parent = nullptr);

 private:
  void createViews();
  QWidget* createButtons();
  void moveCurrent(int by);

  DrawingsModel& model_;
  QSortFilterProxyModel* filtered_ = nullptr;
  QListView* list_ = nullptr;
};

}  // namespace widgets
