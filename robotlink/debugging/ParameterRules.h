// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace google::protobuf {
class Message;
}

namespace robotlink {

struct RobotSetup;

/// The range in which a parameter makes sense. A plain value.
struct ParameterRange {
  double minimum = 0;
  double maximum = std::numeric_limits<double>::infinity();
  /// Whether the minimum itself makes no sense.
  bool above = false;

  bool has(double value) const { return (above ? value > minimum : value >= minimum) && value <= maximum; }
  /// The range in words: "more than 0", "at least 1", "between 1 and 50".
  std::string describe() const;
};

/// A field of a parameter message, or of a message in it: the numbers of the fields on the way to it. Numbers
/// and not names, because rules are made before main(), when messages have no descriptors yet.
struct ParameterField {
  std::vector<int> path;
  ParameterField(int number) : path{number} {}  // NOLINT: most fields are the message's own
  ParameterField(std::initializer_list<int> numbers) : path(numbers) {}
  auto operator<=>(const ParameterField&) const = default;
};

/// The rules of a solution for its parameters, beyond their types.
struct ParameterRules {
  /// Makes a message with the built-in value of every field that has one, for a robot; empty: none has one.
  std::function<std::unique_ptr<google::protobuf::Message>(const RobotSetup&)> builtIn = {};
  /// Keyed by the field. Fields that are not listed take any value.
  std::map<ParameterField, ParameterRange> ranges = {};
  /// Says what else is wrong with a message of parameters whose numbers are in their ranges; empty: nothing.
  std::function<std::string(const google::protobuf::Message&)> check = {};
};

// Access to the numbers of a message by their fields: of type double, int32 or uint32.

/// Empty if the field is not set.
std::optional<double> numberIn(const google::protobuf::Message& message, const ParameterField& field);
void setNumber(google::protobuf::Message& message, const ParameterField& field, double value);
void clearNumber(google::protobuf::Message& message, const ParameterField& field);
/// The name of a field as users see it: "gait.maximum_x".
std::string nameOf(const google::protobuf::Message& message, const ParameterField& field);

}  // namespace robotlink
