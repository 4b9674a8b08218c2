// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/View.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/streams/StreamListModel.h"

class QAction;
class QComboBox;
class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// All streams: those of the open logs and of live robots, with rates, sizes, what was left out, and who
/// asked for them. In a log, a check box gives a stream a row in the timeline; a double click or Enter makes
/// its messages those that are stepped.
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
  void createTable();
  void connectSignals();
  /// The rows of the open logs; of streams that are in the session, who asked for them.
  std::vector<StreamRow> logRows() const;
  /// Lists all streams, and begins a new period for who reads them.
  void showStreams();
  /// Updates the line with the totals.
  void showSummary();

  OpenLogs& logs_;
  StreamListModel model_;
  /// The streams filtered by the search field.
  QSortFilterProxyModel* filtered_;
  QTableView* table_ = nullptr;
  QLabel* summary_ = nullptr;
  QComboBox* which_ = nullptr;
  QAction* copy_ = nullptr;
  EmptyHint* hint_ = nullptr;
  /// OpenLogs::version() of what is shown.
  std::uint64_t shownVersion_ = 0;
  /// StreamStore::listVersion() of what is shown.
  std::uint64_t listVersion_ = 0;
  int ticks_ = 0;
};

}  // namespace widgets
