// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/LoggedCurves.h"

#include <QFileInfo>
#include <algorithm>

namespace widgets {

using logplayer::LogNumber;
using logplayer::NumberReader;

namespace {

/// Messages of plot values have their number here.
constexpr char kPlotField[] = "value";
constexpr int kAllOfALog = 100;

}  // namespace

LoggedCurves& LoggedCurves::of(OpenLogs& logs) {
  auto* known = logs.findChild<LoggedCurves*>(QString(), Qt::FindDirectChildrenOnly);
  return known != nullptr ? *known : *new LoggedCurves(logs);
}

LoggedCurves::LoggedCurves(OpenLogs& logs) : QObject(&logs), logs_(logs) {}

std::optional<LogNumber> LoggedCurves::numberIn(const OpenLogs::Log& log, const PlotSource& source) {
  // Paths in the log by those in the session.
  std::map<std::string, std::string> streams;
  for (const auto& stream : log.overview->streams)
    streams.emplace(OpenLogs::sessionPath(log, stream.path), stream.path);
  if (source.expression.empty()) {
    const auto found = streams.find(source.stream);
    if (found == streams.end()) return std::nullopt;
    return LogNumber{found->second, source.field.empty() ? kPlotField : source.field};
  }
  std::vector<std::string> names;
  for (const auto& [name, stream] : streams) names.push_back(name);
  const auto parsed = robotlink::Expression::parse(source.expression, names);
  if (!parsed) return std::nullopt;
  for (const auto& input : parsed->inputs()) {
    if (!streams.contains(input.stream)) return std::nullopt;
  }
  return LogNumber{{}, parsed->withStreams([&](const std::string& name) { return streams.at(name); })};
}

std::shared_ptr<const LoggedCurve> LoggedCurves::curve(const PlotSource& source) {
  for (const auto& open : logs_.logs()) {
    const auto number = numberIn(*open, source);
    if (!number) continue;
    Log& log = readers_[open->path];
    if (!log.reader) log = {std::make_unique<NumberReader>(open->path), open->offset};
    auto& entry = log.curves[*number];
    auto curve = entry.lock();
    if (!curve) entry = curve = std::make_shared<LoggedCurve>();
    return curve;
  }
  return nullptr;
}

std::size_t LoggedCurves::share() const {
  std::size_t count = 0;
  for (const auto& [path, log] : readers_) count += log.curves.size();
  return kMaxBytes / std::max<std::size_t>(count, 1);
}

void LoggedCurves::tick() {
  std::erase_if(readers_, [this](const auto& log) { return logs_.find(log.first) == nullptr; });
  for (auto& [path, log] : readers_) {
    follow(log, logs_.find(path)->offset);
    take(log);
    read(log);
  }
}

void LoggedCurves::follow(Log& log, robotlink::Duration offset) {
  if (log.offset == offset) return;
  for (const auto& [number, entry] : log.curves) {
    if (const auto curve = entry.lock()) curve->series.shift(robotlink::seconds(offset - log.offset));
  }
  log.offset = offset;
}

void LoggedCurves::take(Log& log) {
  NumberReader::News news = log.reader->take();
  log.progress = news.progress;
  log.failure = news.failure ? QString::fromStdString(news.failure->describe()) : QString();
  const double offset = robotlink::seconds(log.offset);
  for (const auto& [number, points] : news.points) {
    const auto curve = log.curves[number].lock();
    if (!curve) continue;
    for (const auto& point : points) curve->series.append({point.time + offset, point.value});
    curve->isCut = curve->series.bytes() > share();
  }
  for (const auto& [number, texts] : news.texts) {
    const auto curve = log.curves[number].lock();
    if (!curve) continue;
    for (const auto& [value, text] : texts) curve->names.add(value, QString::fromStdString(text));
  }
  for (const auto& [number, problem] : news.problems) {
    if (const auto curve = log.curves[number].lock()) curve->problem = QString::fromStdString(problem.text);
  }
  for (const LogNumber& number : news.complete) {
    if (const auto curve = log.curves[number].lock()) curve->isComplete = true;
  }
}

void LoggedCurves::read(Log& log) {
  std::erase_if(log.curves, [](const auto& entry) { return entry.second.expired(); });
  std::set<LogNumber> wanted;
  for (const auto& [number, entry] : log.curves) {
    const auto curve = entry.lock();
    if (!curve->isComplete && !curve->isCut) wanted.insert(number);
  }
  if (wanted == log.read) return;
  log.reader->read(wanted);
  log.read = std::move(wanted);
}

QString LoggedCurves::stateText() const {
  for (const auto& [path, log] : readers_) {
    const QString name = QFileInfo(QString::fromStdString(path)).fileName();
    if (!log.failure.isEmpty()) return tr("%1 cannot be read: %2").arg(name, log.failure);
    if (!log.read.empty())
      return tr("Reading %1: %2 %").arg(name).arg(static_cast<int>(log.progress * kAllOfALog));
  }
  return {};
}

}  // namespace widgets
