// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace google::protobuf {
class Descriptor;
class Message;
}  // namespace google::protobuf

namespace robotlink {

// Lists of the numbers in messages of any type, for plots, as paths that FieldPath reads:
// "position_in_robot.x", "joints[3].position" or, for elements with a name, "joints[headPan].position". Any
// thread.

/// Selects the fields to be listed; bools, enumerations and times are numbers.
enum class FieldChoice : std::uint8_t { kNumbers, kNumbersAndTexts };

/// The paths of all numbers that messages of a type may have: up to five levels deep, the first 32 elements
/// of repeated fields, at most a thousand.
std::vector<std::string> numericFields(const google::protobuf::Descriptor& type,
                                       FieldChoice choice = FieldChoice::kNumbers);

/// The paths of the numbers in this message, with elements by name if they have one; at most a thousand.
std::vector<std::string> numericFields(const google::protobuf::Message& message,
                                       FieldChoice choice = FieldChoice::kNumbers);

/// Returns the text in the brackets behind a repeated field for one of its elements: its name if it has one
/// that a path can contain, otherwise its index.
std::string elementKey(const google::protobuf::Message& element, int index);

}  // namespace robotlink
