// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotCanvas.h"

#include <qcustomplot.h>

#include <QBoxLayout>
#include <QDragEnterEvent>
#include <QMimeData>

#include "widgets/Theme.h"
#include "widgets/TypedStreams.h"
#include "widgets/plots/CurveModel.h"
#include "widgets/plots/PlotTreeModel.h"
#include "widgets/plots/SeriesGraph.h"

namespace widgets {

namespace {

/// The end of what lasts, in s; a number that axes can compute with.
constexpr double kForever = 1e12;
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
    : QWidget(parent),
      curves_(curves),
      plot_(new QCustomPlot(this)),
      mark_(new QCPItemStraightLine(plot_)),
      cursor_(new QCPItemStraightLine(plot_)) {
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
  plot_->axisRect()->setupFullAxesBox(false);
  mark_->setVisible(false);
  cursor_->setVisible(false);
  plot_->setAcceptDrops(true);
  plot_->installEventFilter(this);
  connect(plot_, &QCustomPlot::mouseWheel, this, [this](QWheelEvent* event) {
    const bool values =
        event->modifiers().testFlag(Qt::ShiftModifier) || event->position().x() < plot_->axisRect()->left();
    plot_->axisRect()->setRangeZoom(values ? Qt::Vertical : Qt::Horizontal);
    Q_EMIT touched();
  });
  connect(plot_, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton)) Q_EMIT touched();
    const bool inside = plot_->axisRect()->rect().contains(event->pos());
    Q_EMIT cursorMoved(inside ? std::optional(plot_->xAxis->pixelToCoord(event->pos().x())) : std::nullopt);
  });
  applyTheme();
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
  const QPalette colors = palette();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& curve = curves[i];
    const QColor color = curveColor(curve->color, colors);
    const QColor pale = mixed(colors.color(QPalette::Base), color, kPale);
    const auto robot = robots_.find(robotPart(curve->source().stream));
    SeriesGraph &logged = *graphs_[2 * i], &live = *graphs_[2 * i + 1];
    logged.setPen(QPen(curve->isRecomputed ? pale : color, 1));
    logged.setSeries(std::shared_ptr<const robotlink::Series>(
        curve->logged, curve->logged ? &curve->logged->series : nullptr));
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
  robotlink::Series::Extent all;
  const QCPRange times = plot_->xAxis->range();
  const auto add = [&](const robotlink::Series& series) {
    all.add(series.extent(series.firstFrom(times.lower), series.firstAfter(times.upper)));
  };
  for (const auto& curve : curves_.curves()) {
    add(curve->live);
    if (curve->logged) add(curve->logged->series);
  }
  if (all.isEmpty()) return;
  const double size = all.max - all.min, center = (all.min + all.max) / 2;
  const double margin = size > 0 ? size * 0.06 : std::max(1e-3, std::abs(center) * 0.1);
  plot_->yAxis->setRange(all.min - margin, all.max + margin);
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
  return plot_->savePng(file, 0, 0, 2.0);
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
