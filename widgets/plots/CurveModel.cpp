// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/CurveModel.h"

#include <QGuiApplication>
#include <QPalette>
#include <QRegularExpression>
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "widgets/Theme.h"

namespace widgets {

using robotlink::Series;

namespace {

/// A value of a port in the text of a source or in an expression, as portField() writes it.
const QString kPortValue =
    QStringLiteral("ports(?:: |\\.)readings\\[port=\"([^\"]*)\"\\]\\.values\\[(\\d+)\\]");

/// The maximum number of points of a curve; beyond it, the older half is dropped.
constexpr std::ptrdiff_t kMaxHeld = 4'000'000;

QString csvCell(const CurveModel::Curve& curve, double value) {
  constexpr int kDigits = 12;
  if (curve.names.isEmpty() || !curve.source().filter.empty()) return QString::number(value, 'g', kDigits);
  QString name = curve.names.name(value);
  return QStringLiteral("\"%1\"").arg(name.replace(QLatin1String("\""), QLatin1String("\"\"")));
}

}  // namespace

std::vector<QString> curveTitles(const std::vector<QString>& texts) {
  const QRegularExpression value(kPortValue);
  std::map<QString, std::set<QString>> shown;  // the numbers of the values by sensors
  for (const QString& text : texts) {
    for (auto found = value.globalMatch(text); found.hasNext();) {
      const auto match = found.next();
      shown[match.captured(1)].insert(match.captured(2));
    }
  }
  std::vector<QString> titles;
  for (const QString& text : texts) {
    QString title;
    int end = 0;
    for (auto found = value.globalMatch(text); found.hasNext();) {
      const auto match = found.next();
      const QString sensor = match.captured(1), number = match.captured(2);
      const bool isOne = shown[sensor].size() == 1 && number == QLatin1String("0");
      title += text.mid(end, match.capturedStart() - end) + sensor;
      if (!isOne) title += QStringLiteral(" [%1]").arg(number);
      end = match.capturedEnd();
    }
    titles.push_back(title + text.mid(end));
  }
  return titles;
}

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
  if (known || !completed(source, {}, {}, {})) return false;
  const int color = freeColor();
  beginInsertRows({}, rowCount(), rowCount());
  curves_.push_back(std::make_shared<Curve>(source));
  curves_.back()->color = color;
  nameCurves();
  endInsertRows();
  Q_EMIT dataChanged(index(0, kName), index(rowCount() - 1, kName));
  return true;
}

void CurveModel::nameCurves() {
  std::vector<QString> texts;
  for (const auto& curve : curves_) texts.push_back(curve->source().text());
  const auto titles = curveTitles(texts);
  for (std::size_t i = 0; i < curves_.size(); ++i) curves_[i]->title = titles[i];
}

void CurveModel::remove(int row) {
  beginRemoveRows({}, row, row);
  curves_.erase(curves_.begin() + row);
  nameCurves();
  endRemoveRows();
  if (!curves_.empty()) Q_EMIT dataChanged(index(0, kName), index(rowCount() - 1, kName));
}

void CurveModel::clear() {
  beginResetModel();
  curves_.clear();
  endResetModel();
}

CurveModel::Curve::Curve(const PlotSource& source) : reader(source) {
  if (auto filter = robotlink::PointFilter::parse(source.filter)) liveFilter = logFilter = std::move(*filter);
  if (!source.across.empty())
    across = std::make_unique<Curve>(PlotSource::fromText(QString::fromStdString(source.across)));
}

QString CurveModel::Curve::words(double value) const {
  return source().filter.empty() && !names.isEmpty() ? names.name(value) : QString::number(value, 'g', 5);
}

std::size_t CurveModel::Curve::bytes() const {
  return live.bytes() + filtered->bytes() + (across ? across->bytes() : 0);
}

std::vector<CurveModel::Curve*> CurveModel::Curve::parts() {
  std::vector<Curve*> all{this};
  if (across) all.push_back(across.get());
  return all;
}

std::vector<const CurveModel::Curve*> CurveModel::Curve::parts() const {
  std::vector<const Curve*> all{this};
  if (across) all.push_back(across.get());
  return all;
}

std::shared_ptr<const Series> CurveModel::Curve::ofLog() const {
  if (!logged) return nullptr;
  if (!logFilter.isEmpty()) return filtered;
  return {logged, &logged->series};
}

void CurveModel::Curve::hold(const robotlink::StreamStore& store) {
  held.append(reader.take(store));
  if (std::ssize(held.points) <= kMaxHeld) return;
  held.points.erase(held.points.begin(), held.points.end() - kMaxHeld / 2);
  held.missed = true;
}

bool CurveModel::Curve::takeLive(const robotlink::StreamStore& store, bool afresh) {
  PlotReader::News news = std::exchange(held, {});
  news.append(reader.take(store));
  if (afresh && news.missed) news.restarted = true;
  problem = reader.problem(store);
  if (names.size() < reader.names().size()) names.merge(reader.names());
  if (news.restarted) {
    live.clear();
    liveFilter.restart();
    past.restart();
  }
  for (const auto& point : news.points) {
    past.note(point, !liveFilter.isEmpty());
    if (const auto result = liveFilter.next(point)) live.append(*result);
  }
  const auto& read = past.values();
  if (read && names.size() < read->names.size()) names.merge(read->names);
  const bool isMerged = past.mergeInto(live, liveFilter);
  return isMerged || news.restarted || !news.points.empty();
}

bool CurveModel::Curve::takeLogged(std::size_t bytes) {
  if (logged && names.size() < logged->names.size()) names.merge(logged->names);
  const std::size_t count = logged ? logged->series.size() : 0;
  const double since = count > 0 ? logged->series.front().time : 0;
  const bool isOther = count < loggedBefore || since != loggedSince;
  if (count == loggedBefore && !isOther) return false;
  if (!logFilter.isEmpty()) {
    if (isOther) {
      filtered->clear();
      logFilter.restart();
      isFilteredCut = false;
    }
    for (std::size_t i = isOther ? 0 : loggedBefore; i < count && !isFilteredCut; ++i) {
      isFilteredCut = i % robotlink::Series::kBlock == 0 && filtered->bytes() > bytes;
      if (const auto result = logFilter.next(logged->series[i])) filtered->append(*result);
    }
  }
  loggedBefore = count;
  loggedSince = since;
  return true;
}

std::optional<double> CurveModel::Curve::last() const {
  if (liveFilter.isEmpty() && held.points.empty()) return reader.last();
  return live.empty() ? std::nullopt : std::optional(live.back().value);
}

QString CurveModel::Curve::unit() const {
  return QString::fromStdString(liveFilter.unit(reader.unit().toStdString()));
}

void CurveModel::hold(const robotlink::StreamStore& store) {
  for (const auto& curve : curves_) {
    for (Curve* part : curve->parts()) part->hold(store);
  }
}

bool CurveModel::update(const robotlink::StreamStore& store, bool afresh) {
  std::size_t count = 0;
  for (const auto& curve : curves_) count += curve->parts().size();
  const std::size_t share = kMaxBytes / std::max<std::size_t>(count, 1);
  bool news = false;
  for (const auto& curve : curves_) {
    for (Curve* part : curve->parts()) {
      news = part->takeLive(store, afresh) || news;
      news = part->takeLogged(share / 2) || news;
      part->live.limit(share - std::min(part->filtered->bytes(), share / 2));
    }
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
  std::vector<const Curve*> columns;
  QStringList header{QStringLiteral("time_s")};
  for (const auto& curve : curves_) {
    for (const Curve* part : curve->parts()) columns.push_back(part);
  }
  for (const Curve* column : columns)
    header << QStringLiteral("\"%1\"").arg(
        column->source().text().replace(QLatin1String("\""), QLatin1String("\"\"")));
  QString text = header.join(QLatin1Char(',')) + QLatin1Char('\n');
  std::vector<std::size_t> next(columns.size());
  while (true) {
    std::optional<double> time;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Series& points = columns[i]->points();
      if (next[i] < points.size()) time = std::min(time.value_or(points[next[i]].time), points[next[i]].time);
    }
    if (!time) return text;
    text += QString::number(*time - origin_, 'f', 6);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Series& points = columns[i]->points();
      std::optional<double> value;
      for (; next[i] < points.size() && points[next[i]].time == *time; ++next[i])
        value = points[next[i]].value;
      text += QLatin1Char(',') + (value ? csvCell(*columns[i], *value) : QString());
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

QString CurveModel::toolTip(const Curve& curve) const {
  const QString name = curve.source().text();
  const bool isLogged = curve.logged && !curve.ofLog()->empty();
  if ((curve.logged && curve.logged->isCut) || curve.isFilteredCut)
    return tr("%1: only the first values of the log are shown, the others need too much memory").arg(name);
  if (curve.logged && !curve.logged->problem.isEmpty()) return tr("%1: %2").arg(name, curve.logged->problem);
  if (!curve.problem.isEmpty() && !isLogged) return tr("%1: %2").arg(name, curve.problem);
  return curve.last() || isLogged ? name : tr("%1: no values yet").arg(name);
}

QVariant CurveModel::text(const Curve& curve, int column) const {
  if (column == kName) return curve.title;
  if (column == kUnit) return curve.unit();
  const auto words = [](const Curve& of, std::optional<double> value) {
    return value ? of.words(*value) : QStringLiteral("–");
  };
  const auto both = [&](const auto& valueOf) {
    const QString own = words(curve, valueOf(curve));
    return curve.across ? tr("%1; %2").arg(words(*curve.across, valueOf(*curve.across)), own) : own;
  };
  if (column == kAtCursor)
    return cursor_ ? both([this](const Curve& of) { return of.valueAt(*cursor_); }) : QString();
  const bool isMissing = !curve.problem.isEmpty() && !curve.last();
  const bool isLogged = curve.logged && !curve.ofLog()->empty();
  if (isMissing) return isLogged ? tr("in the log only") : tr("missing");
  return both([](const Curve& of) { return of.last(); });
}

QVariant CurveModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Curve& curve = *curves_[static_cast<std::size_t>(index.row())];
  const bool isNumber = index.column() == kValue || index.column() == kAtCursor;
  switch (role) {
    case Qt::DecorationRole:
      return index.column() == kName ? QVariant(curveColor(curve.color, QGuiApplication::palette()))
                                     : QVariant();
    case Qt::TextAlignmentRole:
      return isNumber ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case Qt::ToolTipRole:
      return toolTip(curve);
    case Qt::ForegroundRole:
      return curve.last() ? QVariant() : QVariant(colorOf(Meaning::kMuted, QGuiApplication::palette()));
    case Qt::DisplayRole:
      return text(curve, index.column());
    default:
      return {};
  }
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
