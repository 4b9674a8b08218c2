// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "colortool/samples/Samples.h"

#include "widgets/TitledModel.h"

namespace widgets {

/// The strokes of a set of samples as a table, in the order of the samples. "Not" (must not be of the class),
/// weight and lighting can be edited; an edit is a signal to the owner, who changes the samples. GUI thread.
class StrokeModel final : public TitledModel {
  Q_OBJECT
 public:
  /// Class with thumbnail, "must not be", weight, share of pixels that the other strokes' table finds, tool,
  /// number of pixels, image, camera, lighting.
  enum Column { kClass, kMustNotBe, kWeight, kRight, kTool, kPixels, kImage, kCamera, kLighting, kColumns };
  /// Key for sorting; strokes of a class sort by their ids.
  static constexpr int kSortRole = Qt::UserRole + 1;
  /// The share in the column kRight, 0 to 1; invalid if it is unknown.
  static constexpr int kShareRole = Qt::UserRole + 2;

  explicit StrokeModel(QObject* parent = nullptr);
  /// Replaces the strokes. If strokes were only appended to or removed from the end, rows are inserted or
  /// removed; any other change resets the model.
  void setSamples(const colortool::Samples& samples);
  /// Keyed by the strokes' ids: the share of their pixels that a table of the other strokes classifies
  /// correctly, 0 to 1.
  void setRight(std::unordered_map<std::uint64_t, double> right);
  const colortool::Stroke& stroke(int row) const { return *samples_.strokes[static_cast<std::size_t>(row)]; }
  /// The image in which a stroke was drawn.
  const colortool::SampleImage* image(int row) const { return samples_.image(stroke(row).image); }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// Emits a signal if the value differs; the model itself is not changed.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// The user changed "must not be" of a stroke (by its id).
  void mustNotBeWanted(std::uint64_t stroke, bool mustNotBe);
  /// The user changed the weight of a stroke.
  void weightWanted(std::uint64_t stroke, double weight);
  /// The user changed the lighting of a stroke's image.
  void lightingWanted(std::uint64_t stroke, const QString& lighting);

 private:
  QVariant text(const colortool::Stroke& stroke, int column) const;
  QVariant sortKey(const colortool::Stroke& stroke, int column) const;
  QVariant toolTip(const colortool::Stroke& stroke, int column) const;
  /// Unset if it is unknown.
  std::optional<double> right(const colortool::Stroke& stroke) const;
  QString className(const colortool::Stroke& stroke) const;

  colortool::Samples samples_;
  /// See setRight().
  std::unordered_map<std::uint64_t, double> right_;
};

}  // namespace widgets
