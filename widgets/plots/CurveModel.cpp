// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/CurveModel.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>

#include "widgets/Theme.h"

namespace widgets {

using robotlink::Series;

int CurveModel::freeColor() const {
  int color = 0;
  while (
      std::any_of(curves_.begin(), curves_.end(), [&](const auto& curve) { return curve->color == color; }))
    ++color;
  return color;
}

bool CurveModel::add(const PlotSource& source) {
  const bool known = std::any_of(curves_.begin(), curves_.end(),
                                 [&](const auto& curve) { return curve->source() == source; });
  if (known || source.stream.empty() || !robotlink::PointFilter::parse(source.filter)) return false;
  const int color = freeColor();
  beginInsertRows({}, rowCount(), rowCount());
  curves_.push_back(std::make_shared<Curve>(source));
  curves_.back()->color = color;
  endInsertRows();
  return true;
}

void CurveModel::remove(int row) {
  beginRemoveRows({}, row, row);
  curves_.erase(curves_.begin() + row);
  endRemoveRows();
}

void CurveModel::clear() {
  beginResetModel();
  curves_.clear();
  endResetModel();
}

CurveModel::Curve::Curve(const PlotSource& source) : reader(source) {
  if (auto filter = robotlink::PointFilter::parse(source.filter)) liveFilter = logFilter = std::move(*filter);
}

std::shared_ptr<const Series> CurveModel::Curve::ofLog() const {
  if (!logged) return nullptr;
  if (!logFilter.isEmpty()) return filtered;
  return {logged, &logged->series};
}

bool CurveModel::Curve::takeLive(const robotlink::StreamStore& store) {
  const PlotReader::News news = reader.take(store);
  if (news.restarted) {
    live.clear();
    liveFilter.restart();
  }
  for (const auto& point : news.points) {
    if (const auto result = liveFilter.next(point)) live.append(*result);
  }
  return news.restarted || !news.points.empty();
}

bool CurveModel::Curve::takeLogged() {
  const std::size_t count = logged ? logged->series.size() : 0;
  const double since = count > 0 ? logged->series.front().time : 0;
  const bool isOther = count < loggedBefore || since != loggedSince;
  if (count == loggedBefore && !isOther) return false;
  if (!logFilter.isEmpty()) {
    if (isOther) {
      filtered->clear();
      logFilter.restart();
    }
    for (std::size_t i = isOther ? 0 : loggedBefore; i < count; ++i) {
      if (const auto result = logFilter.next(logged->series[i])) filtered->append(*result);
    }
  }
  loggedBefore = count;
  loggedSince = since;
  return true;
}

std::optional<double> CurveModel::Curve::last() const {
  if (liveFilter.isEmpty()) return reader.last();
  return live.empty() ? std::nullopt : std::optional(live.back().value);
}

QString CurveModel::Curve::unit() const {
  return QString::fromStdString(liveFilter.unit(reader.unit().toStdString()));
}

bool CurveModel::update(const robotlink::StreamStore& store) {
  bool news = false;
  for (auto& curve : curves_) {
    news = curve->takeLive(store) || news;
    news = curve->takeLogged() || news;
    curve->live.limit(kMaxBytes / curves_.size());
  }
  if (news) Q_EMIT dataChanged(index(0, kValue), index(rowCount() - 1, kAtCursor));
  return news;
}

void CurveModel::setOrigin(double seconds) {
  if (origin_ == seconds) return;
  origin_ = seconds;
  Q_EMIT headerDataChanged(Qt::Horizontal, kAtCursor, kAtCursor);
}

void CurveModel::setCursor(std::optional<double> time) {
  if (cursor_ == time) return;
  cursor_ = time;
  if (!curves_.empty()) Q_EMIT dataChanged(index(0, kAtCursor), index(rowCount() - 1, kAtCursor));
  Q_EMIT headerDataChanged(Qt::Horizontal, kAtCursor, kAtCursor);
}

std::optional<double> CurveModel::Curve::valueAt(double time) const {
  std::optional<Series::Point> newest;
  const auto log = ofLog();
  for (const Series* series : {log.get(), &live}) {
    const std::size_t after = series == nullptr ? 0 : series->firstAfter(time);
    if (after == 0) continue;
    const Series::Point point = (*series)[after - 1];
    if (!newest || point.time >= newest->time) newest = point;
  }
  return newest ? std::optional(newest->value) : std::nullopt;
}

std::optional<std::pair<double, double>> CurveModel::Curve::times() const {
  std::optional<std::pair<double, double>> times;
  const auto log = ofLog();
  for (const Series* series : {log.get(), &live}) {
    if (series == nullptr || series->empty()) continue;
    const std::pair here(series->front().time, series->back().time);
    times =
        times ? std::pair(std::min(times->first, here.first), std::max(times->second, here.second)) : here;
  }
  return times;
}

QString CurveModel::csv() const {
  QStringList header{QStringLiteral("time_s")};
  for (const auto& curve : curves_) header << QStringLiteral("\"%1\"").arg(curve->source().text());
  QString text = header.join(QLatin1Char(',')) + QLatin1Char('\n');
  std::vector<std::size_t> next(curves_.size());
  while (true) {
    std::optional<double> time;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const Series& points = curves_[i]->points();
      if (next[i] < points.size()) time = std::min(time.value_or(points[next[i]].time), points[next[i]].time);
    }
    if (!time) return text;
    text += QString::number(*time, 'f', 6);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const Series& points = curves_[i]->points();
      std::optional<double> value;
      for (; next[i] < points.size() && points[next[i]].time == *time; ++next[i])
        value = points[next[i]].value;
      text += QLatin1Char(',') + (value ? QString::number(*value, 'g', 12) : QString());
    }
    text += QLatin1Char('\n');
  }
}

int CurveModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(curves_.size());
}

int CurveModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant CurveModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Curve& curve = *curves_[static_cast<std::size_t>(index.row())];
  const auto last = curve.last();
  if (role == Qt::DecorationRole && index.column() == kName)
    return curveColor(curve.color, QGuiApplication::palette());
  if (role == Qt::TextAlignmentRole && (index.column() == kValue || index.column() == kAtCursor))
    return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole) {
    if (curve.logged && curve.logged->isCut)
      return tr("%1: only the first values of the log are shown, the others need too much memory")
          .arg(curve.source().text());
    return last ? curve.source().text() : tr("%1: no values yet").arg(curve.source().text());
  }
  if (role == Qt::ForegroundRole && !last) return colorOf(Meaning::kMuted, QGuiApplication::palette());
  if (role != Qt::DisplayRole) return {};
  if (index.column() == kName) return curve.source().text();
  if (index.column() == kUnit) return curve.unit();
  if (index.column() == kAtCursor) {
    const auto value = cursor_ ? curve.valueAt(*cursor_) : std::nullopt;
    return value ? QString::number(*value, 'g', 5) : QString();
  }
  return last ? QString::number(*last, 'g', 5) : QStringLiteral("–");
}

QVariant CurveModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kName:
      return tr("Curve");
    case kValue:
      return tr("Value");
    case kUnit:
      return tr("Unit");
    default:
      return cursor_ ? tr("At %1 s").arg(*cursor_ - origin_, 0, 'f', 3) : tr("At the cursor");
  }
}

}  // namespace widgets
