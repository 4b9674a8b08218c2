// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Clock.h"

#include "widgets/TitledModel.h"

namespace widgets {

/// The packages of a replay: the source of each (as logged or recomputed), and how the recomputed packages
/// differ from the logged ones. The source can be edited; an edit is a signal to the owner, who requests it.
/// GUI thread.
class ReplayPackageModel final : public TitledModel {
  Q_OBJECT
 public:
  /// Name, source, number of compared messages, number of different ones, time of the first difference, and
  /// field and size of the largest one.
  enum Column { kPackage, kSource, kCompared, kDifferent, kFirst, kLargest, kColumns };
  /// Numbers and times as numbers.
  static constexpr int kSortRole = Qt::UserRole + 1;
  /// robotcontrol.ControlReplay.PackageSource as int: the user's choice (AUTOMATIC: none). Can be set.
  static constexpr int kChoiceRole = Qt::UserRole + 2;
  /// Time of the first difference in ns; invalid if there is none.
  static constexpr int kFirstRole = Qt::UserRole + 3;
  /// Time of the largest difference in ns; invalid if there is none.
  static constexpr int kLargestRole = Qt::UserRole + 4;

  using Source = robotcontrol::ControlReplay::PackageSource;

  explicit ReplayPackageModel(QObject* parent = nullptr);
  /// Replaces the rows; selections survive unless the packages changed. `origin` is the instant shown as 0 s.
  void setStatus(const robotcontrol::ReplayStatus& status, robotlink::Instant origin);
  QString packageName(int row) const;
  /// Whether a source is possible.
  bool allows(int row, Source source) const;
  /// Returns why a source is not possible; empty if it is.
  QString reason(int row, Source source) const;
  /// "as logged", "recomputed", "automatic": translated.
  static QString sourceName(Source source);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// Emits sourceWanted() if the source is possible.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// The user chose a source (robotcontrol.ControlReplay.PackageSource as int).
  void sourceWanted(const QString& package, int source);

 private:
  /// A package and its differences.
  struct Row {
    robotcontrol::ReplayStatus::Package package;
    robotcontrol::ReplayStatus::Difference difference;
    /// Both messages serialized, to detect changes.
    std::string bytes;
  };
  QVariant text(const Row& row, int column) const;
  QString shownTime(std::int64_t ns) const;
  QVariant sortKey(const Row& row, int column) const;
  QVariant toolTip(const Row& row, int column) const;
  const Row& at(int row) const { return rows_[static_cast<std::size_t>(row)]; }

  std::vector<Row> rows_;
  /// The instant shown as 0 s.
  robotlink::Instant origin_{};
};

}  // namespace widgets
