// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/base/Clock.h"
#include "widgets/TitledModel.h"

namespace widgets {

/// A search hit in the open logs.
struct SearchRow {
  /// On the timeline; unset `until`: to the end of the log.
  robotlink::Instant from;
  std::optional<robotlink::Instant> until;
  QString robot;
  /// The text, or what was searched for.
  QString text;
  /// File name of the log.
  QString log;
  /// The index of the searched log.
  std::size_t number = 0;
};

/// The results of a search, as a table, in order of time. GUI thread.
class SearchModel final : public TitledModel {
  Q_OBJECT
 public:
  /// Since when in s, for how many s, robot, text, file name of the log.
  enum Column { kFrom, kLength, kRobot, kText, kLog, kColumns };
  explicit SearchModel(QObject* parent = nullptr);
  void clear();
  /// Adds rows, each at its place by time.
  void add(const std::vector<SearchRow>& rows);
  /// Moves what was found in one of the logs, whose offset was changed by this.
  void move(std::size_t log, robotlink::Duration by);
  const SearchRow& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
  const std::vector<SearchRow>& rows() const { return rows_; }
  /// The instant shown as 0 s.
  void setOrigin(robotlink::Instant time);
  /// The last row not later than a time; -1 if there is none.
  int rowAt(robotlink::Instant time) const;
  /// All rows as text, with a line of titles.
  QString csv() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<SearchRow> rows_;
  robotlink::Instant origin_;
};

}  // namespace widgets
