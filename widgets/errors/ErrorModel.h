// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/truth/TruthErrors.h"
#include "widgets/RowModel.h"

namespace widgets {

/// The figures of one error of what a solution publishes, in the unit that is shown.
struct ErrorRow {
  robotlink::ErrorSource source;
  std::string package;
  /// "position"; empty: nothing was reported yet that could be compared.
  std::string quantity;
  /// mm, degrees, ms, percent, or percent of the time.
  QString unit;
  std::size_t samples = 0;
  double last = 0, mean = 0;
  /// Unset where only the mean says something, as of a share of the time.
  std::optional<double> median, ninetyFive, maximum;
  /// Percent; unset: nothing could be missed, or nothing was reported.
  std::optional<double> missed, invented;
  /// Mean, ms.
  double latency = 0;

  bool isShadow() const { return source.path != package; }
};

/// The errors of a robot's beliefs relative to the truth: a row for each quantity of a stream and solution.
/// GUI thread.
class ErrorModel final : public RowModel<ErrorRow> {
  Q_OBJECT
 public:
  enum Column {
    kStream,
    kSolution,
    kError,
    kUnit,
    kLast,
    kMean,
    kMedian,
    kNinetyFive,
    kMax,
    kSamples,
    kMissed,
    kFalse,
    kLatency,
    kColumns
  };
  /// The number of a cell, for sorting; the text in columns of texts.
  static constexpr int kNumberRole = Qt::UserRole + 1;

  explicit ErrorModel(QObject* parent = nullptr);
  /// Replaces the rows; a selection survives unless there are others.
  void setErrors(const robotlink::TruthErrors::Packages& errors);

  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
};

}  // namespace widgets
