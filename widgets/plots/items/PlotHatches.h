// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <vector>

#include "widgets/log/MissingValues.h"

class QCPItemRect;
class QCPItemText;
class QCustomPlot;

namespace widgets {

/// Hatches the times of a plot whose values are missing, and says why. GUI thread.
class PlotHatches {
  Q_DECLARE_TR_FUNCTIONS(widgets::PlotHatches)
 public:
  /// `plot` must outlive this; its palette and font are used.
  explicit PlotHatches(QCustomPlot& plot) : plot_(plot) {}
  /// Seen after the plot is drawn.
  void set(std::vector<MissingValues> missing);
  const std::vector<MissingValues>& missing() const { return missing_; }

 private:
  /// The plot owns them.
  struct Items {
    QCPItemRect* hatch;
    QCPItemText* text;
  };
  Items make();
  static QString textOf(MissingValues::Why why);

  QCustomPlot& plot_;
  std::vector<MissingValues> missing_;
  std::vector<Items> items_;
};

}  // namespace widgets
