// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/SpectrumCanvas.h"

#include <qcustomplot.h>

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "widgets/Controls.h"
#include "widgets/Theme.h"
#include "widgets/plots/PlotStyle.h"
#include "widgets/plots/SeriesGraph.h"

namespace widgets {
namespace {

using robotlink::Spectrum;
using robotlink::SpectrumWindow;

/// A note is shown if points are this far from evenly spaced.
constexpr double kLargeGap = 4;

struct Window {
  const char* name;
  const char* title;
  SpectrumWindow value;
};
constexpr Window kSpectrumWindows[] = {
    {"hann", QT_TRANSLATE_NOOP("SpectrumCanvas", "Hann"), SpectrumWindow::kHann},
    {"rectangle", QT_TRANSLATE_NOOP("SpectrumCanvas", "none (rectangle)"), SpectrumWindow::kRectangle},
    {"hamming", QT_TRANSLATE_NOOP("SpectrumCanvas", "Hamming"), SpectrumWindow::kHamming},
    {"blackman", QT_TRANSLATE_NOOP("SpectrumCanvas", "Blackman"), SpectrumWindow::kBlackman},
    {"flat-top", QT_TRANSLATE_NOOP("SpectrumCanvas", "flat top"), SpectrumWindow::kFlatTop}};

/// The number of the largest amplitude of an oscillation.
std::size_t peakOf(const Spectrum& spectrum) {
  const auto begin = spectrum.amplitudes.begin();
  return static_cast<std::size_t>(std::max_element(begin + 1, spectrum.amplitudes.end()) - begin);
}

}  // namespace

SpectrumCanvas::SpectrumCanvas(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  plot_->setObjectName(QStringLiteral("spectrumCanvas"));
  plot_->setAccessibleName(tr("Spectrum"));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(120, 80);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->axisRect()->setupFullAxesBox(false);
  plot_->axisRect()->setRangeZoom(Qt::Horizontal);
  for (QCPAxis* axis : {plot_->xAxis2, plot_->yAxis2}) axis->setTicks(false);
  plot_->xAxis->setLabel(tr("frequency [Hz]"));
  plot_->yAxis->setLabel(tr("amplitude"));
  createControls();
  connect(plot_, &QCustomPlot::mouseWheel, this, [this] { isFitted_ = false; });
  connect(plot_, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) isFitted_ = false;
  });
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this] {
    isFitted_ = true;
    fit();
  });
  applyTheme();
}

void SpectrumCanvas::createControls() {
  window_ = new QComboBox(this);
  describe(*window_, {"plotsSpectrumWindow", tr("Window"),
                      tr("Window function: flat top is best for amplitudes, none for close frequencies, the "
                         "others are in between")});
  for (const Window& window : kSpectrumWindows)
    window_->addItem(QCoreApplication::translate("SpectrumCanvas", window.title), QLatin1String(window.name));
  logarithmic_ = makeToggle(
      this, "fit", {"plotsSpectrumLog", tr("Logarithmic"), tr("Shows amplitudes on a logarithmic scale")});
  logarithmic_->setIcon({});
  note_ = makeNote(this, "plotsSpectrumNote", tr("About the spectrum"));
  auto* row = tools_ = makeToolRow(this, 0);
  row->addWidget(window_);
  auto* button = makeButton(this, logarithmic_);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  row->addWidget(button);
  row->addWidget(note_, 1);
  auto* layout = makeColumn(this, {}, 2);
  layout->addWidget(row->parentWidget());
  layout->addWidget(plot_, 1);
  connect(window_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &SpectrumCanvas::compute);
  connect(logarithmic_, &QAction::toggled, this, [this](bool on) {
    plot_->yAxis->setScaleType(on ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    plot_->yAxis->setTicker(on ? QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog)
                               : QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
    plot_->yAxis->setNumberFormat(on ? QStringLiteral("eb") : QStringLiteral("gb"));
    plot_->yAxis->setNumberPrecision(on ? 0 : 6);
    fit();
  });
}

void SpectrumCanvas::applyTheme() {
  stylePlot(*plot_, *plot_->axisRect(), palette(), font());
  for (std::size_t i = 0; i < graphs_.size(); ++i)
    graphs_[i]->setPen(QPen(curveColor(seen_[i].curve->color, palette()), 1));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void SpectrumCanvas::addTool(QAction& action) {
  tools_->addWidget(makeButton(this, &action));
}

QString SpectrumCanvas::window() const {
  return window_->currentData().toString();
}

void SpectrumCanvas::setWindow(const QString& name) {
  const int index = window_->findData(name);
  window_->setCurrentIndex(std::max(0, index));
}

bool SpectrumCanvas::isLogarithmic() const {
  return logarithmic_->isChecked();
}

void SpectrumCanvas::setLogarithmic(bool on) {
  logarithmic_->setChecked(on);
}

SpectrumWindow SpectrumCanvas::chosenWindow() const {
  return kSpectrumWindows[std::max(0, window_->currentIndex())].value;
}

void SpectrumCanvas::showSpectra(std::vector<std::shared_ptr<CurveModel::Curve>> curves, double from,
                                 double to) {
  std::vector<Seen> seen;
  for (auto& curve : curves) {
    const robotlink::Series& points = curve->points();
    seen.push_back({std::move(curve), points.firstFrom(from), points.firstAfter(to)});
  }
  if (seen == seen_ && times_ == std::pair(from, to)) return;
  seen_ = std::move(seen);
  times_ = {from, to};
  compute();
}

void SpectrumCanvas::addSpectrum(const Seen& seen, QStringList& notes) {
  auto computed = robotlink::spectrumOf(seen.curve->points(), times_.first, times_.second, chosenWindow());
  spectra_.push_back(computed ? std::move(*computed) : Spectrum{});
  auto* graph = new SeriesGraph(plot_->xAxis, plot_->yAxis);
  graph->setPen(QPen(curveColor(seen.curve->color, palette()), 1));
  graphs_.push_back(graph);
  if (!computed) {
    notes << tr("%1: %2").arg(seen.curve->title, QString::fromStdString(computed.error().text));
    return;
  }
  const Spectrum& spectrum = spectra_.back();
  auto series = std::make_shared<robotlink::Series>();
  for (std::size_t i = 0; i < spectrum.amplitudes.size(); ++i)
    series->append({static_cast<double>(i) * spectrum.step, spectrum.amplitudes[i]});
  graph->setSeries(std::move(series));
  const std::size_t peak = peakOf(spectrum);
  QString note = tr("%1: largest %2 %3 at %4 Hz")
                     .arg(seen.curve->title)
                     .arg(spectrum.amplitudes[peak], 0, 'g', 4)
                     .arg(seen.curve->unit())
                     .arg(static_cast<double>(peak) * spectrum.step, 0, 'g', 5);
  if (spectrum.isThinned) note += tr(" (points were left out)");
  if (spectrum.largestGap > kLargeGap) note += tr(" (gaps were bridged by lines)");
  notes << note;
}

void SpectrumCanvas::compute() {
  for (SeriesGraph* graph : graphs_) plot_->removePlottable(graph);
  graphs_.clear();
  spectra_.clear();
  QStringList notes;
  for (const Seen& seen : seen_) addSpectrum(seen, notes);
  note_->setText(seen_.empty() ? tr("Add a curve of numbers; its spectrum is shown here.")
                               : notes.join(QLatin1Char('\n')));
  if (isFitted_) fit();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void SpectrumCanvas::fit() {
  constexpr double kMinShare = 1e-6;
  double last = 0, largest = 0, smallest = std::numeric_limits<double>::infinity();
  for (const Spectrum& spectrum : spectra_) {
    if (spectrum.amplitudes.empty()) continue;
    last = std::max(last, spectrum.step * static_cast<double>(spectrum.amplitudes.size() - 1));
    for (std::size_t i = 1; i < spectrum.amplitudes.size(); ++i) {
      largest = std::max(largest, spectrum.amplitudes[i]);
      smallest = std::min(smallest, spectrum.amplitudes[i]);
    }
  }
  if (last > 0) plot_->xAxis->setRange(0, last);
  if (largest > 0)
    plot_->yAxis->setRange(isLogarithmic() ? std::max(smallest, largest * kMinShare) : 0, largest * 1.1);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

QString SpectrumCanvas::csv() const {
  QStringList header;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < spectra_.size(); ++i) {
    QString name = seen_[i].curve->source().text();
    header << QStringLiteral("frequency_hz")
           << QStringLiteral("\"%1\"").arg(name.replace(QLatin1String("\""), QLatin1String("\"\"")));
    rows = std::max(rows, spectra_[i].amplitudes.size());
  }
  QString text = header.join(QLatin1Char(',')) + QLatin1Char('\n');
  for (std::size_t row = 0; row < rows; ++row) {
    QStringList cells;
    for (const Spectrum& spectrum : spectra_) {
      const bool isHere = row < spectrum.amplitudes.size();
      cells << (isHere ? QString::number(spectrum.step * static_cast<double>(row), 'g', 12) : QString())
            << (isHere ? QString::number(spectrum.amplitudes[row], 'g', 9) : QString());
    }
    text += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
  }
  return text;
}

void SpectrumCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) applyTheme();
  QWidget::changeEvent(event);
}

}  // namespace widgets
