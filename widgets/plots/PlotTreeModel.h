// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStandardItemModel>
#include <functional>

#include "widgets/plots/PlotChoices.h"

namespace widgets {

/// The sources that can be plotted as a tree by the parts of the streams' paths, with the fields as leaves
/// and their units next to them; the elements of long lists are below one row. Those that are not published
/// now are gray. Leaves can be dragged; the MIME data are the texts of their sources, one per line. GUI
/// thread.
class PlotTreeModel final : public QStandardItemModel {
  Q_OBJECT
 public:
  /// Name of a folder, stream or field, and the field's unit.
  enum Column { kName, kUnit, kColumns };
  /// PlotSource::text(); empty for folders.
  static constexpr int kSourceRole = Qt::UserRole + 1;
  /// The path of a folder, stream or long list; empty for fields.
  static constexpr int kPathRole = Qt::UserRole + 2;
  /// MIME type of dragged sources; the same data is also plain text.
  static constexpr char kMimeType[] = "application/x-robotcontrol-plot";

  /// Longer lists have a row of their own; this many elements are also listed of a type without a message.
  static constexpr int kMaxElements = 32;

  using QStandardItemModel::QStandardItemModel;
  /// Returns an addition to the name of a field, such as the joint of "positions[3]"; empty: none.
  using Explain = std::function<QString(const PlotSource&)>;
  /// Rebuilds the tree.
  void setChoices(const std::vector<PlotChoice>& choices, const Explain& explain = {});
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
};

}  // namespace widgets
