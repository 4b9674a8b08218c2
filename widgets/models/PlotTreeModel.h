// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStandardItemModel>
#include <functional>

#include "widgets/models/PlotSource.h"

namespace widgets {

/// What can be plotted, as a tree by the parts of the streams' paths, with the fields as leaves and their
/// units beside them. Leaves can be dragged: the data are the texts of their sources, one a line. GUI thread.
class PlotTreeModel final : public QStandardItemModel {
  Q_OBJECT
 public:
  enum Column { kName, kUnit, kColumns };
  static constexpr int kSourceRole = Qt::UserRole + 1;  ///< PlotSource::text(); only leaves have it
  static constexpr char kMimeType[] = "application/x-robotcontrol-plot";

  using QStandardItemModel::QStandardItemModel;
  /// Says more of a source than its field does: the joint that "positions[3]" is of. Empty: nothing.
  using Explain = std::function<QString(const PlotSource&)>;
  void setSources(const std::vector<PlotSource>& sources, const Explain& explain = {});
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
};

}  // namespace widgets
