// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Clock.h"

namespace widgets {

/// The packages of a replay: from where each comes, and how what is recomputed differs from what was logged.
/// The source can be chosen. GUI thread.
class ReplayPackageModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kPackage, kSource, kCompared, kDifferent, kFirst, kLargest, kColumns };
  static constexpr int kSortRole = Qt::UserRole + 1;
  /// robotcontrol.ControlReplay.PackageSource: what a person chose (AUTOMATIC: nothing), also to be set.
  static constexpr int kChoiceRole = Qt::UserRole + 2;
  /// When the first difference is, ns; invalid if there is none.
  static constexpr int kFirstRole = Qt::UserRole + 3;
  /// When the largest is.
  static constexpr int kLargestRole = Qt::UserRole + 4;

  using Source = robotcontrol::ControlReplay::PackageSource;

  using QAbstractTableModel::QAbstractTableModel;
  /// `origin`: what is shown as 0 s.
  void setStatus(const robotcontrol::ReplayStatus& status, robotlink::Instant origin);
  QString packageName(int row) const;
  /// Whether this source is possible, and if not, why.
  bool allows(int row, Source source) const;
  QString reason(int row, Source source) const;
  static QString sourceName(Source source);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  void sourceWanted(const QString& package, int source);

 private:
  struct Row {
    robotcontrol::ReplayStatus::Package package;
    robotcontrol::ReplayStatus::Difference difference;
    std::string bytes;  // of both, to see what changed
  };
  QVariant text(const Row& row, int column) const;
  QString shownTime(std::int64_t ns) const;
  QVariant sortKey(const Row& row, int column) const;
  QVariant toolTip(const Row& row, int column) const;
  const Row& at(int row) const { return rows_[static_cast<std::size_t>(row)]; }

  std::vector<Row> rows_;
  robotlink::Instant origin_{};  // what is shown as 0 s
};

}  // namespace widgets
