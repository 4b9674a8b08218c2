// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/StreamListModel.h"

#include <QFont>
#include <QLocale>
#include <algorithm>
#include <filesystem>

#include "robotlink/session/Session.h"
#include "widgets/log/LogOverview.h"

namespace widgets {

QString bytesText(std::uint64_t bytes) {
  return QLocale::c().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

StreamListModel::StreamListModel(QObject* parent)
    : RowModel({tr("Stream"), tr("Messages"), tr("Size"), tr("Hz"), tr("Schema"), tr("Log")}, parent) {}

std::vector<StreamRow> StreamListModel::rowsOf(const std::string& log, const LogOverview& overview,
                                               const std::set<std::string>& hidden) {
  std::vector<StreamRow> rows;
  for (const auto& stream : overview.streams) {
    rows.push_back({log, stream.path, stream.type, stream.count, stream.bytes, stream.rate(),
                    !hidden.contains(stream.path)});
  }
  return rows;
}

std::vector<StreamRow> StreamListModel::rowsOf(robotlink::Session& session) {
  const auto* archive = session.history().archive();
  const auto onDisk = archive != nullptr ? archive->shares() : std::map<std::string, std::uint64_t>();
  std::vector<StreamRow> rows;
  for (const auto* stream : session.store().streams()) {
    const auto found = onDisk.find(stream->path);
    const std::uint64_t before = found != onDisk.end() ? found->second : 0;
    rows.push_back({{}, stream->path, stream->type, stream->count, stream->bytes + before, stream->rate});
  }
  return rows;
}

void StreamListModel::setRows(std::vector<StreamRow> rows) {
  if (rows == rows_) return;
  replaceRows(std::move(rows),
              [](const StreamRow& a, const StreamRow& b) { return a.log == b.log && a.path == b.path; });
}

QVariant StreamListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const StreamRow& at = row(index.row());
  const bool isNumber = index.column() >= kCount && index.column() <= kRate;
  if (role == Qt::TextAlignmentRole && isNumber) return kNumberAlignment;
  if (role == Qt::CheckStateRole && index.column() == kPath && !at.log.empty())
    return at.shown ? Qt::Checked : Qt::Unchecked;
  if (role == kFilterRole) return QString::fromStdString(at.path + ' ' + at.type);
  if (role == Qt::FontRole && at.stepped) {
    QFont font;
    font.setBold(true);
    return font;
  }
  if (role == Qt::ToolTipRole && index.column() == kPath) {
    return at.stepped ? tr("%1: its messages are stepped").arg(QString::fromStdString(at.path))
                      : QString::fromStdString(at.path);
  }
  if (role != Qt::DisplayRole && role != kSortRole) return {};
  const bool sort = role == kSortRole;
  switch (index.column()) {
    case kPath:
      return QString::fromStdString(at.path);
    case kCount:
      return sort ? QVariant(qulonglong{at.count}) : QString::number(at.count);
    case kBytes:
      return sort ? QVariant(qulonglong{at.bytes}) : at.bytes > 0 ? bytesText(at.bytes) : QStringLiteral("–");
    case kRate:
      return sort ? QVariant(at.rate) : at.rate > 0 ? QString::number(at.rate, 'f', 1) : QStringLiteral("–");
    case kSchema:
      return QString::fromStdString(at.type);
    default:
      return QString::fromStdString(std::filesystem::path(at.log).filename().string());
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
