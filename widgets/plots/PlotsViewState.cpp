// SPDX-License-Identifier: GPL-3.0-or-later
// What a plot writes to files, and keeps of itself.
#include <QAction>
#include <QComboBox>
#include <QJsonArray>
#include <QLabel>
#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "widgets/ShownText.h"
#include "widgets/SplitterState.h"
#include "widgets/log/TimeMarks.h"
#include "widgets/plots/PlotPicture.h"
#include "widgets/plots/PlotsView.h"
#include "widgets/plots/SpectrumCanvas.h"

namespace widgets {

void PlotsView::exportAs(const QString& title, const QString& suffix) {
  const QString file = askForFile_(title, suffix);
  if (file.isEmpty()) return;
  const auto written = saveTo(file);
  state_->setText(written ? tr("Wrote %1").arg(file) : QString::fromStdString(written.error().describe()));
}

robotlink::Result<void> PlotsView::saveTo(const QString& file) {
  const std::string path = file.toStdString();
  if (file.endsWith(QLatin1String(".spectrum.csv"), Qt::CaseInsensitive)) {
    if (!spectrum_->spectra().empty())
      return robotlink::writeFileAtomically(path, spectrum_->csv().toStdString());
    return robotlink::failure("plots.spectrum", "no spectrum is shown: plots.spectrum on", {path, 0, 0});
  }
  const std::string suffix = robotlink::fileSuffix(path);
  if (suffix == ".csv") return robotlink::writeFileAtomically(path, curves_.csv().toStdString());
  if (suffix == ".txt" || suffix == ".tsv")
    return robotlink::writeFileAtomically(path, tabsOfCsv(curves_.csv()).toStdString());
  if (suffix != ".png" && suffix != ".svg")
    return robotlink::failure(
        "plots.save", "plots are written as .png or .svg, their points as .csv, .tsv or .txt", {path, 0, 0});
  if (savePlots(*area_, file)) return {};
  return robotlink::failure("plots.save", "the picture cannot be written", {path, 0, 0});
}

std::optional<QString> PlotsView::numbers() {
  return tabsOfCsv(curves_.csv());
}

QJsonObject PlotsView::saveState() const {
  QJsonArray right;
  QJsonObject strips;
  for (const auto& curve : curves_.curves()) {
    if (curve->isRight) right.append(curve->source().text());
    if (curve->asStrip) strips.insert(curve->source().text(), *curve->asStrip);
  }
  const QJsonObject spectrum{{QStringLiteral("shown"), showSpectrum_->isChecked()},
                             {QStringLiteral("window"), spectrum_->window()},
                             {QStringLiteral("logarithmic"), spectrum_->isLogarithmic()}};
  return {{QStringLiteral("strips"), strips},
          {QStringLiteral("equal"), equal_->isChecked()},
          {QStringLiteral("spectrum"), spectrum},
          {QStringLiteral("marks"), TimeMarks::of(openLogs(context())).pattern()},
          {QStringLiteral("right"), right},
          {QStringLiteral("link"), link_->isChecked()},
          {QStringLiteral("curves"), QJsonArray::fromStringList(curves())},
          {QStringLiteral("window"), window_->currentData().toInt()},
          {QStringLiteral("tree"), showTree_->isChecked()},
          {QStringLiteral("wholeLog"), wholeLog_->isChecked()},
          {QStringLiteral("splitter"), splitterState(*splitter_)}};
}

void PlotsView::followNames(const Renamed& renamed) {
  const QJsonObject before = saveState();
  QJsonObject now = before;
  for (const char* sources : {"curves", "right", "strips"})
    now[QLatin1String(sources)] = renamed(now[QLatin1String(sources)]);
  if (now != before) restoreState(now);
}

void PlotsView::restoreState(const QJsonObject& state) {
  curves_.clear();
  const QJsonArray sources = state.value(QStringLiteral("curves")).toArray();
  for (int i = 0; i < std::min(sources.size(), kMaxRestored); ++i) addCurve(sources.at(i).toString());
  if (sources.size() > kMaxRestored)
    state_->setText(tr("The saved layout has too many curves (%1); only the first %2 are shown.")
                        .arg(sources.size())
                        .arg(kMaxRestored));
  const QJsonArray right = state.value(QStringLiteral("right")).toArray();
  for (auto& curve : curves_.curves()) curve->isRight = right.contains(curve->source().text());
  const QJsonObject strips = state.value(QStringLiteral("strips")).toObject();
  for (auto& curve : curves_.curves()) {
    const QJsonValue on = strips.value(curve->source().text());
    if (on.isBool()) curve->asStrip = on.toBool();
  }
  equal_->setChecked(state.value(QStringLiteral("equal")).toBool());
  const QJsonObject spectrum = state.value(QStringLiteral("spectrum")).toObject();
  spectrum_->setWindow(spectrum.value(QStringLiteral("window")).toString());
  spectrum_->setLogarithmic(spectrum.value(QStringLiteral("logarithmic")).toBool());
  showSpectrum_->setChecked(spectrum.value(QStringLiteral("shown")).toBool());
  const QString marks = state.value(QStringLiteral("marks")).toString();
  if (!marks.isEmpty()) TimeMarks::of(openLogs(context())).setPattern(marks);
  link_->setChecked(state.value(QStringLiteral("link")).toBool());
  const int window = window_->findData(state.value(QStringLiteral("window")).toInt(kUsualWindow));
  window_->setCurrentIndex(window < 0 ? window_->findData(kUsualWindow) : window);
  wholeLog_->setChecked(state.value(QStringLiteral("wholeLog")).toBool(true));
  showTree_->setChecked(state.value(QStringLiteral("tree")).toBool(true));
  restoreSplitter(*splitter_, state.value(QStringLiteral("splitter")));
}

}  // namespace widgets
