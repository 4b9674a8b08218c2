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

// Access to the numbers in messages of any type, for plots. A path names a number: "position_in_robot.x",
// "joints[3].position" or, for elements with a name, "joints[head/pan].position". Numbers, bools (0 or 1),
// enumerators (their values), timestamps and durations (in seconds) count. Any thread; nothing here fails
// except by finding nothing.

/// The paths of all numbers that messages of a type may have: up to five levels deep, the first 32 elements
/// of repeated fields, at most a thousand.
std::vector<std::string> numericFields(const google::protobuf::Descriptor& type);

/// The paths of the numbers in this message, with elements by name if they have one; at most a thousand.
std::vector<std::string> numericFields(const google::protobuf::Message& message);

/// Nothing if the message has no such number: another type, an unset part, an index past the end.
std::optional<double> numberAt(const google::protobuf::Message& message, const std::string& path);

}  // namespace robotlink
