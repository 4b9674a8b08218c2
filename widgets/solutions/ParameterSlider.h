// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPersistentModelIndex>
#include <QWidget>

class QAbstractItemModel;
class QLabel;
class QSlider;

namespace widgets {

/// A slider for one number of a ParameterModel, between its limits; where it has none, around its values. The
/// number is set when the slider is released, so that one drag is one step of undo. Hidden for what is no
/// number. GUI thread.
class ParameterSlider final : public QWidget {
  Q_OBJECT
 public:
  explicit ParameterSlider(QWidget* parent = nullptr);
  /// Shows the number of a row; the model must outlive it.
  void show(const QModelIndex& index);

 private:
  /// Moves the handle to the number of the row, unless it is dragged.
  void follow();
  /// The number at a position of the handle.
  double numberAt(int position) const;
  void describe(int position);

  QSlider* slider_ = nullptr;
  QLabel* text_ = nullptr;
  /// The cell of the value.
  QPersistentModelIndex index_;
  QMetaObject::Connection following_;
  double low_ = 0, high_ = 1;
  bool isWhole_ = false;
};

}  // namespace widgets
