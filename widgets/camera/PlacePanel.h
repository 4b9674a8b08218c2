// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "robotlink/calibration/LensModel.h"

class QAction;
class QComboBox;
class QLabel;
class QTableView;

namespace widgets {

class MarkModel;

/// The controls for the calibration of a camera's place: by what, the marks of the field, and the result.
/// Object names begin with "place". GUI thread.
class PlacePanel final : public QWidget {
  Q_OBJECT
 public:
  /// The data from which the place is computed.
  enum class By { kMarks, kBoard };

  /// `marks` must outlive the panel.
  explicit PlacePanel(MarkModel& marks, QWidget* parent = nullptr);

  By by() const;
  QComboBox* choice() const { return by_; }
  /// P: computes the place from the board. Delete: forgets the selected mark. Then all of them; and the
  /// result becomes parameters.
  QAction *take = nullptr, *remove = nullptr, *clear = nullptr, *use = nullptr;
  /// The row that is selected; -1: none is.
  int selected() const;
  void select(int row);
  /// Shows a result; none: `why` there is none.
  void show(const std::optional<robotlink::PlaceFit>& fit, const QString& why);
  const std::optional<robotlink::PlaceFit>& fit() const { return fit_; }
  QLabel& outcome() const { return *outcome_; }

 private:
  void showChoice();

  QComboBox* by_ = nullptr;
  QTableView* table_ = nullptr;
  QLabel *result_ = nullptr, *outcome_ = nullptr;
  std::optional<robotlink::PlaceFit> fit_;
};

}  // namespace widgets
