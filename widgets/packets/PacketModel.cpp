// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketModel.h"

#include <QGuiApplication>
#include <algorithm>
#include <utility>

#include "widgets/Theme.h"

namespace widgets {

PacketModel::PacketModel(std::size_t capacity, QObject* parent)
    : TitledModel({tr("Time [s]"), tr("Direction"), tr("Name"), tr("Contents"), tr("Bytes")}, parent),
      capacity_(capacity) {}

void PacketModel::append(std::vector<PacketEntry> entries) {
  if (entries.size() > capacity_)
    entries.erase(entries.begin(), entries.end() - static_cast<std::ptrdiff_t>(capacity_));
  if (entries.empty()) return;
  const std::size_t wanted = entries_.size() + entries.size();
  if (wanted > capacity_)
    forgetFirst(std::min(entries_.size(), std::max(wanted - capacity_, capacity_ / 100)));
  const int first = static_cast<int>(entries_.size());
  beginInsertRows({}, first, first + static_cast<int>(entries.size()) - 1);
  for (PacketEntry& entry : entries) {
    // Equal names share their memory (QString is implicitly shared).
    const auto name = names_.try_emplace(entry.name, 0).first;
    ++name->second;
    entry.name = name->first;
    entries_.push_back(std::move(entry));
  }
  endInsertRows();
}

void PacketModel::forgetFirst(std::size_t count) {
  if (count == 0) return;
  beginRemoveRows({}, 0, static_cast<int>(count) - 1);
  const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(count);
  for (auto entry = entries_.begin(); entry != end; ++entry) --names_[entry->name];
  entries_.erase(entries_.begin(), end);
  endRemoveRows();
}

void PacketModel::clear() {
  beginResetModel();
  entries_.clear();
  names_.clear();
  endResetModel();
}

int PacketModel::rowAt(robotlink::Instant time) const {
  for (int row = static_cast<int>(entries_.size()) - 1; row >= 0; --row) {
    if (entry(row).time <= time) return row;
  }
  return -1;
}

int PacketModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

void PacketModel::setOrigin(robotlink::Instant time) {
  if (std::exchange(origin_, time) == time || entries_.empty()) return;
  Q_EMIT dataChanged(index(0, kTime), index(rowCount() - 1, kTime));
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
