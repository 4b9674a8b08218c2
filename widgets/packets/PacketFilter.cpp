// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketFilter.h"

#include <algorithm>

#include "widgets/packets/PacketModel.h"

namespace widgets {
namespace {

/// The bytes that a text spells as hexadecimal digits; empty if it is anything else or fewer than two bytes.
QByteArray spelled(QString text) {
  text.remove(QLatin1Char(' '));
  const auto isDigit = [](QChar c) { return QStringLiteral("0123456789abcdefABCDEF").contains(c); };
  if (text.size() < 4 || text.size() % 2 != 0 || !std::all_of(text.begin(), text.end(), isDigit)) return {};
  return QByteArray::fromHex(text.toLatin1());
}

}  // namespace

void PacketFilter::setFrom(From from) {
  if (from == from_) return;
  from_ = from;
  invalidateFilter();
}

void PacketFilter::setHiddenNames(QSet<QString> names) {
  if (names == hidden_) return;
  hidden_ = std::move(names);
  invalidateFilter();
}

void PacketFilter::setText(const QString& text) {
  if (text == text_) return;
  text_ = text;
  bytes_ = spelled(text);
  invalidateFilter();
}

void PacketFilter::setDamagedOnly(bool only) {
  if (only == damagedOnly_) return;
  damagedOnly_ = only;
  invalidateFilter();
}

bool PacketFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  const PacketEntry& entry = static_cast<const PacketModel*>(sourceModel())->entry(row);
  if (damagedOnly_ && !entry.damaged) return false;
  if (from_ != From::kBoth && entry.fromRobot != (from_ == From::kRobot)) return false;
  if (!hidden_.isEmpty() && hidden_.contains(entry.name)) return false;
  if (text_.isEmpty()) return true;
  if (entry.name.contains(text_, Qt::CaseInsensitive) || entry.summary.contains(text_, Qt::CaseInsensitive))
    return true;
  return !bytes_.isEmpty() && entry.bytes.find(bytes_.constData(), 0,
                                               static_cast<std::size_t>(bytes_.size())) != std::string::npos;
}

}  // namespace widgets
