// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <cstdint>
#include <optional>
#include <vector>

#include "widgets/View.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/search/LogSearcher.h"
#include "widgets/search/SearchModel.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace widgets {

class EmptyHint;

/// Searches the whole of the open logs in the background, without playing them, or what is kept of live
/// robots: for where an expression is true, or for texts that match a regular expression. What logs lack is
/// computed as OpenLogs knows how to. A click on a hit jumps there; hits are marked in the timeline and in
/// plots.
///
/// A search continues and ends while the view is hidden, too. Registered as "search". GUI thread.
class SearchView final : public View {
  Q_OBJECT
 public:
  explicit SearchView(ViewContext& context, QWidget* parent = nullptr);
  ~SearchView() override;
  void tick() override;
  /// All hits as a table (.csv), or a picture.
  robotlink::Result<void> saveTo(const QString& file) override;
  /// Starts a search. Fails if there is nothing to search, or `wanted` is empty.
  robotlink::Result<void> search(const QString& wanted, bool isTexts);
  void cancel();
  /// Jumps to the next (1) or previous (-1) hit from the shown instant; to the only one in any case. Fails
  /// if there is none.
  robotlink::Result<void> go(int direction);
  bool isSearching() const { return isSearching_; }
  const SearchModel& hits() const { return model_; }

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Searches for what the field holds.
  void searchTyped();
  void jumpTo(int row);
  /// The shown instant of the logs, or of the session.
  robotlink::Instant shownInstant() const;
  /// Whether the session has something that can be searched while no log is open.
  bool hasHistory() const;
  /// Forgets hits in what is no longer there.
  void forgetOthers();
  void takeNews();
  /// Moves hits whose logs got other offsets.
  void followOffsets();
  /// Marks the hits in timeline and plots.
  void showMarks();
  void showState(const LogSearcher::News& news);

  OpenLogs& logs_;
  SearchModel model_;
  LogSearcher searcher_;
  LogSearcher::Plan plan_;
  /// The offsets with which hits of the plan's logs are shown.
  std::vector<robotlink::Duration> offsets_;
  /// Runs while the view must follow something: a search, or the offsets of logs with hits. Hidden views have
  /// no ticks.
  QTimer follow_;
  bool isSearching_ = false;
  /// The session's restarts when its history was searched; unset: logs were.
  std::optional<std::uint64_t> searchedGeneration_;
  QComboBox* kind_ = nullptr;
  QLineEdit* wanted_ = nullptr;
  QAction* search_ = nullptr;
  QAction* cancel_ = nullptr;
  QAction* previous_ = nullptr;
  QAction* next_ = nullptr;
  QTableView* table_ = nullptr;
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
