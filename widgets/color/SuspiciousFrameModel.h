// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "colortool/image/ColorClasses.h"
#include "widgets/color/FrameSearch.h"

#include "widgets/RowModel.h"

namespace widgets {

/// Frames in which a color table does something suspicious, in the order in which they were found. Keeps the
/// worst FrameSearch::kMaxKept. GUI thread.
class SuspiciousFrameModel final : public RowModel<SuspiciousFrame> {
  Q_OBJECT
 public:
  /// Time with thumbnail, score, classes, and numbers of suspicious pixels by kind (see
  /// colortool::Suspicion).
  enum Column { kTime, kScore, kClasses, kSpecks, kEnclosed, kAmbiguous, kVast, kColumns };
  /// Numbers as numbers.
  static constexpr int kSortRole = Qt::UserRole + 1;

  explicit SuspiciousFrameModel(QObject* parent = nullptr);
  /// Removes all frames; the next ones have these classes.
  void clear(colortool::ColorClasses classes);
  /// Appends frames; removes the mildest if there are too many.
  void add(std::vector<SuspiciousFrame> frames);
  /// The instant shown as 0 s.
  void setOrigin(robotlink::Instant time);

  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// The number of a cell.
  double value(const SuspiciousFrame& frame, int column) const;
  /// The classes of suspicious pixels with their numbers, largest first: "orange 34, red 12".
  QString classesOf(const SuspiciousFrame& frame) const;
  /// Removes the frames with the lowest scores.
  void removeMildest(std::size_t count);

  colortool::ColorClasses classes_;
  robotlink::Instant origin_;
};

}  // namespace widgets
