// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>
#include <cstdint>
#include <unordered_map>

namespace widgets {

class StrokeModel;

/// The strokes of a StrokeModel in the order that the user chose. The order can be frozen, so that a stroke
/// stays where it is while it is being changed, although its new values belong elsewhere. GUI thread.
class StrokeOrder final : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  /// `strokes` is the source model, and must outlive this object.
  explicit StrokeOrder(StrokeModel& strokes, QObject* parent = nullptr);

  /// Keeps the strokes where they are now; strokes that are added come last. Has no effect if it is frozen.
  void freeze();
  /// Sorts by values again.
  void thaw();

 protected:
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  /// The row at which a stroke of the model was shown.
  std::size_t placeOf(const QModelIndex& index) const;

  StrokeModel& strokes_;
  /// Rows by the strokes' ids; empty: not frozen.
  std::unordered_map<std::uint64_t, std::size_t> places_;
};

}  // namespace widgets
