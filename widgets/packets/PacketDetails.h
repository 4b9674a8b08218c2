// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>

namespace widgets {

struct PacketEntry;

/// Shows a packet field by field, and its bytes as hexadecimal numbers and characters. Object name
/// "packetDetails". GUI thread.
class PacketDetails final : public QTreeWidget {
  Q_OBJECT
 public:
  explicit PacketDetails(QWidget* parent = nullptr);
  /// Null: nothing is shown. The entry is not kept.
  void show(const PacketEntry* entry);

 private:
  /// The decoded fields, or what is wrong with the packet.
  void addFields(const PacketEntry& entry);
  /// Rows of bytes.
  void addBytes(const std::string& bytes);
};

}  // namespace widgets
