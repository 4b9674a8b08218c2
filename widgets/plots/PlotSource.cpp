// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotSource.h"

#include <google/protobuf/descriptor.h>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/TextParts.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/expressions/FieldPath.h"
#include "robotlink/series/PointFilter.h"
#include "widgets/world/FieldUnits.h"

namespace widgets {

using robotlink::contains;

namespace {

constexpr char kBeforeField[] = ": ";
constexpr char kBeforeFilter[] = " | ";
constexpr char kBeforeAcross[] = " over ";
constexpr char kBeforeExpression[] = "= ";

bool isOff(const robotcontrol::KeyTable::Key& key) {
  return key.mode().kind() == robotcontrol::KeyMode::OFF;
}

/// The position of a separator outside of quoted texts; -1: there is none.
int placeOf(const QString& text, const char* separator) {
  bool isQuoted = false;
  for (int i = 0; i < text.size(); ++i) {
    if (text[i] == QLatin1Char('"') && (i == 0 || text[i - 1] != QLatin1Char('\\'))) isQuoted = !isQuoted;
    if (!isQuoted && QStringView(text).mid(i).startsWith(QLatin1String(separator))) return i;
  }
  return -1;
}

/// Removes the text behind a separator, and the separator, and returns the former; empty: there is none.
QString takeBehind(QString& text, const char* separator) {
  const int place = placeOf(text, separator);
  if (place < 0) return {};
  const QString behind = text.mid(place + static_cast<int>(std::strlen(separator))).trimmed();
  text = text.left(place);
  return behind;
}

/// Reads what has no sign: an expression that is nothing but one value is that value, whose unit is known;
/// what uses no value is the name of a stream.
void readUnmarked(const std::string& text, const std::vector<std::string>& streams, PlotSource& source) {
  const auto parsed = robotlink::Expression::parse(text, streams);
  if (!parsed || parsed->inputs().empty()) {
    source.stream = text;
    return;
  }
  const robotlink::ExpressionInput& first = parsed->inputs().front();
  if (text == first.stream + '.' + first.path.text()) {
    source.stream = first.stream;
    source.field = first.path.text();
  } else {
    source.expression = text;
  }
}

}  // namespace

QString PlotSource::text() const {
  QString text = expression.empty() ? QString::fromStdString(stream)
                                    : QLatin1String(kBeforeExpression) + QString::fromStdString(expression);
  if (!field.empty()) text += QLatin1String(kBeforeField) + QString::fromStdString(field);
  if (!filter.empty()) text += QLatin1String(kBeforeFilter) + QString::fromStdString(filter);
  if (!across.empty()) text += QLatin1String(kBeforeAcross) + QString::fromStdString(across);
  return text;
}

PlotSource PlotSource::fromText(const QString& text) {
  PlotSource source{};
  QString rest = text.trimmed();
  source.across = takeBehind(rest, kBeforeAcross).toStdString();
  source.filter = takeBehind(rest, kBeforeFilter).toStdString();
  if (rest.startsWith(QLatin1Char('='))) {
    source.expression = rest.mid(1).trimmed().toStdString();
    return source;
  }
  const int colon = rest.indexOf(QLatin1String(kBeforeField));
  const bool hasField = colon >= 0 && !rest.contains(QLatin1Char('?'));
  if (hasField) {
    source.stream = rest.left(colon).toStdString();
    source.field = rest.mid(colon + static_cast<int>(std::strlen(kBeforeField))).toStdString();
  } else {
    readUnmarked(rest.trimmed().toStdString(), {}, source);
  }
  return source;
}

namespace {

/// Names the stream of a value as it is known: as one of `robot`, or with dots in its name.
void completeStream(PlotSource& source, const std::string& robot, const std::vector<std::string>& streams,
                    const std::vector<std::string>& known) {
  if (contains(streams, source.stream)) return;
  if (!source.field.empty()) {
    PlotSource again{};
    readUnmarked(source.stream + '.' + source.field, known, again);
    if (contains(known, again.stream)) {
      source.stream = again.stream;
      source.field = again.field;
    }
  }
  const std::string full = robot + '/' + source.stream;
  if (!contains(streams, source.stream) && contains(streams, full)) source.stream = full;
}

}  // namespace

robotlink::Result<PlotSource> completed(PlotSource source, const std::string& robot,
                                        const std::vector<std::string>& streams,
                                        const std::vector<std::string>& robots) {
  if (source.isEmpty()) return robotlink::failure("plots.empty", "the text names no value");
  if (const auto filter = robotlink::PointFilter::parse(source.filter); !filter)
    return tl::unexpected(filter.error());
  std::vector<std::string> known = streams;
  for (const std::string& stream : streams) {
    if (const std::string of = robotlink::streams::robotOf(stream); contains(robots, of))
      known.push_back(stream.substr(of.size() + 1));
  }
  if (source.expression.empty()) {
    completeStream(source, robot, streams, known);
  } else {
    const auto parsed = robotlink::Expression::parse(source.expression, known);
    if (!parsed) return tl::unexpected(parsed.error());
    if (parsed->inputs().empty())
      return robotlink::failure("plots.constant", "the expression uses no value of a stream");
    source.expression = parsed->withStreams([&](const std::string& stream) {
      const std::string full = robot + '/' + stream;
      return !contains(streams, stream) && contains(streams, full) ? full : stream;
    });
  }
  if (source.across.empty()) return source;
  const auto across =
      completed(PlotSource::fromText(QString::fromStdString(source.across)), robot, streams, robots);
  if (!across) return across;
  source.across = across->text().toStdString();
  return source;
}

void StateNames::add(double value, const QString& name) {
  // NaN has no place in an order.
  if (states_.size() < kMax && !std::isnan(value))
    states_.emplace(value, State{name, static_cast<int>(states_.size())});
}

void StateNames::merge(const StateNames& others) {
  std::vector<std::pair<int, double>> order;
  for (const auto& [value, state] : others.states_) order.emplace_back(state.place, value);
  std::ranges::sort(order);
  for (const auto& [place, value] : order) add(value, others.states_.at(value).name);
}

const StateNames::State* StateNames::find(double value) const {
  const auto found = std::isnan(value) ? states_.end() : states_.find(value);
  return found == states_.end() ? nullptr : &found->second;
}

QString StateNames::name(double value) const {
  const State* known = find(value);
  return known == nullptr ? QString::number(value, 'g', 6) : known->name;
}

int StateNames::color(double value) const {
  constexpr double kColors = 12;
  if (const State* known = find(value); known != nullptr) return known->place;
  return std::isfinite(value) ? static_cast<int>(std::fmod(std::abs(std::round(value)), kColors)) : 0;
}

std::string keyFor(const robotlink::StreamStore& store, const std::string& stream, robotlink::Instant time) {
  const std::string robot = robotlink::streams::robotOf(stream);
  if (robot.empty()) return {};
  const std::string below = stream.substr(robot.size() + 1);
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

void PlotReader::News::append(News later) {
  if (later.restarted) points.clear();
  points.insert(points.end(), later.points.begin(), later.points.end());
  restarted = restarted || later.restarted;
  missed = later.missed || (missed && !later.restarted);
}

PlotReader::PlotReader(PlotSource source) : source_(std::move(source)) {
  if (source_.expression.empty()) {
    streams_ = {source_.stream};
    if (auto path = robotlink::FieldPath::parse(source_.field)) path_ = std::move(*path);
  } else if (const auto parsed = robotlink::Expression::parse(source_.expression)) {
    for (const auto& input : parsed->inputs()) {
      if (!contains(streams_, input.stream)) streams_.push_back(input.stream);
    }
  }
}

std::optional<double> PlotReader::numberOf(const std::optional<robotlink::FieldValue>& value) {
  const auto number = value ? value->asNumber() : std::nullopt;
  if (number && value->text) names_.add(*number, QString::fromStdString(*value->text));
  return number;
}

std::optional<double> PlotReader::valueOf(const robotlink::StreamMessage& message) {
  if (!source_.field.empty()) {
    if (!unitKnown_) unit_ = unitOf(message.value->GetDescriptor()->full_name(), source_.field);
    unitKnown_ = true;
    return path_ ? numberOf(path_->valueIn(*message.value)) : std::nullopt;
  }
  const auto* plot = dynamic_cast<const robotcontrol::PlotValue*>(message.value.get());
  if (plot == nullptr) return {};
  unit_ = QString::fromStdString(plot->unit());
  return plot->value();
}

QString PlotReader::problem(const robotlink::StreamStore& store) const {
  if (!source_.expression.empty()) return problem_.isEmpty() && !last_ ? missingValue(store) : problem_;
  if (store.find(source_.stream) != nullptr) return last_ ? QString() : missingField(store);
  return QCoreApplication::translate("PlotReader", "nothing is published on %1")
      .arg(QString::fromStdString(source_.stream));
}

QString PlotReader::missingField(const robotlink::StreamStore& store) const {
  const auto* message = store.latest(source_.stream, robotlink::Instant::max());
  if (message == nullptr || !path_) return {};
  if (const auto fits = path_->fits(*message->value->GetDescriptor()); !fits)
    return QString::fromStdString(fits.error().text);
  return QString::fromStdString(path_->missingElement(*message->value));
}

QString PlotReader::missingValue(const robotlink::StreamStore& store) const {
  const auto parsed = robotlink::Expression::parse(source_.expression, streams_);
  if (!parsed) return {};
  for (const auto& input : parsed->inputs()) {
    const auto* message = store.latest(input.stream, robotlink::Instant::max());
    if (message == nullptr) continue;
    if (const std::string missing = input.path.missingElement(*message->value); !missing.empty())
      return QString::fromStdString(missing);
  }
  return {};
}

PlotReader::News PlotReader::take(const robotlink::StreamStore& store) {
  // Values of another log or simulation are dropped; its stream may no longer exist.
  const bool isOther = generation_ && generation_ != store.generation();
  generation_ = store.generation();
  if (isOther) {
    cursors_.clear();
    last_.reset();
    expression_.reset();
    listVersion_ = 0;
    newest_ = -std::numeric_limits<double>::infinity();
  }
  News news = source_.expression.empty() ? takeOfStream(store) : takeOfExpression(store);
  news.restarted = news.restarted || isOther;
  return news;
}

PlotReader::News PlotReader::takeOfStream(const robotlink::StreamStore& store) {
  News news;
  const auto* stream = store.find(source_.stream);
  if (stream == nullptr) return news;
  const StreamCursor::News added = cursors_[source_.stream].take(*stream);
  news.restarted = added.restarted;
  news.missed = added.missed;
  for (const auto* message : added.messages) {
    const auto value = valueOf(*message);
    if (!value) continue;
    last_ = value;
    news.points.push_back({robotlink::seconds(message->time), *value});
  }
  return news;
}

void PlotReader::bind(const robotlink::StreamStore& store) {
  if (expression_ || listVersion_ == store.listVersion()) return;
  listVersion_ = store.listVersion();
  std::vector<std::string> streams;
  for (const auto* stream : store.streams()) streams.push_back(stream->path);
  auto bound = robotlink::BoundExpression::bind(source_.expression, streams, {});
  if (!bound) {
    problem_ = QString::fromStdString(bound.error().text);
    return;
  }
  problem_.clear();
  expression_.emplace(std::move(bound->front()));
  const std::set<std::string> needed(expression_->streams().begin(), expression_->streams().end());
  streams_.assign(needed.begin(), needed.end());
}

PlotReader::News PlotReader::takeOfExpression(const robotlink::StreamStore& store) {
  News news;
  bind(store);
  if (!expression_) return news;
  std::vector<const robotlink::StreamMessage*> messages;
  for (const std::string& path : streams_) {
    const auto* stream = store.find(path);
    if (stream == nullptr) continue;
    const StreamCursor::News added = cursors_[path].take(*stream);
    messages.insert(messages.end(), added.messages.begin(), added.messages.end());
    news.restarted = news.restarted || added.restarted;
    news.missed = news.missed || added.missed;
  }
  if (news.restarted) newest_ = -std::numeric_limits<double>::infinity();
  std::ranges::stable_sort(messages, {}, &robotlink::StreamMessage::time);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const auto& message = *messages[i];
    if (const auto taken = expression_->take(message.path, *message.value); !taken)
      problem_ = QString::fromStdString(taken.error().text);
    if (i + 1 < messages.size() && messages[i + 1]->time == message.time) continue;
    const auto value = numberOf(expression_->valueOrText());
    if (!value) continue;
    last_ = value;
    newest_ = std::max(newest_, robotlink::seconds(message.time));
    news.points.push_back({newest_, *value});
  }
  return news;
}

}  // namespace widgets
