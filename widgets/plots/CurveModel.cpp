// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/CurveModel.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <map>

#include "widgets/Theme.h"

namespace widgets {

int CurveModel::freeColor() const {
  int color = 0;
  while (
      std::any_of(curves_.begin(), curves_.end(), [&](const auto& curve) { return curve->color == color; }))
    ++color;
  return color;
}

bool CurveModel::add(const PlotSource& source) {
  const bool known = std::any_of(curves_.begin(), curves_.end(),
                                 [&](const auto& curve) { return curve->series.source() == source; });
  if (known || source.stream.empty()) return false;
  const int color = freeColor();
  beginInsertRows({}, rowCount(), rowCount());
  curves_.push_back(std::make_unique<Curve>(source));
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

bool CurveModel::update(const robotlink::StreamStore& store) {
  bool news = false;
  for (auto& curve : curves_) {
    PlotSeries::News added = curve->series.take(store);
    if (added.restarted) {
      curve->points.clear();
      curve->taken = 0;
      curve->restarted = true;
    }
    if (added.points.empty() && !added.restarted) continue;
    news = true;
    curve->points.insert(curve->points.end(), added.points.begin(), added.points.end());
    while (curve->points.size() > 1 && (curve->points.size() > kMaxPoints ||
                                        curve->points.back().time - curve->points.front().time > kHistory)) {
      curve->points.pop_front();
      if (curve->taken > 0) --curve->taken;
    }
  }
  if (news) Q_EMIT dataChanged(index(0, kValue), index(rowCount() - 1, kAtCursor));
  return news;
}

void CurveModel::setCursor(std::optional<double> time) {
  if (cursor_ == time) return;
  cursor_ = time;
  if (!curves_.empty()) Q_EMIT dataChanged(index(0, kAtCursor), index(rowCount() - 1, kAtCursor));
  Q_EMIT headerDataChanged(Qt::Horizontal, kAtCursor, kAtCursor);
}

std::optional<double> CurveModel::atCursor(const Curve& curve) const {
  if (!cursor_) return std::nullopt;
  const auto after = std::ranges::upper_bound(curve.points, *cursor_, {}, &PlotSeries::Point::time);
  return after == curve.points.begin() ? std::nullopt : std::optional(std::prev(after)->value);
}

QString CurveModel::csv() const {
  std::map<double, std::map<std::size_t, double>> rows;
  QStringList header{QStringLiteral("time_s")};
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    header << QStringLiteral("\"%1\"").arg(curves_[i]->series.source().text());
    for (const auto& point : curves_[i]->points) rows[point.time][i] = point.value;
  }
  QString text = header.join(QLatin1Char(',')) + QLatin1Char('\n');
  for (const auto& [time, values] : rows) {
    text += QString::number(time, 'f', 6);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const auto value = values.find(i);
      text +=
          QLatin1Char(',') + (value == values.end() ? QString() : QString::number(value->second, 'g', 12));
    }
    text += QLatin1Char('\n');
  }
  return text;
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
  const auto last = curve.series.last();
  if (role == Qt::DecorationRole && index.column() == kName)
    return curveColor(curve.color, QGuiApplication::palette());
  if (role == Qt::TextAlignmentRole && (index.column() == kValue || index.column() == kAtCursor))
    return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole) {
    return last ? curve.series.source().text() : tr("%1: no values yet").arg(curve.series.source().text());
  }
  if (role == Qt::ForegroundRole && !last) return colorOf(Meaning::kMuted, QGuiApplication::palette());
  if (role != Qt::DisplayRole) return {};
  if (index.column() == kName) return curve.series.source().text();
  if (index.column() == kUnit) return curve.series.unit();
  if (index.column() == kAtCursor) {
    const auto value = atCursor(curve);
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
      return cursor_ ? tr("At %1 s").arg(*cursor_, 0, 'f', 3) : tr("At the cursor");
  }
}

}  // namespace widgets
