// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace google::protobuf {
class Descriptor;
class Message;
}  // namespace google::protobuf

namespace robotlink {

// The numbers in a message of any type, for plots. A path names one: "position_in_robot.x",
// "joints[3].position", or, of elements that have a name, "joints[head/pan].position". Numbers, bools (0 or
// 1), enumerations (their numbers), and times and durations (in seconds) count. Any thread; nothing here
// fails otherwise than by finding nothing.

/// The paths of all numbers that messages of a type may have: up to five levels deep, the first 32 elements
/// of what is repeated, a thousand altogether.
std::vector<std::string> numericFields(const google::protobuf::Descriptor& type);

/// The paths of the numbers that this message has, elements by their names where they have one; a thousand at
/// most.
std::vector<std::string> numericFields(const google::protobuf::Message& message);

/// Nothing if there is no such number in this message: another type, an unset part, an index past the end.
std::optional<double> numberAt(const google::protobuf::Message& message, const std::string& path);

}  // namespace robotlink
