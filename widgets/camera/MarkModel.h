// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QPointF>
#include <optional>
#include <string>
#include <vector>

#include "widgets/RowModel.h"
#include "widgets/camera/FieldMarks.h"

namespace widgets {

/// A mark of the field, with where it was clicked in the image.
struct PickedMark {
  FieldMark mark;
  /// Pixels; unset: not clicked.
  std::optional<QPointF> pixel = {};
  /// The error of its position in the computed camera, pixels.
  std::optional<double> error = {};
};

/// The marks of the field for the calibration of a camera: a row for each. GUI thread.
class MarkModel final : public RowModel<PickedMark> {
  Q_OBJECT
 public:
  enum Column { kKind, kPlace, kPixel, kError };

  explicit MarkModel(QObject* parent = nullptr);
  /// Replaces the marks; what was clicked stays for those with the same names.
  void setMarks(std::vector<FieldMark> marks);
  void pick(int row, const std::optional<QPointF>& pixel);
  /// Forgets what was clicked.
  void clear();
  /// The errors of the marks that were clicked, in their order; of another number: none is known.
  void setErrors(const std::vector<double>& errors);
  const std::vector<PickedMark>& marks() const { return rows_; }
  /// The next row without a pixel after `row`, around the end; -1: all have one.
  int nextFree(int row) const;

  /// The positions that were clicked, as "x y" by the rows' names.
  QJsonObject save() const;
  void restore(const QJsonObject& state);

  QVariant data(const QModelIndex& index, int role) const override;

 private:
  /// The positions clicked for marks that are not known yet.
  QJsonObject saved_;
};

}  // namespace widgets
