// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/PointFilter.h"

#include <algorithm>
#include <cmath>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/base/TextParts.h"

namespace robotlink {
namespace {

constexpr char kSeparator = '|';

}  // namespace

const std::vector<PointFilter::Kind>& PointFilter::kinds() {
  static const std::vector<Kind> kAll = {
      {"derivative", nullptr}, {"integral", nullptr},  {"average", "s", 0.5},    {"median", "s", 0.5},
      {"low-pass", "s", 0.2},  {"scale", "factor", 1}, {"offset", "is added", 0}};
  return kAll;
}

Result<PointFilter> PointFilter::parse(std::string_view text) {
  PointFilter filter;
  while (!trimmed(text).empty()) {
    const std::size_t end = std::min(text.find(kSeparator), text.size());
    auto step = parseStep(trimmed(text.substr(0, end)));
    if (!step) return tl::unexpected(step.error());
    filter.steps_.push_back(std::move(*step));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return filter;
}

Result<PointFilter::Step> PointFilter::parseStep(std::string_view text) {
  const std::size_t space = std::min(text.find(' '), text.size());
  const std::string name(text.substr(0, space));
  const std::string_view rest = trimmed(text.substr(space));
  const auto kind = std::ranges::find(kinds(), name, &Kind::name);
  if (kind == kinds().end()) {
    std::vector<std::string> names;
    for (const Kind& known : kinds()) names.emplace_back(known.name);
    return failure("filter.name", "there is no filter " + name + suggestion(name, names), {}, {name});
  }
  if (kind->number == nullptr) {
    if (!rest.empty()) return failure("filter.number", name + " takes no number", {}, {name});
    if (name == "derivative") return Derivative{};
    return Integral{};
  }
  const auto number = parsedNumberWithSign<double>(rest);
  const bool isLength = std::string_view(kind->number) == "s";
  if (!number || !std::isfinite(*number) || (isLength && *number <= 0)) {
    return failure("filter.number", name + " needs a number" + (isLength ? " of seconds above 0" : ""), {},
                   {name});
  }
  if (name == "scale") return Linear{*number, 0};
  if (name == "offset") return Linear{1, *number};
  if (name == "low-pass") return LowPass{*number};
  return Window{*number, name == "median"};
}

std::optional<PointFilter::Point> PointFilter::next(Point point) {
  std::optional<Point> result = point;
  for (Step& step : steps_) {
    if (!result || std::isnan(result->value)) return result;
    result = std::visit([&](auto& kind) { return apply(kind, *result); }, step);
  }
  return result;
}

void PointFilter::restart() {
  for (Step& step : steps_) {
    if (auto* derivative = std::get_if<Derivative>(&step)) *derivative = {};
    if (auto* integral = std::get_if<Integral>(&step)) *integral = {};
    if (auto* window = std::get_if<Window>(&step)) *window = {window->length, window->isMedian};
    if (auto* lowPass = std::get_if<LowPass>(&step)) *lowPass = {lowPass->timeConstant};
  }
}

std::string PointFilter::unit(std::string unit) const {
  for (const Step& step : steps_) {
    if (std::holds_alternative<Derivative>(step)) unit = unit.empty() ? "1/s" : unit + "/s";
    if (std::holds_alternative<Integral>(step)) unit += unit.empty() ? "s" : " s";
    const auto* linear = std::get_if<Linear>(&step);
    if (linear != nullptr && linear->factor != 1) unit.clear();
  }
  return unit;
}

std::optional<PointFilter::Point> PointFilter::apply(Linear& step, Point point) {
  return Point{point.time, point.value * step.factor + step.offset};
}

std::optional<PointFilter::Point> PointFilter::apply(Derivative& step, Point point) {
  const auto before = step.before;
  if (before && point.time <= before->time) return std::nullopt;
  step.before = point;
  if (!before) return std::nullopt;
  return Point{point.time, (point.value - before->value) / (point.time - before->time)};
}

std::optional<PointFilter::Point> PointFilter::apply(Integral& step, Point point) {
  const auto before = step.before;
  if (before && point.time < before->time) return std::nullopt;
  step.before = point;
  if (before) step.sum += (point.value + before->value) / 2 * (point.time - before->time);
  return Point{point.time, step.sum};
}

std::optional<PointFilter::Point> PointFilter::apply(Window& step, Point point) {
  if (!step.points.empty() && point.time < step.points.back().time) return std::nullopt;
  const auto forget = [&step](double value) {
    step.sum -= value;
    if (step.isMedian) step.sorted.erase(std::ranges::lower_bound(step.sorted, value));
  };
  while (!step.points.empty() && step.points.front().time <= point.time - step.length) {
    forget(step.points.front().value);
    step.points.pop_front();
  }
  // The residue of rounding is removed.
  if (step.points.empty()) step.sum = 0;
  step.points.push_back(point);
  step.sum += point.value;
  if (!step.isMedian) return Point{point.time, step.sum / static_cast<double>(step.points.size())};
  step.sorted.insert(std::ranges::upper_bound(step.sorted, point.value), point.value);
  const std::size_t middle = step.sorted.size() / 2;
  const bool isOdd = step.sorted.size() % 2 == 1;
  return Point{point.time, isOdd ? step.sorted[middle] : (step.sorted[middle - 1] + step.sorted[middle]) / 2};
}

std::optional<PointFilter::Point> PointFilter::apply(LowPass& step, Point point) {
  if (!step.before) {
    step.before = point;
    return point;
  }
  if (point.time < step.before->time) return std::nullopt;
  const double share = 1 - std::exp(-(point.time - step.before->time) / step.timeConstant);
  step.before = Point{point.time, step.before->value + share * (point.value - step.before->value)};
  return step.before;
}

}  // namespace robotlink
