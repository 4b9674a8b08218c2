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

namespace widgets {

/// Where a field is in a message: one step from each message to its field; for a repeated field also which
/// element.
struct FieldStep {
  const google::protobuf::FieldDescriptor* field = nullptr;
  int element = -1;  ///< -1: the field as a whole
};
using FieldPath = std::vector<FieldStep>;

// Reads and writes single values of any message by reflection. A path must fit the message.
bool isMessage(const FieldPath& path);
/// The message that a path (perhaps empty) leads to; unset ones read as their defaults.
const google::protobuf::Message& messageAt(const google::protobuf::Message& root, const FieldPath& path);
/// A number, bool or QString; enumerations by name. Invalid for messages and for lists as a whole.
QVariant valueAt(const google::protobuf::Message& root, const FieldPath& path);
/// False, and nothing is changed, where the value is none of the field's: a text that is no number, an
/// unknown name, out of range.
bool setValueAt(google::protobuf::Message& root, const FieldPath& path, const QVariant& value);
/// The names of an enumeration; empty for other fields.
QStringList choicesAt(const FieldPath& path);
/// "number", "whole number", ...: what to type, for tool tips.
QString typeName(const FieldPath& path);
/// "walk.step[2].x"
QString pathText(const FieldPath& path);

}  // namespace widgets
