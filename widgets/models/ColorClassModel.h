// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QColor>
#include <optional>
#include <vector>

#include "colortool/Samples.h"

namespace widgets {

/// The classes of samples as a table; the row is the class's number, so that background comes first. Names
/// can be edited. GUI thread.
class ColorClassModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kName, kKey, kStrokes, kPixels, kRecall, kColumns };
  /// Of kRecall: 0 to 1 for a bar; without it nothing is known.
  static constexpr int kShareRole = Qt::UserRole + 1;

  struct Row {
    QString name;
    QColor color;  ///< invalid: background
    int strokes = 0;
    qint64 pixels = 0;
    std::optional<double> recall;
    bool operator==(const Row&) const = default;
  };

  using QAbstractTableModel::QAbstractTableModel;
  void setSamples(const colortool::Samples& samples);
  /// By class; those past the end are not known.
  void setRecalls(const std::vector<std::optional<double>>& recalls);
  const Row& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// Asks for the other name; the rows change when the samples do.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  void renameWanted(int colorClass, const QString& name);

 private:
  void setRows(std::vector<Row> rows);
  QVariant text(const Row& row, int column, int number) const;
  QVariant toolTip(const QModelIndex& index) const;

  std::vector<Row> rows_;
};

/// An icon whose colours stay what they are in selected rows, too.
QIcon untinted(const QPixmap& pixmap);
/// A class's colour as a small square; for the background a crossed one.
QIcon swatch(const QColor& color);

}  // namespace widgets
