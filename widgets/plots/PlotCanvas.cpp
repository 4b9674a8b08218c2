// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotCanvas.h"

#include <qcustomplot.h>

#include <QApplication>
#include <QBoxLayout>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QSignalBlocker>
#include <QToolTip>

#include "robotlink/debugging/Streams.h"
#include "widgets/Theme.h"
#include "widgets/TypedStreams.h"
#include "widgets/plots/CurveModel.h"
#include "widgets/plots/PlotStyle.h"
#include "widgets/plots/PlotTreeModel.h"
#include "widgets/plots/SeriesGraph.h"
#include "widgets/plots/StateStrip.h"

namespace widgets {

namespace {

/// The end of an interval that has not ended, in s; a number that axes can compute with.
constexpr double kForever = 1e12;
/// The share of a curve's color where it is paler.
constexpr double kPale = 0.45;

/// The height of a strip, in lines of text, and the share of the plot that all may take.
constexpr double kStripLines = 1.35;
constexpr double kMaxForStrips = 0.6;
/// The width of the names beside strips, in pixels.
constexpr int kStripNameWidth = 120;

/// The gaps in a line: the connection to the robot (null: it is local) was lost, or values are missing.
std::vector<robotlink::LineGap> gapsIn(const CurveModel::Curve& curve, const robotlink::RemoteRobot* robot) {
  std::vector<robotlink::LineGap> gaps;
  if (robot != nullptr) gaps = robot->gaps;
  for (const MissingValues& missing : curve.missing)
    gaps.push_back({robotlink::Instant(robotlink::fromSeconds(missing.from)),
                    robotlink::Instant(robotlink::fromSeconds(missing.to))});
  return gaps;
}

}  // namespace

PlotCanvas::PlotCanvas(CurveModel& curves, QWidget* parent)
    : QWidget(parent), curves_(curves), plot_(new QCustomPlot(this)) {
  plot_->setObjectName(QStringLiteral("plotCanvas"));
  plot_->setAccessibleName(tr("Plot"));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(160, 100);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  plot_->setNoAntialiasingOnDrag(true);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->xAxis->setLabel(tr("time [s]"));
  QCPAxisRect& area = *plot_->axisRect();
  area.setupFullAxesBox(false);
  plot_->xAxis2->setTicks(false);
  area.setRangeDragAxes({plot_->xAxis}, {plot_->yAxis, plot_->yAxis2});
  createStrips();
  createItems();
  plot_->setAcceptDrops(true);
  plot_->installEventFilter(this);
  connectMouse();
  applyTheme();
}

void PlotCanvas::createItems() {
  markers_.emplace(*plot_);
  hatches_.emplace(*plot_);
  QCPAxisRect& area = *plot_->axisRect();
  mark_.emplace(area, *strips_);
  cursor_.emplace(area, *strips_);
  for (std::size_t i = 0; i < names_.size(); ++i) lines_.emplace_back(area, *strips_);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    names_[i] = new QCPItemText(plot_);
    names_[i]->setText(i == 0 ? tr("A") : tr("B"));
    names_[i]->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    names_[i]->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    names_[i]->setPadding({3, 1, 3, 1});
    names_[i]->setVisible(false);
  }
}

void PlotCanvas::connectMouse() {
  connect(plot_, &QCustomPlot::mouseWheel, this, [this](QWheelEvent* event) { prepareWheel(*event); });
  connect(plot_, &QCustomPlot::mousePress, this, [this](QMouseEvent* event) { pressed(*event); });
  connect(plot_, &QCustomPlot::mouseRelease, this, [this](QMouseEvent* event) { released(*event); });
  connect(plot_, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
    Q_EMIT cursorMoved(isInside(event->pos()) ? std::optional(plot_->xAxis->pixelToCoord(event->pos().x()))
                                              : std::nullopt);
  });
  for (const QCPAxis* axis : {plot_->xAxis, plot_->yAxis, plot_->yAxis2})
    connect(axis, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this, &PlotCanvas::rangeChanged);
}

void PlotCanvas::pressed(const QMouseEvent& event) {
  before_ = ranges();
  isWheeling_ = false;
  pressedAt_ = event.pos();
  plot_->axisRect()->setRangeZoomAxes({plot_->xAxis}, {plot_->yAxis, plot_->yAxis2});
  plot_->axisRect()->setRangeZoom(Qt::Horizontal | Qt::Vertical);
  const bool isBox = event.button() == Qt::RightButton;
  plot_->setSelectionRectMode(isBox ? QCP::srmZoom : QCP::srmNone);
}

void PlotCanvas::released(const QMouseEvent& event) {
  const bool isClick = event.button() == Qt::LeftButton &&
                       (event.pos() - pressedAt_).manhattanLength() < QApplication::startDragDistance();
  if (!isClick || !isInside(event.pos())) return;
  Q_EMIT cursorSet(event.modifiers().testFlag(Qt::ShiftModifier),
                   plot_->xAxis->pixelToCoord(event.pos().x()));
}

void PlotCanvas::prepareWheel(const QWheelEvent& event) {
  QCPAxisRect& area = *plot_->axisRect();
  const double x = event.position().x();
  QList<QCPAxis*> values{plot_->yAxis, plot_->yAxis2};
  if (x < area.left()) values = {plot_->yAxis};
  if (x > area.right()) values = {plot_->yAxis2};
  const bool isValues = event.modifiers().testFlag(Qt::ShiftModifier) || values.size() == 1;
  area.setRangeZoomAxes({plot_->xAxis}, values);
  area.setRangeZoom(isValues ? Qt::Vertical : Qt::Horizontal);
  if (!isWheeling_) before_ = ranges();
  isWheeling_ = true;
  Q_EMIT touched();
}

void PlotCanvas::rangeChanged() {
  const PlotRanges now = ranges();
  if (before_) history_.add(*std::exchange(before_, std::nullopt));
  Q_EMIT touched();
  Q_EMIT timesTouched(now.times.first, now.times.second);
}

PlotRanges PlotCanvas::ranges() const {
  const auto rangeOf = [](const QCPAxis& axis) { return std::pair(axis.range().lower, axis.range().upper); };
  return {rangeOf(*plot_->xAxis), rangeOf(*plot_->yAxis), rangeOf(*plot_->yAxis2)};
}

bool PlotCanvas::showRanges(const std::optional<PlotRanges>& ranges) {
  if (!ranges) return false;
  before_.reset();
  isWheeling_ = false;
  plot_->xAxis->setRange(ranges->times.first, ranges->times.second);
  plot_->yAxis->setRange(ranges->values.first, ranges->values.second);
  plot_->yAxis2->setRange(ranges->rightValues.first, ranges->rightValues.second);
  plot_->replot(QCustomPlot::rpQueuedReplot);
  return true;
}

void PlotCanvas::showTimes(double from, double to) {
  const QSignalBlocker quiet(plot_->xAxis);
  plot_->xAxis->setRange(from, to);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::setCursors(const std::optional<std::pair<double, double>>& times) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto time = times ? std::optional(i == 0 ? times->first : times->second) : std::nullopt;
    lines_[i].setTime(time);
    names_[i]->setVisible(time.has_value());
    if (time) names_[i]->position->setCoords(*time, 0);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::applyTheme() {
  const QPalette colors = palette();
  const QColor& text = colors.color(QPalette::Text);
  const QColor& base = colors.color(QPalette::Base);
  for (QCPAxisRect* area : {plot_->axisRect(), strips_}) stylePlot(*plot_, *area, colors, font());
  cursor_->setPen(QPen(mixed(base, text, 0.5), 0));
  mark_->setPen(QPen(colorOf(Meaning::kBad, colors), 0, Qt::DashLine));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].setPen(QPen(text, 0, i == 0 ? Qt::SolidLine : Qt::DashDotLine));
    names_[i]->setColor(text);
    names_[i]->setBrush(base);
    names_[i]->setFont(font());
  }
  markers_->remake();
  gaps_.clear();  // they are shaded again in other colors
  stripNames_.reset();
  showGaps();
  matchGraphs();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::matchGraphs() {
  const auto& curves = curves_.curves();
  while (graphs_.size() > 2 * curves.size()) {
    plot_->removePlottable(graphs_.back());
    graphs_.pop_back();
  }
  while (graphs_.size() < 2 * curves.size()) graphs_.push_back(new SeriesGraph(plot_->xAxis, plot_->yAxis));
  const bool isRight = std::ranges::any_of(curves, [](const auto& curve) { return curve->isRight; });
  plot_->yAxis2->setTicks(isRight);
  plot_->yAxis2->setTickLabels(isRight);
  const QPalette colors = palette();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& curve = curves[i];
    const QColor color = curveColor(curve->color, colors);
    const QColor pale = mixed(colors.color(QPalette::Base), color, kPale);
    const auto& streams = curve->reader.streams();
    const auto robot =
        robots_.find(streams.empty() ? std::string() : robotlink::streams::robotOf(streams.front()));
    const bool isHere = !curve->across && !curve->isStrip();
    SeriesGraph &logged = *graphs_[2 * i], &live = *graphs_[2 * i + 1];
    for (SeriesGraph* graph : {&logged, &live})
      graph->setValueAxis(curve->isRight ? plot_->yAxis2 : plot_->yAxis);
    logged.setPen(QPen(curve->isRecomputed ? pale : color, 1));
    logged.setSeries(isHere ? curve->ofLog() : nullptr);
    live.setPen(QPen(color, 1));
    live.setSeries(isHere ? std::shared_ptr<const robotlink::Series>(curve, &curve->live) : nullptr);
    live.setGaps(gapsIn(*curve, robot == robots_.end() ? nullptr : &robot->second));
  }
}

void PlotCanvas::createStrips() {
  strips_ = new QCPAxisRect(plot_, false);
  QCPAxis& time = *strips_->addAxis(QCPAxis::atBottom);
  QCPAxis& rows = *strips_->addAxis(QCPAxis::atLeft);
  for (QCPAxis* axis : {&time, &rows}) axis->setLayer(QStringLiteral("axes"));
  for (QCPAxis* axis : {&time, &rows}) axis->grid()->setLayer(QStringLiteral("grid"));
  rows.setRangeReversed(true);
  rows.setTickPen(Qt::NoPen);
  rows.setSubTicks(false);
  rows.grid()->setVisible(false);
  time.setLabel(tr("time [s]"));
  plot_->plotLayout()->addElement(1, 0, strips_);
  plot_->plotLayout()->setRowSpacing(0);
  auto* sides = new QCPMarginGroup(plot_);
  for (QCPAxisRect* area : {plot_->axisRect(), strips_})
    area->setMarginGroup(QCP::msLeft | QCP::msRight, sides);
  strips_->setRangeDragAxes(QList<QCPAxis*>{plot_->xAxis}, {});
  strips_->setRangeZoomAxes(QList<QCPAxis*>{plot_->xAxis}, {});
  strips_->setRangeDrag(Qt::Horizontal);
  strips_->setRangeZoom(Qt::Horizontal);
  strips_->setSizeConstraintRect(QCPLayoutElement::scrInnerRect);
  connect(plot_, &QCustomPlot::beforeReplot, this,
          [this] { strips_->axis(QCPAxis::atBottom)->setRange(plot_->xAxis->range()); });
  layOutStrips({});
}

void PlotCanvas::layOutStrips(const QStringList& names) {
  constexpr int kUnbounded = 16'777'215;  // QWIDGETSIZE_MAX
  const bool isShown = !names.isEmpty();
  const double row = kStripLines * fontMetrics().height();
  const int height =
      static_cast<int>(std::min(row * static_cast<double>(names.size()), kMaxForStrips * plot_->height()));
  strips_->setMinimumSize(0, height);
  strips_->setMaximumSize(kUnbounded, height);
  if (names == stripNames_) return;
  stripNames_ = names;
  strips_->setVisible(isShown);
  strips_->setAutoMargins(isShown ? QCP::msAll : QCP::msLeft | QCP::msRight);
  strips_->setMinimumMargins(isShown ? QMargins(0, 4, 0, 0) : QMargins());
  if (!isShown) strips_->setMargins({});
  // The time axis is labeled once, at the bottom.
  plot_->xAxis->setTickLabels(!isShown);
  plot_->xAxis->setLabel(isShown ? QString() : tr("time [s]"));
  const auto ticks = QSharedPointer<QCPAxisTickerText>::create();
  for (int i = 0; i < names.size(); ++i)
    ticks->addTick(i + 0.5, fontMetrics().elidedText(names[i], Qt::ElideLeft, kStripNameWidth));
  QCPAxis& rows = *strips_->axis(QCPAxis::atLeft);
  rows.setTicker(ticks);
  rows.setRange(0, std::max<int>(1, names.size()));
}

void PlotCanvas::matchStrips() {
  std::vector<std::shared_ptr<CurveModel::Curve>> strips;
  QStringList names;
  double end = -kForever;
  for (const auto& curve : curves_.curves()) {
    if (const auto times = curve->times()) end = std::max(end, times->second);
    if (!curve->isStrip()) continue;
    strips.push_back(curve);
    names << curve->title;
  }
  for (; stripGraphs_.size() > strips.size(); stripGraphs_.pop_back())
    plot_->removePlottable(stripGraphs_.back());
  while (stripGraphs_.size() < strips.size())
    stripGraphs_.push_back(new StateStrip(strips_->axis(QCPAxis::atBottom), strips_->axis(QCPAxis::atLeft)));
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const auto& curve = strips[i];
    StateStrip& strip = *stripGraphs_[i];
    const auto row = static_cast<double>(i);
    const std::shared_ptr<const robotlink::Series> live(curve, &curve->live);
    std::vector<StateStrip::Part> parts{{curve->isLogged() ? curve->ofLog() : live, row, row + 1}};
    // Recomputed values are shown below the logged ones.
    if (curve->isRecomputed && curve->ofLog())
      parts = {{curve->ofLog(), row, row + 0.5}, {live, row + 0.5, row + 1}};
    strip.setParts(std::move(parts));
    strip.setNames(std::shared_ptr<const StateNames>(curve, &curve->names));
    strip.setEnd(end);
    auto gaps = gapsOf(curve->reader.streams());
    for (const MissingValues& missing : curve->missing) gaps.emplace_back(missing.from, missing.to);
    strip.setGaps(std::move(gaps));
    strip.setColors(palette(), font());
  }
  layOutStrips(names);
}

bool PlotCanvas::isInside(const QPoint& point) const {
  return plot_->axisRect()->rect().contains(point) || (strips_->visible() && strips_->rect().contains(point));
}

QString PlotCanvas::toolTipAt(const QPoint& point) const {
  constexpr int kReach = 4;  // pixels
  if (!isInside(point)) return {};
  const double time = plot_->xAxis->pixelToCoord(point.x());
  if (plot_->axisRect()->rect().contains(point))
    return markers_->textsNear(time, plot_->xAxis->pixelToCoord(point.x() + kReach) - time)
        .join(QLatin1Char('\n'));
  const auto row = static_cast<std::size_t>(strips_->axis(QCPAxis::atLeft)->pixelToCoord(point.y()));
  std::vector<const CurveModel::Curve*> strips;
  for (const auto& curve : curves_.curves()) {
    if (curve->isStrip()) strips.push_back(curve.get());
  }
  if (row >= strips.size()) return {};
  const auto value = strips[row]->valueAt(time);
  return tr("%1: %2").arg(strips[row]->source().text(), value ? strips[row]->words(*value) : tr("not known"));
}

void PlotCanvas::showToolTip(const QPoint& point, const QPoint& global) {
  const QString text = toolTipAt(point);
  text.isEmpty() ? QToolTip::hideText() : QToolTip::showText(global, text, plot_);
}

void PlotCanvas::refresh(bool follow, double end, double length, const RemoteRobots& robots) {
  robots_ = robots;
  matchGraphs();
  matchStrips();
  showGaps();
  if (follow) {
    const QSignalBlocker times(plot_->xAxis), left(plot_->yAxis), right(plot_->yAxis2);
    length > 0 ? plot_->xAxis->setRange(end - length, end) : fitTimes();
    fitValues();
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

std::vector<std::pair<double, double>> PlotCanvas::gapsOf(const std::vector<std::string>& streams) const {
  std::vector<std::pair<double, double>> gaps;
  for (const std::string& stream : streams) {
    const auto robot = robots_.find(robotlink::streams::robotOf(stream));
    if (robot == robots_.end()) continue;
    for (const robotlink::LineGap& gap : robot->second.gaps) {
      const std::pair here(robotlink::seconds(gap.from), gap.to ? robotlink::seconds(*gap.to) : kForever);
      if (std::ranges::find(gaps, here) == gaps.end()) gaps.push_back(here);
    }
  }
  return gaps;
}

/// Shades the times without messages of a robot that has a curve.
void PlotCanvas::showGaps() {
  std::vector<std::string> streams;
  for (const auto& curve : curves_.curves())
    streams.insert(streams.end(), curve->reader.streams().begin(), curve->reader.streams().end());
  const auto gaps = gapsOf(streams);
  if (gaps == gaps_) return;
  gaps_ = gaps;
  for (QCPItemRect* shade : shades_) plot_->removeItem(shade);
  shades_.clear();
  const QPalette colors = palette();
  const QColor shaded = mixed(colors.color(QPalette::Base), colorOf(Meaning::kMuted, colors), 0.25);
  for (const auto& [from, to] : gaps_) {
    auto* shade = new QCPItemRect(plot_);
    shade->setLayer(QStringLiteral("background"));
    for (QCPItemPosition* corner : {shade->topLeft, shade->bottomRight})
      corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
    shade->topLeft->setCoords(from, 0);
    shade->bottomRight->setCoords(to, 1);
    shade->setPen(Qt::NoPen);
    shade->setBrush(shaded);
    shades_.push_back(shade);
  }
}

void PlotCanvas::setMissing(std::vector<MissingValues> missing) {
  hatches_->set(std::move(missing));
}

void PlotCanvas::fitValues() {
  fitValues(*plot_->yAxis);
  fitValues(*plot_->yAxis2);
}

void PlotCanvas::fitValues(QCPAxis& axis) {
  robotlink::Series::Extent all;
  const QCPRange times = plot_->xAxis->range();
  const auto add = [&](const robotlink::Series& series) {
    all.add(series.extent(series.firstFrom(times.lower), series.firstAfter(times.upper)));
  };
  for (const auto& curve : curves_.curves()) {
    if (curve->isRight != (&axis == plot_->yAxis2) || curve->across || curve->isStrip()) continue;
    add(curve->live);
    if (const auto log = curve->ofLog()) add(*log);
  }
  showExtent(axis, all.min, all.max);
}

void PlotCanvas::fitTimes() {
  std::optional<QCPRange> all;
  for (const auto& curve : curves_.curves()) {
    const auto times = curve->times();
    if (!times) continue;
    const QCPRange here(times->first, times->second);
    all = all ? all->expanded(here) : here;
  }
  for (const MissingValues& missing : hatches_->missing()) {
    if (all) all = all->expanded(QCPRange(missing.from, missing.to));
  }
  if (all && all->size() > 0) plot_->xAxis->setRange(*all);
}

void PlotCanvas::fit() {
  before_ = ranges();
  isWheeling_ = false;
  fitTimes();
  fitValues();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::setOrigin(double seconds) {
  if (plot_->xAxis->ticker()->tickOrigin() == seconds) return;
  for (QCPAxis* axis : {plot_->xAxis, strips_->axis(QCPAxis::atBottom)})
    axis->setTicker(QSharedPointer<TimeTicker>::create(seconds));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::setMark(std::optional<double> time) {
  mark_->setTime(time);
}

void PlotCanvas::setMarkers(std::vector<PlotMarker> markers) {
  if (markers_->set(std::move(markers))) plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::setTextMarks(std::vector<PlotMarker> marks) {
  if (markers_->setLines(std::move(marks))) plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::setCursorLine(std::optional<double> time) {
  cursor_->setTime(time);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

std::pair<double, double> PlotCanvas::shownTimes() const {
  return {plot_->xAxis->range().lower, plot_->xAxis->range().upper};
}

void PlotCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) applyTheme();
  QWidget::changeEvent(event);
}

bool PlotCanvas::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    showToolTip(help->pos(), help->globalPos());
    return true;
  }
  if (event->type() == QEvent::Leave) Q_EMIT cursorMoved(std::nullopt);
  const QString type = QString::fromLatin1(PlotTreeModel::kMimeType);
  if (event->type() == QEvent::DragEnter) {
    auto* drag = static_cast<QDragEnterEvent*>(event);
    if (drag->mimeData()->hasFormat(type)) drag->acceptProposedAction();
    return true;
  }
  if (event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    Q_EMIT sourcesDropped(
        QString::fromUtf8(drop->mimeData()->data(type)).split(QLatin1Char('\n'), Qt::SkipEmptyParts));
    drop->acceptProposedAction();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace widgets
