// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotSource.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <set>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/NaturalOrder.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/expressions/FieldPath.h"
#include "robotlink/expressions/NumericFields.h"
#include "widgets/world/FieldUnits.h"

namespace widgets {
namespace {

constexpr char kPlotType[] = "robotcontrol.PlotValue";
constexpr char kBeforeField[] = ": ";
constexpr char kBeforeFilter[] = " | ";
constexpr std::array kLeftOut{"foxglove.SceneUpdate",      "foxglove.ImageAnnotations",
                              "foxglove.RawImage",         "foxglove.Log",
                              "robotcontrol.KeyTable",     "robotcontrol.SolutionTable",
                              "robotcontrol.ProcessTable", "robotcontrol.ParameterValues"};

bool leftOut(const std::string& type) {
  return std::any_of(kLeftOut.begin(), kLeftOut.end(), [&](const char* name) { return type == name; });
}

std::string typeOf(const std::string& type) {
  const auto* known = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(type);
  return known != nullptr && !leftOut(type) ? type : std::string();
}

/// Adds the packages that the robots' processes exchange, with their types.
void addPackages(const robotlink::StreamStore& store, std::map<std::string, std::string>& types) {
  for (const auto* stream : streamsOfType(store, {}, "robotcontrol.ProcessTable")) {
    const auto* table = dynamic_cast<const robotcontrol::ProcessTable*>(stream->messages.back().value.get());
    if (table == nullptr) continue;
    for (const auto& process : table->processes()) {
      for (const auto& port : process.senders()) {
        if (port.package().starts_with("debug/") || typeOf(port.type()).empty()) continue;
        types.emplace(robotPart(stream->path) + '/' + port.package(), port.type());
      }
    }
  }
}

bool isOff(const robotcontrol::KeyTable::Key& key) {
  return key.mode().kind() == robotcontrol::KeyMode::OFF;
}

}  // namespace

QString PlotSource::text() const {
  QString text = QString::fromStdString(stream);
  if (!field.empty()) text += QLatin1String(kBeforeField) + QString::fromStdString(field);
  if (!filter.empty()) text += QLatin1String(kBeforeFilter) + QString::fromStdString(filter);
  return text;
}

PlotSource PlotSource::fromText(const QString& text) {
  const int bar = text.indexOf(QLatin1String(kBeforeFilter));
  if (bar >= 0) {
    PlotSource source = fromText(text.left(bar));
    source.filter = text.mid(bar + static_cast<int>(std::strlen(kBeforeFilter))).trimmed().toStdString();
    return source;
  }
  const int colon = text.indexOf(QLatin1String(kBeforeField));
  if (colon < 0) return {text.toStdString(), {}};
  return {text.left(colon).toStdString(),
          text.mid(colon + static_cast<int>(std::strlen(kBeforeField))).toStdString()};
}

std::vector<PlotSource> plotSources(const robotlink::StreamStore& store) {
  std::vector<PlotSource> sources;
  std::map<std::string, std::string> types;
  addPackages(store, types);
  for (const auto* stream : store.streams()) {
    types.erase(stream->path);
    if (leftOut(stream->type) || stream->messages.empty()) continue;
    if (stream->type == kPlotType) {
      sources.push_back({stream->path, {}, stream->type});
      continue;
    }
    for (const std::string& field : robotlink::numericFields(*stream->messages.back().value)) {
      sources.push_back({stream->path, field, stream->type});
    }
  }
  for (const auto& [path, type] : types) {
    const auto* described = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(type);
    for (const std::string& field : robotlink::numericFields(*described))
      sources.push_back({path, field, type});
  }
  std::ranges::stable_sort(sources, robotlink::comesNaturallyBefore, &PlotSource::stream);
  return sources;
}

std::string keyFor(const robotlink::StreamStore& store, const PlotSource& source, robotlink::Instant time) {
  const std::string robot = robotPart(source.stream);
  if (robot.empty()) return {};
  const std::string below = source.stream.substr(robot.size() + 1);
  const bool plot = below.starts_with("plots/");
  std::string found;
  for (const auto* message : latestTable(store, robot, robotlink::streams::kKeys, time)) {
    const auto* table =
        message == nullptr ? nullptr : dynamic_cast<const robotcontrol::KeyTable*>(message->value.get());
    if (table == nullptr) continue;
    for (const auto& key : table->keys()) {
      const std::string path = plot ? "plots/" + key.name() : key.name();
      const bool fits = plot ? below == path || below.starts_with(path + '/') : path == "package/" + below;
      if (fits && isOff(key) && key.name().size() > found.size()) found = key.name();
    }
  }
  return found;
}

PlotReader::PlotReader(PlotSource source) : source_(std::move(source)) {
  if (auto path = robotlink::FieldPath::parse(source_.field)) path_ = std::move(*path);
}

std::optional<double> PlotReader::valueOf(const robotlink::StreamMessage& message) {
  if (!source_.field.empty()) {
    if (!unitKnown_) unit_ = unitOf(message.value->GetDescriptor()->full_name(), source_.field);
    unitKnown_ = true;
    const auto value = path_ ? path_->valueIn(*message.value) : std::nullopt;
    return value ? value->number : std::nullopt;
  }
  const auto* plot = dynamic_cast<const robotcontrol::PlotValue*>(message.value.get());
  if (plot == nullptr) return {};
  unit_ = QString::fromStdString(plot->unit());
  return plot->value();
}

PlotReader::News PlotReader::take(const robotlink::StreamStore& store) {
  News news;
  const auto* stream = store.find(source_.stream);
  if (stream == nullptr) return news;
  const StreamCursor::News added = cursor_.take(*stream);
  news.restarted = added.restarted;
  for (const auto* message : added.messages) {
    const auto value = valueOf(*message);
    if (!value) continue;
    last_ = value;
    news.points.push_back({robotlink::seconds(message->time), *value});
  }
  return news;
}

}  // namespace widgets
