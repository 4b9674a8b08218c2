// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <vector>

#include "widgets/packets/PacketEntry.h"

#include "widgets/TitledModel.h"

namespace widgets {

/// The packets of one robot, or of a file, as a table. Memory is bounded: beyond `capacity` rows the oldest
/// are removed, a hundredth of the capacity at a time, so that a full table costs no more than an empty one.
/// A batch is one insertion. GUI thread.
class PacketModel final : public TitledModel {
  Q_OBJECT
 public:
  /// Time in s, direction, name, contents in one line, number of bytes.
  enum Column { kTime, kDirection, kName, kSummary, kBytes, kColumns };

  /// `capacity`: the largest number of rows.
  explicit PacketModel(std::size_t capacity = 100'000, QObject* parent = nullptr);

  void append(std::vector<PacketEntry> entries);
  void clear();
  /// The instant that the column of times displays as 0 s.
  void setOrigin(robotlink::Instant time);
  const PacketEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  /// The last row not later than `time`; -1 if there is none.
  int rowAt(robotlink::Instant time) const;
  /// Number of rows by packet name; names whose rows were all removed remain with 0.
  const std::map<QString, int>& names() const { return names_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  /// Removes the oldest rows.
  void forgetFirst(std::size_t count);
  /// The text of a cell.
  QString text(const PacketEntry& entry, int column) const;

  std::size_t capacity_;
  std::deque<PacketEntry> entries_;
  std::map<QString, int> names_;
  robotlink::Instant origin_;
};

}  // namespace widgets
