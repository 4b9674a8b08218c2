// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/streams/StreamListModel.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <filesystem>

#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/Counted.h"
#include "widgets/Theme.h"
#include "widgets/TypedStreams.h"
#include "widgets/log/LogOverview.h"

namespace widgets {

StreamListModel::StreamListModel(QObject* parent)
    : RowModel({tr("Stream"), tr("Hz"), tr("Bytes/s"), tr("Mean size"), tr("Messages"), tr("Size"),
                tr("Share"), tr("Left out"), tr("Asked by"), tr("Schema"), tr("Log")},
               parent) {}

std::vector<StreamRow> StreamListModel::rowsOf(const std::string& log, const LogOverview& overview,
                                               const std::set<std::string>& hidden) {
  std::vector<StreamRow> rows;
  for (const auto& stream : overview.streams) {
    StreamRow& row = rows.emplace_back();
    row.log = log;
    row.path = stream.path;
    row.type = stream.type;
    row.count = stream.count;
    row.bytes = stream.bytes;
    row.rate = stream.rate();
    row.meanSize = row.count > 0 ? static_cast<double>(row.bytes) / static_cast<double>(row.count) : 0;
    row.byteRate = row.rate * row.meanSize;
    row.shown = !hidden.contains(stream.path);
  }
  return rows;
}

std::vector<StreamRow> StreamListModel::rowsOf(robotlink::Session& session,
                                               const std::set<std::string>* robots) {
  const auto* archive = session.history().archive();
  const auto onDisk = archive != nullptr ? archive->shares() : std::map<std::string, std::uint64_t>();
  const StreamAskers askers(session);
  const auto& remote = session.remoteRobots();
  std::vector<StreamRow> rows;
  for (const auto* stream : session.store().streams()) {
    const std::string robot = robotlink::streams::robotOf(stream->path);
    if (robots != nullptr && !robots->contains(robot)) continue;
    StreamRow& row = rows.emplace_back();
    row.path = stream->path;
    row.type = stream->type;
    row.count = stream->count;
    const auto found = onDisk.find(stream->path);
    row.bytes = stream->bytes + (found != onDisk.end() ? found->second : 0);
    row.rate = stream->rate;
    row.byteRate = stream->byteRate;
    if (!stream->messages.empty())
      row.meanSize = static_cast<double>(stream->bytes) / static_cast<double>(stream->messages.size());
    row.asked = askers.of(*stream);
    const auto line = remote.find(robot);
    if (line == remote.end()) continue;
    if (const auto counted = line->second.missing.find(stream->path); counted != line->second.missing.end())
      row.missing = counted->second;
  }
  return rows;
}

void StreamListModel::setRows(std::vector<StreamRow> rows, Which which) {
  std::uint64_t all = 0;
  for (const StreamRow& row : rows) all += row.bytes;
  for (StreamRow& row : rows)
    row.share = all > 0 ? static_cast<double>(row.bytes) / static_cast<double>(all) : 0;
  if (which == Which::kUnread) std::erase_if(rows, [](const StreamRow& row) { return row.asked.isRead(); });
  if (which == Which::kLeftOut)
    std::erase_if(rows, [](const StreamRow& row) { return row.missing == robotlink::MissingMessages(); });
  if (rows == rows_) return;
  replaceRows(std::move(rows),
              [](const StreamRow& a, const StreamRow& b) { return a.log == b.log && a.path == b.path; });
}

QVariant StreamListModel::sortValue(const StreamRow& row, int column) const {
  switch (column) {
    case kRate:
      return row.rate;
    case kByteRate:
      return row.byteRate;
    case kMeanSize:
      return row.meanSize;
    case kCount:
      return qulonglong{row.count};
    case kBytes:
      return qulonglong{row.bytes};
    case kShare:
      return row.share;
    case kLeftOut:
      return qulonglong{row.missing.thinned + row.missing.lost};
    default:
      return shownText(row, column);
  }
}

QString StreamListModel::shownText(const StreamRow& row, int column) const {
  const QString unknown = QStringLiteral("–");
  switch (column) {
    case kPath:
      return QString::fromStdString(row.path);
    case kRate:
      return row.rate > 0 ? QString::number(row.rate, 'f', 1) : unknown;
    case kByteRate:
      return row.byteRate > 0 ? bytesText(static_cast<std::uint64_t>(row.byteRate)) : unknown;
    case kMeanSize:
      return row.meanSize > 0 ? bytesText(static_cast<std::uint64_t>(row.meanSize)) : unknown;
    case kCount:
      return QString::number(row.count);
    case kBytes:
      return row.bytes > 0 ? bytesText(row.bytes) : unknown;
    case kShare:
      return row.share > 0 ? tr("%1 %").arg(row.share * 100, 0, 'f', 1) : unknown;
    case kLeftOut:
      return row.missing == robotlink::MissingMessages() ? QString()
             : row.missing.lost == 0
                 ? tr("%1 thinned").arg(row.missing.thinned)
                 : tr("%1 thinned, %2 lost").arg(row.missing.thinned).arg(row.missing.lost);
    case kAskedBy:
      return row.asked.isRead()        ? (row.asked.views + row.asked.clients).join(QStringLiteral(", "))
             : row.asked.key.isEmpty() ? QString()
                                       : tr("nobody; key %1").arg(row.asked.key);
    case kSchema:
      return QString::fromStdString(row.type);
    default:
      return QString::fromStdString(std::filesystem::path(row.log).filename().string());
  }
}

QString StreamListModel::toolTip(const StreamRow& row, int column) const {
  if (column == kPath) {
    const QString path = QString::fromStdString(row.path);
    return row.stepped ? tr("%1: its messages are stepped").arg(path) : path;
  }
  if (column != kAskedBy) return {};
  QStringList lines;
  if (!row.asked.views.isEmpty()) lines << tr("Views: %1").arg(row.asked.views.join(QStringLiteral(", ")));
  if (!row.asked.clients.isEmpty())
    lines << tr("Clients: %1").arg(row.asked.clients.join(QStringLiteral(", ")));
  if (!row.asked.key.isEmpty()) lines << tr("Debug key %1").arg(row.asked.key);
  return lines.join(QLatin1Char('\n'));
}

QVariant StreamListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const StreamRow& at = row(index.row());
  const bool isNumber = index.column() >= kRate && index.column() <= kShare;
  if (role == Qt::TextAlignmentRole && isNumber) return kNumberAlignment;
  if (role == Qt::CheckStateRole && index.column() == kPath && !at.log.empty())
    return at.shown ? Qt::Checked : Qt::Unchecked;
  if (role == kFilterRole)
    return QString::fromStdString(at.path + ' ' + at.type + ' ') + shownText(at, kAskedBy);
  if (role == Qt::FontRole && at.stepped) {
    QFont font;
    font.setBold(true);
    return font;
  }
  if (role == Qt::ForegroundRole) {
    const bool isLoss = index.column() == kLeftOut && at.missing.lost > 0;
    if (isLoss) return colorOf(Meaning::kBad, QGuiApplication::palette());
    const bool isUnread = index.column() == kAskedBy && !at.asked.isRead();
    return isUnread ? QVariant(colorOf(Meaning::kMuted, QGuiApplication::palette())) : QVariant();
  }
  if (role == Qt::ToolTipRole) {
    const QString text = toolTip(at, index.column());
    return text.isEmpty() ? QVariant() : QVariant(text);
  }
  if (role == kSortRole) return sortValue(at, index.column());
  return role == Qt::DisplayRole ? QVariant(shownText(at, index.column())) : QVariant();
}

QVariant StreamListModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::ToolTipRole)
    return RowModel::headerData(section, orientation, role);
  switch (section) {
    case kByteRate:
      return tr("Size of its messages per second");
    case kBytes:
      return tr("Size of its history, in memory and on disk; for a log, its size in the file");
    case kShare:
      return tr("Its share of the memory for the history of all streams");
    case kLeftOut:
      return tr(
          "Of remote robots: messages replaced by newer ones because the line is narrow or a lower "
          "rate was chosen (thinned), and lost ones");
    case kAskedBy:
      return tr("The views of this window that read it, and the clients of a link that subscribe to it");
    default:
      return {};
  }
}

bool StreamListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::CheckStateRole || index.column() != kPath) return false;
  StreamRow& at = rows_[static_cast<std::size_t>(index.row())];
  at.shown = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index, {Qt::CheckStateRole});
  Q_EMIT shownChanged(at.log, at.path, at.shown);
  return true;
}

Qt::ItemFlags StreamListModel::flags(const QModelIndex& index) const {
  const auto flags = QAbstractTableModel::flags(index);
  const bool hasCheck = index.isValid() && index.column() == kPath && !row(index.row()).log.empty();
  return hasCheck ? flags | Qt::ItemIsUserCheckable : flags;
}

}  // namespace widgets
