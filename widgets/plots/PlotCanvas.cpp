// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotCanvas.h"

#include <qcustomplot.h>

#include <QApplication>
#include <QBoxLayout>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QSignalBlocker>
#include <QSvgGenerator>

#include "widgets/Theme.h"
#include "widgets/TypedStreams.h"
#include "widgets/plots/CurveModel.h"
#include "widgets/plots/PlotTreeModel.h"
#include "widgets/plots/SeriesGraph.h"

namespace widgets {

namespace {

/// The end of what lasts, in s; a number that axes can compute with.
constexpr double kForever = 1e12;
/// The resolution of pictures, compared with the screen's.
constexpr double kScale = 2;
/// The share of a curve's color where it is paler.
constexpr double kPale = 0.45;

/// Ticks at round numbers of seconds since an origin.
class TimeTicker final : public QCPAxisTicker {
 public:
  explicit TimeTicker(double origin) { setTickOrigin(origin); }

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return QCPAxisTicker::getTickLabel(tick - tickOrigin(), locale, format, precision);
  }
};

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
  createItems();
  plot_->setAcceptDrops(true);
  plot_->installEventFilter(this);
  connectMouse();
  applyTheme();
}

void PlotCanvas::createItems() {
  for (QCPItemStraightLine** line : {&mark_, &cursor_, lines_.data(), lines_.data() + 1}) {
    *line = new QCPItemStraightLine(plot_);
    (*line)->setVisible(false);
  }
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
    const bool inside = plot_->axisRect()->rect().contains(event->pos());
    Q_EMIT cursorMoved(inside ? std::optional(plot_->xAxis->pixelToCoord(event->pos().x())) : std::nullopt);
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
  if (!isClick || !plot_->axisRect()->rect().contains(event.pos())) return;
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
    lines_[i]->setVisible(times.has_value());
    names_[i]->setVisible(times.has_value());
    if (!times) continue;
    const double time = i == 0 ? times->first : times->second;
    lines_[i]->point1->setCoords(time, 0);
    lines_[i]->point2->setCoords(time, 1);
    names_[i]->position->setCoords(time, 0);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::applyTheme() {
  const QPalette colors = palette();
  const QColor& text = colors.color(QPalette::Text);
  const QColor& base = colors.color(QPalette::Base);
  plot_->setBackground(base);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis, plot_->xAxis2, plot_->yAxis2}) {
    axis->setBasePen(mixed(base, text, 0.6));
    axis->setTickPen(mixed(base, text, 0.6));
    axis->setSubTickPen(mixed(base, text, 0.3));
    axis->setTickLabelColor(text);
    axis->setLabelColor(text);
    axis->setTickLabelFont(font());
    axis->setLabelFont(font());
    axis->grid()->setPen(QPen(mixed(base, text, 0.18), 0, Qt::DotLine));
    axis->grid()->setZeroLinePen(QPen(mixed(base, text, 0.35), 0));
  }
  cursor_->setPen(QPen(mixed(base, text, 0.5), 0));
  mark_->setPen(QPen(colorOf(Meaning::kBad, colors), 0, Qt::DashLine));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i]->setPen(QPen(text, 0, i == 0 ? Qt::SolidLine : Qt::DashDotLine));
    names_[i]->setColor(text);
    names_[i]->setBrush(base);
    names_[i]->setFont(font());
  }
  markers_.remake();
  gaps_.clear();  // they are shaded again in other colors
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
    const auto robot = robots_.find(robotPart(curve->source().stream));
    SeriesGraph &logged = *graphs_[2 * i], &live = *graphs_[2 * i + 1];
    for (SeriesGraph* graph : {&logged, &live})
      graph->setValueAxis(curve->isRight ? plot_->yAxis2 : plot_->yAxis);
    logged.setPen(QPen(curve->isRecomputed ? pale : color, 1));
    logged.setSeries(curve->ofLog());
    live.setPen(QPen(color, 1));
    live.setSeries(std::shared_ptr<const robotlink::Series>(curve, &curve->live));
    live.setGaps(robot == robots_.end() ? std::vector<robotlink::LineGap>() : robot->second.gaps);
  }
}

void PlotCanvas::refresh(bool follow, double end, double length, const RemoteRobots& robots) {
  robots_ = robots;
  matchGraphs();
  showGaps();
  if (follow) {
    const QSignalBlocker times(plot_->xAxis), left(plot_->yAxis), right(plot_->yAxis2);
    length > 0 ? plot_->xAxis->setRange(end - length, end) : fitTimes();
    fitValues();
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

/// Shades the times in which nothing was heard of a robot that has a curve.
void PlotCanvas::showGaps() {
  std::vector<std::pair<double, double>> gaps;
  for (const auto& curve : curves_.curves()) {
    const auto robot = robots_.find(robotPart(curve->source().stream));
    if (robot == robots_.end()) continue;
    for (const robotlink::LineGap& gap : robot->second.gaps) {
      const double from = robotlink::seconds(gap.from), to = gap.to ? robotlink::seconds(*gap.to) : kForever;
      const auto known = std::ranges::find(gaps, std::pair(from, to));
      if (known == gaps.end()) gaps.emplace_back(from, to);
    }
  }
  if (gaps == gaps_) return;
  gaps_ = std::move(gaps);
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
    if (curve->isRight != (&axis == plot_->yAxis2)) continue;
    add(curve->live);
    if (const auto log = curve->ofLog()) add(*log);
  }
  if (all.isEmpty()) return;
  const double size = all.max - all.min, center = (all.min + all.max) / 2;
  const double margin = size > 0 ? size * 0.06 : std::max(1e-3, std::abs(center) * 0.1);
  axis.setRange(all.min - margin, all.max + margin);
}

void PlotCanvas::fitTimes() {
  std::optional<QCPRange> all;
  for (const auto& curve : curves_.curves()) {
    const auto times = curve->times();
    if (!times) continue;
    const QCPRange here(times->first, times->second);
    all = all ? all->expanded(here) : here;
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
  plot_->xAxis->setTicker(QSharedPointer<TimeTicker>::create(seconds));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::setMark(std::optional<double> time) {
  mark_->setVisible(time.has_value());
  if (!time) return;
  mark_->point1->setCoords(*time, 0);
  mark_->point2->setCoords(*time, 1);
}

void PlotCanvas::setMarkers(std::vector<PlotMarker> markers) {
  if (markers_.set(std::move(markers))) plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::setCursorLine(std::optional<double> time) {
  cursor_->setVisible(time.has_value());
  if (time) {
    cursor_->point1->setCoords(*time, 0);
    cursor_->point2->setCoords(*time, 1);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

std::pair<double, double> PlotCanvas::shownTimes() const {
  return {plot_->xAxis->range().lower, plot_->xAxis->range().upper};
}

bool PlotCanvas::savePng(const QString& file) {
  return plot_->savePng(file, 0, 0, kScale);
}

bool PlotCanvas::saveSvg(const QString& file) {
  QSvgGenerator svg;
  svg.setFileName(file);
  svg.setSize(plot_->size());
  svg.setViewBox(plot_->rect());
  QCPPainter painter;
  if (!painter.begin(&svg)) return false;
  plot_->toPainter(&painter);
  return painter.end();
}

QPixmap PlotCanvas::picture() {
  return plot_->toPixmap(0, 0, kScale);
}

void PlotCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) applyTheme();
  QWidget::changeEvent(event);
}

bool PlotCanvas::eventFilter(QObject* watched, QEvent* event) {
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
