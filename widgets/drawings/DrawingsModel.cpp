// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drawings/DrawingsModel.h"

#include <QGuiApplication>
#include <QJsonArray>
#include <QPalette>
#include <QPointer>
#include <QSet>
#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"
#include "widgets/drawings/CurrentDrawings.h"

namespace widgets {
namespace {

/// Returns "image/ball-percept/circle" for "red1/drawings/image/ball-percept/circle", and
/// "image/shadow/region/ball-percept/circle" for "red1/shadow/region/drawings/..."; empty if it is no
/// drawing.
QString drawingId(const std::string& path) {
  static constexpr std::string_view kFolder = "/drawings/";
  const auto at = path.find(kFolder);
  if (at == std::string::npos) return {};
  std::string id = path.substr(at + kFolder.size());
  const auto shadow = path.rfind(std::string("/") + robotlink::streams::kShadow, at);
  if (shadow != std::string::npos)
    id.insert(std::min(id.find('/'), id.size()), path.substr(shadow, at - shadow));
  return QString::fromStdString(id);
}

/// The debug key of a drawing: that of a shadow's is the same as that of the active solution's.
std::string keyOfDrawing(const QString& id) {
  const QString name = id.section(QLatin1Char('/'), 1);
  return (isDrawnInShadow(id) ? name.section(QLatin1Char('/'), 2) : name).toStdString();
}

}  // namespace

DrawingsModel::DrawingsModel(QStringList kinds, QObject* parent)
    : QAbstractListModel(parent), kinds_(std::move(kinds)) {}

void DrawingsModel::refresh(robotlink::Session& session, const std::string& robot) {
  if (session_ != &session || robot_ != robot) {
    // The keys of the other robot are no longer valid, even if this one does not report its own.
    keys_ = nullptr;
    for (Row& row : rows_) {
      row.off = row.asked = false;
      row.refusal.clear();
    }
    if (!rows_.empty()) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
  }
  session_ = &session;
  robot_ = robot;
  refreshStreams(session.store());
  refreshKeys();
}

void DrawingsModel::refreshKeys() {
  const auto tables =
      latestTable(session_->store(), robot_, robotlink::streams::kKeys, session_->timeline().shown());
  const robotlink::PackagePtr keys =
      tables.empty() || tables.front() == nullptr ? nullptr : tables.front()->value;
  if (keys == keys_) return;
  keys_ = keys;
  const auto* table = dynamic_cast<const robotcontrol::KeyTable*>(keys.get());
  for (Row& row : rows_) row.off = false;
  for (int i = 0; table != nullptr && i < table->keys_size(); ++i) {
    const auto& key = table->keys(i);
    const QString id = drawingId(robot_ + '/' + key.stream());
    if (!kinds_.contains(id.section(QLatin1Char('/'), 0, 0))) continue;
    addIfNew(id, key.mode().kind() == robotcontrol::KeyMode::OFF);
    Row& row = *find(id);
    // A key whose n times are over is off, too, but its last drawing remains.
    row.off = key.mode().kind() == robotcontrol::KeyMode::OFF && key.mode().n() == 0;
    row.asked = row.asked && row.off;
    row.help = QString::fromStdString(key.help());
  }
  if (!rows_.empty()) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
  Q_EMIT shownChanged();
}

void DrawingsModel::refreshStreams(const robotlink::StreamStore& store) {
  if (store.listVersion() == listVersion_) return;
  listVersion_ = store.listVersion();
  for (Row& row : rows_) row.exists = false;
  for (const auto* stream : store.streams()) {
    QString id = drawingId(stream->path);
    if (lists_ && lists_(stream->path, stream->type))
      id = QLatin1String(kStreams) + QString::fromStdString(stream->path);
    else if (!kinds_.contains(id.section(QLatin1Char('/'), 0, 0)))
      continue;
    addIfNew(id, false);
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

bool DrawingsModel::setShown(const QString& name, bool shown) {
  bool isFound = false;
  for (int row = 0; row < rowCount(); ++row) {
    const QString& id = rows_[static_cast<std::size_t>(row)].id;
    if (id != name && id.section(QLatin1Char('/'), 1) != name) continue;
    setData(index(row), shown ? Qt::Checked : Qt::Unchecked, Qt::CheckStateRole);
    isFound = true;
  }
  return isFound;
}

QStringList DrawingsModel::names() const {
  QStringList names;
  for (const Row& row : rows_) names << row.id.section(QLatin1Char('/'), 1);
  return names;
}

void DrawingsModel::switchKey(int row, bool on) {
  if (row < 0 || row >= rowCount() || session_ == nullptr || robot_.empty()) return;
  Row& chosen = rows_[static_cast<std::size_t>(row)];
  chosen.asked = on;
  chosen.refusal.clear();
  robotcontrol::Request request;
  request.set_robot(robot_);
  request.mutable_set_key()->set_name(keyOfDrawing(chosen.id));
  request.mutable_set_key()->mutable_mode()->set_kind(on ? robotcontrol::KeyMode::ALWAYS
                                                         : robotcontrol::KeyMode::OFF);
  session_->request(std::move(request),
                    [guard = QPointer(this), id = chosen.id](const robotcontrol::RequestResult& result) {
                      if (guard)
                        guard->onAnswer(id, result.accepted(), QString::fromStdString(result.reason()));
                    });
  Q_EMIT dataChanged(index(row), index(row));
}

void DrawingsModel::onAnswer(const QString& id, bool accepted, const QString& reason) {
  Row* row = find(id);
  if (row == nullptr || accepted) return;
  row->asked = false;
  row->refusal = reason;
  Q_EMIT dataChanged(index(0), index(rowCount() - 1));
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
  QSet<QString> hidden, known;
  for (const auto& id : state[QStringLiteral("hidden")].toArray()) hidden.insert(id.toString());
  beginResetModel();
  rows_.clear();
  for (const auto& value : state[QStringLiteral("order")].toArray()) {
    const QString id = value.toString();
    if (id.isEmpty() || known.contains(id)) continue;
    if (rowCount() >= kMaxRestored) break;
    known.insert(id);
    rows_.push_back({id, !hidden.contains(id), false});
  }
  endResetModel();
  keys_ = nullptr;
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
      return row.shown && (!row.off || row.asked) ? Qt::Checked : Qt::Unchecked;
    case Qt::ToolTipRole:
      return toolTip(row);
    case kOffRole:
      return row.off;
    case Qt::ForegroundRole:
      return row.exists && !row.off ? QVariant()
                                    : QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
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
  Row& row = rows_[static_cast<std::size_t>(index.row())];
  row.shown = value.toInt() == Qt::Checked;
  if (row.off && row.shown) switchKey(index.row(), true);
  Q_EMIT dataChanged(index, index, {role});
  Q_EMIT shownChanged();
  return true;
}

Qt::ItemFlags DrawingsModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemNeverHasChildren;
}

/// If there are several kinds, drawings relative to the robot are marked as such.
QString DrawingsModel::title(const QString& id) const {
  const QString name = id.section(QLatin1Char('/'), 1);
  return id.startsWith(QLatin1String("robot/")) ? tr("%1 (robot)").arg(name) : name;
}

QString DrawingsModel::toolTip(const Row& row) const {
  QStringList lines{row.help.isEmpty() ? row.id : QStringLiteral("%1: %2").arg(row.id, row.help)};
  if (!row.refusal.isEmpty()) {
    lines << tr("The robot refused to draw it: %1").arg(row.refusal);
  } else if (row.asked) {
    lines << tr("The robot was asked to draw it");
  } else if (row.off) {
    lines << tr("The robot does not draw it; check it to switch it on");
  } else if (!row.exists) {
    lines << tr("No robot has drawn it yet");
  } else if (isDrawnInShadow(row.id)) {
    lines << tr("From a shadow solution: its lines are dashed");
  } else if (row.id.startsWith(QLatin1String(kStreams))) {
    lines << tr("The messages of this stream, in the frame that they name");
  }
  return lines.join(QLatin1Char('\n'));
}

DrawingsModel::Row* DrawingsModel::find(const QString& id) {
  const auto found = std::ranges::find(rows_, id, &Row::id);
  return found == rows_.end() ? nullptr : &*found;
}

void DrawingsModel::addIfNew(const QString& id, bool off) {
  if (find(id) != nullptr) return;
  beginInsertRows({}, rowCount(), rowCount());
  rows_.push_back({id, true, !off, off});
  endInsertRows();
  Q_EMIT shownChanged();
}

}  // namespace widgets
