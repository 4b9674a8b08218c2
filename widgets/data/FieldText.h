// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <optional>

namespace google::protobuf {
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

// Values in messages of any type as people read them. Pure functions; any thread.
namespace widgets {

/// A field of a message or, with an index, one element of a repeated field. It owns nothing; the message must
/// outlive it.
struct FieldPlace {
  /// The message that has the field; null: there is no such place.
  const google::protobuf::Message* holder = nullptr;
  const google::protobuf::FieldDescriptor* field = nullptr;
  /// Negative: the field as a whole.
  int element = -1;

  /// Whether the message has a value there: it has that element, or the field is not unset.
  bool isSet() const;
  /// Number of elements of a repeated field as a whole; 0 for others.
  int size() const;
  /// The message at the place; null if there is none, and for timestamps and durations, which are values.
  const google::protobuf::Message* message() const;
};

/// Whether a field holds messages with fields of their own, thus neither values nor times.
bool holdsMessages(const google::protobuf::FieldDescriptor& field);
/// Whether a field holds what can be plotted: numbers, bools, enumerations, times.
bool holdsNumbers(const google::protobuf::FieldDescriptor& field);

enum class Precision : std::uint8_t {
  /// Six digits, to be read.
  kShort,
  /// All digits that distinguish the number from others, to be copied.
  kFull,
};
/// A value: enumerations by name, bytes by their length, times readable. Empty for messages and lists.
QString valueText(const FieldPlace& place, Precision precision = Precision::kShort);
/// A value as a number: enumerations by number, times in s; empty for texts, bytes, messages and lists.
std::optional<double> numberOf(const FieldPlace& place);
/// The first plain fields of a message: "x 0.5, y -1".
QString summaryText(const google::protobuf::Message& message);
/// Elements of a repeated field, from `first`: their number and, of numbers, minimum, maximum and mean.
/// Infinite values are not counted in these.
QString statisticsText(const FieldPlace& list, int first, int count);
/// "double", "list of foxglove.JointState", for tooltips.
QString typeText(const google::protobuf::FieldDescriptor& field);

}  // namespace widgets
