// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/models/StreamListModel.h"

class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// The streams of the open logs with count, size, rate and schema. A check gives a stream a row in the time
/// line; a double click or Enter lets its messages be stepped.
class StreamsView final : public View {
  Q_OBJECT
 public:
  explicit StreamsView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createViews();
  void connectSignals();
  void showSummary();

  OpenLogs& logs_;
  StreamListModel model_;
  QSortFilterProxyModel* filtered_;
  QTableView* table_ = nullptr;
  QLabel* summary_ = nullptr;
  EmptyHint* hint_ = nullptr;
  std::uint64_t shownVersion_ = 0;
};

}  // namespace widgets
