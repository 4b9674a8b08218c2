// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "widgets/TimedModel.h"
#include "widgets/packets/PacketEntry.h"

namespace widgets {

/// The packets of one robot, or of a file, as a table. GUI thread.
class PacketModel final : public TimedModel<PacketEntry> {
  Q_OBJECT
 public:
  /// Time in s, direction, name, contents in one line, number of bytes.
  enum Column { kTime, kDirection, kName, kSummary, kBytes, kColumns };

  /// `capacity`: the largest number of rows.
  explicit PacketModel(std::size_t capacity = 100'000, QObject* parent = nullptr);

  void clear() override;
  /// Number of rows by packet name; names whose rows were all removed remain with 0.
  const std::map<QString, int>& names() const { return names_; }

  QVariant data(const QModelIndex& index, int role) const override;

 private:
  void count(PacketEntry& entry) override;
  void discount(const PacketEntry& entry) override;
  /// The text of a cell.
  QString text(const PacketEntry& entry, int column) const;

  std::map<QString, int> names_;
};

}  // namespace widgets
