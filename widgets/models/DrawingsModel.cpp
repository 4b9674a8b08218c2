// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/DrawingsModel.h"

#include <QGuiApplication>
#include <QJsonArray>
#include <QPalette>
#include <algorithm>

#include "robotlink/session/StreamStore.h"

namespace widgets {
namespace {

/// "image/ball-percept/circle" of "red1/drawings/image/ball-percept/circle"; empty if it is no drawing.
QString drawingId(const std::string& path) {
  static constexpr std::string_view kFolder = "/drawings/";
  const auto at = path.find(kFolder);
  return at == std::string::npos ? QString() : QString::fromStdString(path.substr(at + kFolder.size()));
}

}  // namespace

DrawingsModel::DrawingsModel(QStringList kinds, QObject* parent)
    : QAbstractListModel(parent), kinds_(std::move(kinds)) {}

void DrawingsModel::refresh(const robotlink::StreamStore& store) {
  if (store.listVersion() == listVersion_) return;
  listVersion_ = store.listVersion();
  for (Row& row : rows_) row.exists = false;
  for (const auto* stream : store.streams()) {
    const QString id = drawingId(stream->path);
    if (!kinds_.contains(id.section(QLatin1Char('/'), 0, 0))) continue;
    addIfNew(id);
    find(id)->exists = true;
  }
  if (!rows_.empty()) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
}

QStringList DrawingsModel::shown() const {
  QStringList ids;
  for (const Row& row : rows_) {
    if (row.shown) ids << row.id;
  }
  return ids;
}

void DrawingsModel::setAllShown(bool shown) {
  for (Row& row : rows_) row.shown = shown;
  if (rows_.empty()) return;
  Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::CheckStateRole});
  Q_EMIT shownChanged();
}

void DrawingsModel::move(int row, int by) {
  const int target = row + by;
  if (row < 0 || row >= rowCount() || target < 0 || target >= rowCount() || by == 0) return;
  beginMoveRows({}, row, row, {}, by > 0 ? target + 1 : target);
  const auto from = rows_.begin() + row, to = rows_.begin() + target;
  if (by > 0) {
    std::rotate(from, from + 1, to + 1);
  } else {
    std::rotate(to, from, from + 1);
  }
  endMoveRows();
  Q_EMIT shownChanged();
}

QJsonObject DrawingsModel::saveState() const {
  QJsonArray order, hidden;
  for (const Row& row : rows_) {
    order.append(row.id);
    if (!row.shown) hidden.append(row.id);
  }
  return {{QStringLiteral("order"), order}, {QStringLiteral("hidden"), hidden}};
}

void DrawingsModel::restoreState(const QJsonObject& state) {
  const QJsonArray hidden = state[QStringLiteral("hidden")].toArray();
  beginResetModel();
  rows_.clear();
  for (const auto& id : state[QStringLiteral("order")].toArray()) {
    if (!id.isString() || find(id.toString()) != nullptr) continue;
    rows_.push_back({id.toString(), !hidden.contains(id), false});
  }
  endResetModel();
  listVersion_ = ~0ULL;
  Q_EMIT shownChanged();
}

int DrawingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant DrawingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return title(row.id);
    case Qt::CheckStateRole:
      return row.shown ? Qt::Checked : Qt::Unchecked;
    case Qt::ToolTipRole:
      return row.exists ? row.id : tr("%1: no robot has drawn it yet").arg(row.id);
    case Qt::ForegroundRole:
      return row.exists ? QVariant() : QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
    case kIdRole:
      return row.id;
    case kExistsRole:
      return row.exists;
    default:
      return {};
  }
}

bool DrawingsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::CheckStateRole) return false;
  rows_[static_cast<std::size_t>(index.row())].shown = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index, {role});
  Q_EMIT shownChanged();
  return true;
}

Qt::ItemFlags DrawingsModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemNeverHasChildren;
}

/// Where there are several kinds, those that are relative to the robot say so.
QString DrawingsModel::title(const QString& id) const {
  const QString name = id.section(QLatin1Char('/'), 1);
  return id.startsWith(QLatin1String("robot/")) ? tr("%1 (robot)").arg(name) : name;
}

DrawingsModel::Row* DrawingsModel::find(const QString& id) {
  const auto found = std::ranges::find(rows_, id, &Row::id);
  return found == rows_.end() ? nullptr : &*found;
}

void DrawingsModel::addIfNew(const QString& id) {
  if (find(id) != nullptr) return;
  beginInsertRows({}, rowCount(), rowCount());
  rows_.push_back({id, true, true});
  endInsertRows();
  Q_EMIT shownChanged();
}

}  // namespace widgets
