// SPDX-License-Identifier: GPL-3.0-or-later
// What a plot writes to files, and keeps of itself.
#include <QAction>
#include <QComboBox>
#include <QJsonArray>
#include <QLabel>
#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "widgets/SplitterState.h"
#include "widgets/plots/PlotCanvas.h"
#include "widgets/plots/PlotsView.h"

namespace widgets {

void PlotsView::exportAs(const QString& title, const QString& suffix) {
  const QString file = askForFile_(title, suffix);
  if (file.isEmpty()) return;
  const auto written = saveTo(file);
  state_->setText(written ? tr("Wrote %1").arg(file) : QString::fromStdString(written.error().describe()));
}

robotlink::Result<void> PlotsView::saveTo(const QString& file) {
  const std::string path = file.toStdString();
  if (file.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive))
    return robotlink::writeFileAtomically(path, curves_.csv().toStdString());
  const bool isSvg = file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
  if (isSvg ? canvas_->saveSvg(file) : canvas_->savePng(file)) return {};
  return robotlink::failure("plots.save", "the picture cannot be written", {path, 0, 0});
}

QJsonObject PlotsView::saveState() const {
  QJsonArray right;
  for (const auto& curve : curves_.curves()) {
    if (curve->isRight) right.append(curve->source().text());
  }
  return {{QStringLiteral("right"), right},
          {QStringLiteral("link"), link_->isChecked()},
          {QStringLiteral("curves"), QJsonArray::fromStringList(curves())},
          {QStringLiteral("window"), window_->currentData().toInt()},
          {QStringLiteral("tree"), showTree_->isChecked()},
          {QStringLiteral("wholeLog"), wholeLog_->isChecked()},
          {QStringLiteral("splitter"), splitterState(*splitter_)}};
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
  link_->setChecked(state.value(QStringLiteral("link")).toBool());
  const int window = window_->findData(state.value(QStringLiteral("window")).toInt(kUsualWindow));
  window_->setCurrentIndex(window < 0 ? window_->findData(kUsualWindow) : window);
  wholeLog_->setChecked(state.value(QStringLiteral("wholeLog")).toBool(true));
  showTree_->setChecked(state.value(QStringLiteral("tree")).toBool(true));
  restoreSplitter(*splitter_, state.value(QStringLiteral("splitter")));
}

}  // namespace widgets
