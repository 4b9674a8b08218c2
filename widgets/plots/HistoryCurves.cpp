// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/HistoryCurves.h"

#include <algorithm>
#include <utility>

#include "robotlink/session/Session.h"

namespace widgets {

using logplayer::LogNumber;
using logplayer::NumberReader;

namespace {

/// Messages of plot values have their number here.
constexpr char kPlotValueField[] = "value";
constexpr int kAllOfHistory = 100;

LogNumber numberOfSource(const PlotSource& source) {
  if (!source.expression.empty()) return {{}, source.expression};
  return {source.stream, source.field.empty() ? kPlotValueField : source.field};
}

}  // namespace

HistoryCurves& HistoryCurves::of(OpenLogs& logs) {
  auto* known = logs.findChild<HistoryCurves*>(QString(), Qt::FindDirectChildrenOnly);
  return known != nullptr ? *known : *new HistoryCurves(logs);
}

std::shared_ptr<const LoggedCurve> HistoryCurves::curve(const PlotSource& source) {
  auto& entry = waiting_[numberOfSource(source)];
  auto curve = entry.lock();
  if (!curve) entry = curve = std::make_shared<LoggedCurve>();
  return curve;
}

void HistoryCurves::tick(robotlink::Session& session) {
  // Values that were read before a restart belong to another run.
  if (reader_ && generation_ != session.store().generation()) reader_.reset();
  if (reader_) take();
  if (!reader_ && !waiting_.empty()) begin(session);
}

void HistoryCurves::begin(robotlink::Session& session) {
  curves_ = std::exchange(waiting_, {});
  std::erase_if(curves_, [](const auto& entry) { return entry.second.expired(); });
  const auto* archive = session.history().archive();
  if (curves_.empty() || archive == nullptr) {
    for (const auto& [number, entry] : curves_) {
      if (const auto curve = entry.lock()) curve->isComplete = true;
    }
    return;
  }
  generation_ = session.store().generation();
  progress_ = 0;
  read_.clear();
  for (const auto& [number, entry] : curves_) read_.insert(number);
  reader_ = std::make_unique<NumberReader>(logplayer::historySource(archive->pieces()));
  reader_->read(read_);
}

void HistoryCurves::take() {
  NumberReader::News news = reader_->take();
  progress_ = news.progress;
  for (const auto& [number, entry] : curves_) {
    const auto curve = entry.lock();
    if (!curve) continue;
    for (const auto& point : news.points[number]) curve->series.append(point);
    curve->series.limit(kMaxBytes / curves_.size());
    for (const auto& [value, text] : news.texts[number])
      curve->names.add(value, QString::fromStdString(text));
    if (news.failure || std::ranges::find(news.complete, number) != news.complete.end())
      curve->isComplete = true;
  }
  std::set<LogNumber> wanted;
  for (const auto& [number, entry] : curves_) {
    const auto curve = entry.lock();
    if (curve && !curve->isComplete) wanted.insert(number);
  }
  // The thread ends with its reader.
  if (wanted.empty()) return reader_.reset();
  if (wanted == read_) return;
  reader_->read(wanted);
  read_ = std::move(wanted);
}

QString HistoryCurves::stateText() const {
  return reader_ ? tr("Reading the history: %1 %").arg(static_cast<int>(progress_ * kAllOfHistory))
                 : QString();
}

}  // namespace widgets
