// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketModel.h"

#include <QGuiApplication>

#include "widgets/Theme.h"

namespace widgets {

PacketModel::PacketModel(std::size_t capacity, QObject* parent)
    : TimedModel({tr("Time [s]"), tr("Direction"), tr("Name"), tr("Contents"), tr("Bytes")}, capacity,
                 parent) {}

void PacketModel::count(PacketEntry& entry) {
  // Equal names share their memory (QString is implicitly shared).
  const auto name = names_.try_emplace(entry.name, 0).first;
  ++name->second;
  entry.name = name->first;
}

void PacketModel::discount(const PacketEntry& entry) {
  --names_[entry.name];
}

void PacketModel::clear() {
  names_.clear();
  TimedModel::clear();
}

QString PacketModel::text(const PacketEntry& entry, int column) const {
  const bool packet = entry.kind == PacketEntry::Kind::kPacket;
  switch (column) {
    case kTime:
      return QString::number(robotlink::seconds(entry.time - origin_), 'f', 3);
    case kDirection:
      return !packet ? QString() : entry.fromRobot ? tr("← robot") : tr("→ robot");
    case kName:
      return entry.damaged ? tr("⚠ %1").arg(entry.name) : entry.name;
    case kSummary:
      return entry.summary;
    default:
      return packet ? QString::number(entry.bytes.size()) : QString();
  }
}

QVariant PacketModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const PacketEntry& shown = entry(index.row());
  if (role == Qt::DisplayRole) return text(shown, index.column());
  if (role == Qt::TextAlignmentRole && (index.column() == kTime || index.column() == kBytes))
    return kNumberAlignment;
  if (role == Qt::ToolTipRole && index.column() >= kSummary) return hexText(shown.bytes);
  if (role != Qt::ForegroundRole) return {};
  const QPalette palette = QGuiApplication::palette();
  if (shown.damaged) return colorOf(Meaning::kBad, palette);
  if (shown.kind != PacketEntry::Kind::kPacket) return colorOf(Meaning::kMuted, palette);
  return shown.fromRobot ? QVariant() : colorOf(Meaning::kNote, palette);
}

}  // namespace widgets
