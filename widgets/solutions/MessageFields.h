// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QVariant>
#include <memory>
#include <vector>

namespace google::protobuf {
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

// Access to single values of any protobuf message by reflection, for the tree of parameters.
namespace widgets {

/// A step of a path: from a message to one of its fields and, for a repeated field, to an element.
struct FieldStep {
  const google::protobuf::FieldDescriptor* field = nullptr;
  /// Index of the element; -1: the field is not repeated, or is used as a whole.
  int element = -1;
};
/// The path from a root message to a value. It is valid for messages of one type only and as long as its
/// descriptors live.
using FieldPath = std::vector<FieldStep>;

/// Whether the path leads to a message; the empty path does.
bool isMessage(const FieldPath& path);
/// The message at a path (which may be empty). Messages that are unset, and elements past the end, read as
/// defaults.
const google::protobuf::Message& messageAt(const google::protobuf::Message& root, const FieldPath& path);
/// A number, bool or QString; enumerations by name. Invalid for messages, for lists as a whole, and for
/// elements past the end.
QVariant valueAt(const google::protobuf::Message& root, const FieldPath& path);
/// Sets a value. False, without a change, if `value` does not fit the field: a text that is no number, an
/// unknown name, out of range, or the field is a message, a list or bytes.
bool setValueAt(google::protobuf::Message& root, const FieldPath& path, const QVariant& value);
/// Names of the field's enumeration; empty for other types.
QStringList choicesAt(const FieldPath& path);
/// "number", "whole number", ...: what can be typed, for tooltips; translated.
QString typeName(const FieldPath& path);
/// "walk.step[2].x"
QString pathText(const FieldPath& path);

}  // namespace widgets
