// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketDetails.h"

#include <QFontDatabase>

#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/Theme.h"
#include "widgets/packets/PacketEntry.h"

namespace widgets {
namespace {

constexpr std::size_t kBytesInLine = 8;
constexpr std::size_t kMaxBytes = 1024;  // damaged bytes may be longer than any packet

}  // namespace

PacketDetails::PacketDetails(QWidget* parent) : QTreeWidget(parent) {
  describe(*this, {"packetDetails", tr("Packet"), tr("The selected packet, field by field, and its bytes")});
  setColumnCount(3);
  setHeaderLabels({tr("Field"), tr("Value"), tr("Unit")});
  styleTree(*this);
  setRootIsDecorated(true);
  new ColumnFit(*this, {ColumnKind::kName, ColumnKind::kText, ColumnKind::kNumber});
}

void PacketDetails::show(const PacketEntry* entry) {
  clear();
  if (entry == nullptr) return;
  addFields(*entry);
  if (!entry->bytes.empty()) addBytes(entry->bytes);
}

void PacketDetails::addFields(const PacketEntry& entry) {
  auto* title = new QTreeWidgetItem(this, {entry.name});
  title->setFirstColumnSpanned(true);
  QFont bold = font();
  bold.setBold(true);
  title->setFont(0, bold);
  title->setExpanded(true);
  if (entry.kind != PacketEntry::Kind::kPacket) return;
  const auto description = describePacket(entry);
  const auto addText = [&](const std::string& text, bool bad) {
    if (text.empty()) return;
    auto* item = new QTreeWidgetItem(title, {QString::fromStdString(text)});
    item->setFirstColumnSpanned(true);
    item->setForeground(0, bad ? colorOf(Meaning::kBad, palette()) : colorOf(Meaning::kMuted, palette()));
    item->setToolTip(0, QString::fromStdString(text));
  };
  addText(description.problem, true);
  addText(description.summary, false);
  for (const auto& field : description.fields) {
    auto* item =
        new QTreeWidgetItem(title, {QString::fromStdString(field.name), QString::fromStdString(field.value),
                                    QString::fromStdString(field.unit)});
    item->setToolTip(1, item->text(1));
  }
}

void PacketDetails::addBytes(const std::string& bytes) {
  auto* title = new QTreeWidgetItem(this, {counted(bytes.size(), tr("1 byte"), tr("%1 bytes"))});
  title->setFirstColumnSpanned(true);
  const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  for (std::size_t at = 0; at < std::min(bytes.size(), kMaxBytes); at += kBytesInLine) {
    const std::string part = bytes.substr(at, kBytesInLine);
    QString characters;
    for (const char c : part) characters += c >= 32 && c < 127 ? QLatin1Char(c) : QLatin1Char('.');
    const int digits = 3 * static_cast<int>(kBytesInLine) - 1;
    auto* line = new QTreeWidgetItem(title, {QStringLiteral("%1  %2  %3")
                                                 .arg(at, 4, 16, QLatin1Char('0'))
                                                 .arg(hexText(part), -digits)
                                                 .arg(characters)});
    line->setFont(0, fixed);
    line->setToolTip(0, line->text(0));
    line->setFirstColumnSpanned(true);
  }
  title->setExpanded(true);
}

}  // namespace widgets
