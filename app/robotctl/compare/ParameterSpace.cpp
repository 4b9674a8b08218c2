// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/ParameterSpace.h"

#include <fmt/format.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Solution.h"

namespace app {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

tl::unexpected<robotlink::Error> wrongParameter(const std::string& path, const std::string& why) {
  return robotlink::failure("tune.parameter", "the parameter " + path + " " + why, {}, {path});
}

/// A number of a message, or of a message in it, and whether it is a whole one. Nothing if there is no such
/// field, or it is no number.
std::optional<std::pair<double, bool>> numberAt(const Message& message, const std::string& path) {
  const auto dot = path.find('.');
  const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(path.substr(0, dot));
  if (field == nullptr || field->is_repeated()) return std::nullopt;
  const auto& reflection = *message.GetReflection();
  if (dot != std::string::npos) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) return std::nullopt;
    return numberAt(reflection.GetMessage(message, field), path.substr(dot + 1));
  }
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return std::pair(reflection.GetDouble(message, field), false);
    case FieldDescriptor::CPPTYPE_INT32:
      return std::pair(static_cast<double>(reflection.GetInt32(message, field)), true);
    case FieldDescriptor::CPPTYPE_UINT32:
      return std::pair(static_cast<double>(reflection.GetUInt32(message, field)), true);
    default:
      return std::nullopt;
  }
}

std::optional<double> numberIn(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool isWhole = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
  return isWhole ? std::optional(number) : std::nullopt;
}

}  // namespace

robotlink::Result<ParameterSpace> ParameterSpace::of(const std::vector<std::string>& texts,
                                                     const robotlink::SolutionDescription& solution,
                                                     const robotlink::SolutionParameters& parameters) {
  ParameterSpace space;
  space.solution_ = solution.task + "/" + solution.name;
  robotcontrol::ParameterValues described;
  parameters.describe(described);
  for (const std::string& text : texts) {
    const auto equals = text.find('='), colon = text.find(':', equals);
    Axis axis{.path = text.substr(0, equals)};
    if (std::ranges::find(space.axes_, axis.path, &Axis::path) != space.axes_.end())
      return wrongParameter(axis.path, "is named twice");
    const auto number =
        parameters.message() == nullptr ? std::nullopt : numberAt(*parameters.message(), axis.path);
    if (!number) return wrongParameter(axis.path, "is not a numeric parameter of " + space.solution_);
    axis.start = number->first;
    axis.isWhole = number->second;
    axis.low = std::min(axis.start / 2, axis.start * 2);
    axis.high = std::max(axis.start / 2, axis.start * 2);
    if (equals != std::string::npos) {
      const auto low = numberIn(text.substr(equals + 1, colon - equals - 1));
      const auto high = colon == std::string::npos ? std::nullopt : numberIn(text.substr(colon + 1));
      if (!low || !high) return wrongParameter(axis.path, "is given as NAME=LOW:HIGH");
      axis.low = *low;
      axis.high = *high;
    }
    if (!(axis.low < axis.high)) return wrongParameter(axis.path, "has no range; give it as NAME=LOW:HIGH");
    if (axis.start < axis.low || axis.start > axis.high)
      return wrongParameter(axis.path, fmt::format("is {:.6g} now, which is not between {:.6g} and {:.6g}; "
                                                   "give it a range that holds its present value",
                                                   axis.start, axis.low, axis.high));
    for (const auto& limits : described.limits()) {
      const robotlink::ParameterRange range{limits.minimum(), limits.maximum(), limits.above()};
      if (limits.path() == axis.path && (!range.has(axis.low) || !range.has(axis.high)))
        return wrongParameter(axis.path, "has to be " + range.describe());
    }
    space.axes_.push_back(axis);
  }
  return space;
}

std::vector<double> ParameterSpace::start() const {
  std::vector<double> point;
  for (const Axis& axis : axes_) point.push_back((axis.start - axis.low) / (axis.high - axis.low));
  return point;
}

std::vector<std::string> ParameterSpace::numbersAt(const std::vector<double>& point) const {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const double number = axes_[i].low + point[i] * (axes_[i].high - axes_[i].low);
    numbers.push_back(axes_[i].isWhole ? fmt::format("{:.0f}", number) : fmt::format("{:.6g}", number));
  }
  return numbers;
}

robotlink::Preset ParameterSpace::presetAt(const std::vector<double>& point) const {
  robotlink::Preset preset;
  auto& values = preset.parts[robotlink::Preset::kParameters].emplace();
  const auto numbers = numbersAt(point);
  for (std::size_t i = 0; i < axes_.size(); ++i) values[solution_ + " " + axes_[i].path] = numbers[i];
  return preset;
}

}  // namespace app
