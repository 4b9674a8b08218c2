// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <optional>
#include <vector>

#include "colortool/samples/Samples.h"

#include "widgets/RowModel.h"

namespace widgets {

/// The displayed properties of one class.
struct ColorClassRow {
  QString name;
  /// Invalid for the background.
  QColor color;
  int strokes = 0;
  /// Pixels that the strokes of the class touched.
  qint64 pixels = 0;
  /// Share of its strokes' pixels that the other strokes' table finds, 0 to 1; unset if it is unknown.
  std::optional<double> recall;

  bool operator==(const ColorClassRow&) const = default;
};

/// The color classes of a set of samples as a table. The row is the class number, so the background (no
/// class) is row 0. Names can be edited; an edit is a signal to the owner, who changes the samples. GUI
/// thread.
class ColorClassModel final : public RowModel<ColorClassRow> {
  Q_OBJECT
 public:
  /// Name with its color, key that selects the class (0 to 9), number of strokes and of their pixels, and
  /// recall in cross-validation.
  enum Column { kName, kKey, kStrokes, kPixels, kRecall, kColumns };
  /// The recall in the column kRecall, 0 to 1; invalid if it is unknown.
  static constexpr int kShareRole = Qt::UserRole + 1;

  explicit ColorClassModel(QObject* parent = nullptr);
  /// Replaces names, colors and counts. Recalls are kept if the number of classes is the same.
  void setSamples(const colortool::Samples& samples);
  /// Indexed by class number; classes past the end have none.
  void setRecalls(const std::vector<std::optional<double>>& recalls);

  QVariant data(const QModelIndex& index, int role) const override;
  /// Emits renameWanted() if the name differs; the model itself is not changed.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// The user edited the name of a class.
  void renameWanted(int colorClass, const QString& name);

 private:
  /// Resets the model only if the number of classes changed.
  void setRows(std::vector<ColorClassRow> rows);
  /// `number` is the class number, that is, the row.
  QVariant text(const ColorClassRow& row, int column, int number) const;
  QVariant toolTip(const QModelIndex& index) const;
};

/// An icon that looks the same in selected rows; Qt tints icons there otherwise.
QIcon untinted(const QPixmap& pixmap);
/// A small square in the color of a class; an invalid color (the background) gives a crossed-out one.
QIcon swatch(const QColor& color);

}  // namespace widgets
