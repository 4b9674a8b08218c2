// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>

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

/// What a solution knows about its parameters beyond their types.
struct ParameterRules {
  /// Makes a message with the built-in value of every field that has one, for a robot; empty: none has one.
  std::function<std::unique_ptr<google::protobuf::Message>(const RobotSetup&)> builtIn = {};
  /// Keyed by the number of the field. Fields that are not listed take any value.
  std::map<int, ParameterRange> ranges = {};
};

// Access to the numbers of a message by the numbers of their fields.

/// The value of a field of type double or int32; empty if it is not set.
std::optional<double> numberIn(const google::protobuf::Message& message, int field);
/// Sets a field of type double or int32.
void setNumber(google::protobuf::Message& message, int field, double value);

}  // namespace robotlink
