// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/log/StreamListModel.h"

class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// The streams of the open logs, or of live robots, with number of messages, size, rate and schema. In a log,
/// a check box gives a stream a row in the timeline; a double click or Enter makes its messages those that
/// are stepped.
///
/// Registered as "log-streams". GUI thread.
class StreamsView final : public View {
  Q_OBJECT
 public:
  explicit StreamsView(ViewContext& context, QWidget* parent = nullptr);
  /// Lists the streams if the logs changed.
  void tick() override;

 private:
  void createViews();
  void connectSignals();
  /// Lists what is kept of live robots, and each stream's share of it.
  void showLive();
  /// Updates the line with the totals.
  void showSummary();

  OpenLogs& logs_;
  StreamListModel model_;
  /// The streams filtered by the search field.
  QSortFilterProxyModel* filtered_;
  QTableView* table_ = nullptr;
  QLabel* summary_ = nullptr;
  EmptyHint* hint_ = nullptr;
  /// OpenLogs::version() of what is shown.
  std::uint64_t shownVersion_ = 0;
  int ticks_ = 0;
};

}  // namespace widgets
