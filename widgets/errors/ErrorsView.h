// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotlink/truth/TruthErrors.h"
#include "widgets/PackageSubscription.h"
#include "widgets/TypedStreams.h"
#include "widgets/View.h"
#include "widgets/errors/ErrorModel.h"

class QAction;
class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// The errors of the percepts and models of the selected robot relative to the simulation's truth, as figures
/// since the last reset. It switches on the debug keys of what it compares. Figures of other robots
/// stay until a reset of the simulation, or a jump in a log, starts all of them over.
///
/// Registered as "errors". GUI thread.
class ErrorsView final : public View {
  Q_OBJECT
 public:
  explicit ErrorsView(ViewContext& context, QWidget* parent = nullptr);
  /// Compares what arrived since the last tick; the table follows a few times a second.
  void tick() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Reads what arrived.
  void takeNews();
  /// Appends the messages that arrived, of all streams that matter; false if the clock went back.
  bool collect(std::vector<const robotlink::StreamMessage*>& news);
  void showFigures();
  void showState();
  /// The formula of the current row; empty: it has none.
  std::string chosenFormula() const;
  void plot();
  void reset();
  /// Whether the robot can publish the truth, as its key table says.
  bool knowsTruth() const;

  robotlink::TruthErrors errors_;
  PackageSubscription subscription_;
  /// The part of each stream that was already read, by path.
  std::map<std::string, StreamCursor> cursors_;
  std::string robot_;
  /// Ticks until the figures are shown again.
  int wait_ = 0;
  ErrorModel model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QLabel* state_ = nullptr;
  QAction* plot_ = nullptr;
  QAction* copy_ = nullptr;
  QAction* reset_ = nullptr;
};

}  // namespace widgets
