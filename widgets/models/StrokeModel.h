// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <unordered_map>
#include <vector>

#include "colortool/Samples.h"

namespace widgets {

/// The strokes of samples as a table, in their order. "Must not be", weight and lighting can be edited. GUI
/// thread.
class StrokeModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kClass, kMustNotBe, kWeight, kRight, kTool, kPixels, kImage, kCamera, kLighting, kColumns };
  static constexpr int kSortRole = Qt::UserRole + 1;
  /// Of kRight: 0 to 1 for a bar; without it nothing is known.
  static constexpr int kShareRole = Qt::UserRole + 2;

  using QAbstractTableModel::QAbstractTableModel;
  void setSamples(const colortool::Samples& samples);
  /// By the strokes' ids, shares of their pixels that a table of the others finds right.
  void setRight(std::unordered_map<std::uint64_t, double> right);
  const colortool::Stroke& stroke(int row) const { return *samples_.strokes[static_cast<std::size_t>(row)]; }
  const colortool::SampleImage* image(int row) const { return samples_.image(stroke(row).image); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// Asks for the change; the rows change when the samples do.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  void mustNotBeWanted(std::uint64_t stroke, bool mustNotBe);
  void weightWanted(std::uint64_t stroke, double weight);
  void lightingWanted(std::uint64_t stroke, const QString& lighting);

 private:
  QVariant text(const colortool::Stroke& stroke, int column) const;
  QVariant sortKey(const colortool::Stroke& stroke, int column) const;
  QVariant toolTip(const colortool::Stroke& stroke, int column) const;
  std::optional<double> right(const colortool::Stroke& stroke) const;
  QString className(const colortool::Stroke& stroke) const;

  colortool::Samples samples_;
  std::unordered_map<std::uint64_t, double> right_;
};

}  // namespace widgets
