// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>

namespace widgets {

struct PacketEntry;

/// A packet field by field, and its bytes as hexadecimal numbers and characters. Object name "packetDetails".
class PacketDetails final : public QTreeWidget {
  Q_OBJECT
 public:
  explicit PacketDetails(QWidget* parent = nullptr);
  /// Null: nothing is shown.
  void show(const PacketEntry* entry);

 private:
  void addFields(const PacketEntry& entry);
  void addBytes(const std::string& bytes);
};

}  // namespace widgets
