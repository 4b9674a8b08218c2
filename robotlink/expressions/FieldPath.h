// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "robotlink/base/Error.h"

namespace google::protobuf {
class Descriptor;
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

namespace robotlink {

/// The value at a path: a number (a time is seconds, a list and bytes their length), or a text. Enumerations
/// and bools (0 or 1; "false" or "true") are both.
struct FieldValue {
  std::optional<double> number;
  std::optional<std::string> text;
  bool operator==(const FieldValue&) const = default;

  /// A number that tells values apart: the number itself; of a text a checksum of it, which is the same in
  /// all streams and programs (32 bits, FNV-1a). Empty if there is neither.
  std::optional<double> asNumber() const;
};

/// The way from a message to one of its values, as people write it: `position.x`, `joints[3].speed`,
/// `joints[-1].speed` (the last one), `joints[name="headPan"].position` (the first one with that name; in
/// short `joints[headPan].position`). A plain value, which fits any type that has these fields.
class FieldPath {
 public:
  /// Parses a path; FilePosition::column of errors counts from 1 in `text`.
  static Result<FieldPath> parse(std::string_view text);

  /// Fails, with a suggestion, if messages of this type have no such value.
  Result<void> fits(const google::protobuf::Descriptor& type) const;
  /// The value in a message. Empty if it has no such element, or if a field with presence is not set; also if
  /// the path does not fit the message's type.
  std::optional<FieldValue> valueIn(const google::protobuf::Message& message) const;
  /// In words, which element of a list a message does not have: "no element is named headPan". Empty: it has
  /// all on the way.
  std::string missingElement(const google::protobuf::Message& message) const;
  /// Returns the text of the path.
  const std::string& text() const { return text_; }
  bool operator==(const FieldPath& other) const { return text_ == other.text_; }

 private:
  /// The first element of a list whose field of this name has this value.
  struct Selector {
    std::string field, value;
  };
  /// A field and, for lists, the element; without one, a list means its length.
  struct Step {
    std::string field;
    std::variant<std::monostate, int, Selector> element;
    /// The position of the step in the text, from 1.
    int column = 1;
  };

  /// The value; `missing` is set to the step whose element is not there.
  std::optional<FieldValue> valueIn(const google::protobuf::Message& message, const Step*& missing) const;
  /// The index of the first such element; -1: there is none.
  static int elementOf(const google::protobuf::Message& message,
                       const google::protobuf::FieldDescriptor& list, const Selector& selector);

  std::string text_;
  std::vector<Step> steps_;
};

/// The number at a path; empty if there is none, whatever the reason.
std::optional<double> numberAt(const google::protobuf::Message& message, std::string_view path);

}  // namespace robotlink
