// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/DataNode.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <type_traits>

#include "robotlink/debugging/Streams.h"
#include "robotlink/expressions/FieldPath.h"
#include "robotlink/expressions/NumericFields.h"
#include "robotlink/packages/FieldValues.h"
#include "robotlink/packages/PackageTitles.h"
#include "widgets/TypedStreams.h"

namespace widgets {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// The row of the field that a row belongs to: itself, or its list.
const DataNode& fieldNode(const DataNode& node) {
  const DataNode* at = &node;
  while (at->kind != DataNode::Kind::kField) at = at->parent;
  return *at;
}

/// The field of that name and kind in messages of another type, or of the same one.
const FieldDescriptor* counterpart(const Message& message, const FieldDescriptor& field) {
  if (field.containing_type() == message.GetDescriptor()) return &field;
  const FieldDescriptor* found = message.GetDescriptor()->FindFieldByName(field.name());
  const bool fits = found != nullptr && found->cpp_type() == field.cpp_type() &&
                    found->is_repeated() == field.is_repeated();
  return fits ? found : nullptr;
}

/// The element of the other list that belongs to an element: that of the same name, or of the same index.
int counterpart(const FieldPlace& element, const FieldPlace& otherList) {
  const Message* own = element.message();
  if (own == nullptr) return element.element;
  const std::string key = robotlink::elementKey(*own, element.element);
  const auto keyAt = [&](int index) {
    const Message* there = FieldPlace{otherList.holder, otherList.field, index}.message();
    return there == nullptr ? std::string() : robotlink::elementKey(*there, index);
  };
  const int size = otherList.size();
  if (element.element < size && keyAt(element.element) == key) return element.element;
  for (int i = 0; i < size; ++i) {
    if (keyAt(i) == key) return i;
  }
  return size;
}

/// The key of an element in a path: its name if that finds this element and no other one before it.
std::string pathKey(const FieldPlace& element) {
  const std::string index = std::to_string(element.element);
  const Message* message = element.message();
  if (message == nullptr) return index;
  const std::string key = robotlink::elementKey(*message, element.element);
  if (key == index) return index;
  for (int i = 0; i < element.element; ++i) {
    const Message* before = FieldPlace{element.holder, element.field, i}.message();
    if (before != nullptr && robotlink::elementKey(*before, i) == key) return index;
  }
  return key;
}

QString elementLabel(const FieldPlace& element) {
  const QString index = QStringLiteral("[%1]").arg(element.element);
  const Message* message = element.message();
  if (message == nullptr) return index;
  if (element.field->is_map())
    return QStringLiteral("[%1]").arg(valueText({message, message->GetDescriptor()->map_key()}));
  const QString key = QString::fromStdString(robotlink::elementKey(*message, element.element));
  return key == QString::number(element.element) ? index : index + QLatin1Char(' ') + key;
}

QString streamLabel(const DataNode& node) {
  const std::string robot = robotlink::streams::robotOf(node.name);
  const std::string below = robot.empty() ? node.name : node.name.substr(robot.size() + 1);
  return QString::fromStdString(robotlink::packageTitle(below));
}

bool isTimestamp(const FieldDescriptor& field) {
  return field.message_type() != nullptr && field.message_type()->full_name() == "google.protobuf.Timestamp";
}

}  // namespace

bool DataNode::isList() const {
  return kind == DataNode::Kind::kRange || (kind == DataNode::Kind::kField && field->is_repeated());
}

const DataNode* DataNode::stream() const {
  const DataNode* at = this;
  while (at != nullptr && at->kind != DataNode::Kind::kStream) at = at->parent;
  return at;
}

NodePlaces placesOf(const DataNode& node) {
  const NodeMessages holders = messagesOf(*fieldNode(node).parent);
  const bool isElement = node.kind == DataNode::Kind::kElement;
  NodePlaces places{{holders.own, node.field, isElement ? node.first : -1}, {}};
  if (holders.other == nullptr) return places;
  const FieldDescriptor* field = counterpart(*holders.other, *node.field);
  if (field == nullptr) return places;
  places.other = {holders.other, field, -1};
  if (isElement) places.other.element = counterpart(places.own, places.other);
  return places;
}

NodeMessages messagesOf(const DataNode& node) {
  if (node.kind == DataNode::Kind::kStream) return {node.value.get(), node.other.get()};
  if (node.field == nullptr || !holdsMessages(*node.field) || node.isList()) return {};
  const NodePlaces places = placesOf(node);
  return {places.own.message(), places.other.message()};
}

std::string fieldPathOf(const DataNode& node) {
  if (node.field == nullptr) return {};
  if (node.kind == DataNode::Kind::kRange) return fieldPathOf(*node.parent);
  if (node.kind == DataNode::Kind::kElement)
    return fieldPathOf(fieldNode(node)) + '[' + pathKey(placesOf(node).own) + ']';
  const std::string above = fieldPathOf(*node.parent);
  return above.empty() ? node.field->name() : above + '.' + node.field->name();
}

QString pathTextOf(const DataNode& node) {
  const DataNode* stream = node.stream();
  if (stream == nullptr) return QString::fromStdString(node.name);
  const std::string below = fieldPathOf(node);
  return QString::fromStdString(below.empty() ? stream->name : stream->name + '.' + below);
}

QString rowKeyOf(const DataNode& node) {
  switch (node.kind) {
    case DataNode::Kind::kField: {
      const QString name = QString::fromStdString(node.field->name());
      return rowKeyOf(*node.parent) + QLatin1Char('.') + name;
    }
    case DataNode::Kind::kRange:
      return rowKeyOf(*node.parent) + QStringLiteral("[%1...]").arg(node.first);
    case DataNode::Kind::kElement: {
      const FieldPlace place = placesOf(node).own;
      const Message* message = place.message();
      const std::string key =
          message == nullptr ? std::to_string(node.first) : robotlink::elementKey(*message, node.first);
      return QStringLiteral("%1[%2]").arg(rowKeyOf(fieldNode(node)), QString::fromStdString(key));
    }
    default:
      return QString::fromStdString(node.name);
  }
}

QString labelOf(const DataNode& node) {
  switch (node.kind) {
    case DataNode::Kind::kStream:
      return streamLabel(node);
    case DataNode::Kind::kField:
      return QString::fromStdString(node.field->name());
    case DataNode::Kind::kRange:
      return QStringLiteral("[%1 … %2]").arg(node.first).arg(node.first + node.count - 1);
    case DataNode::Kind::kElement:
      return elementLabel(placesOf(node).own);
    default:
      return QString::fromStdString(node.name);
  }
}

bool areDifferent(const Message& a, const Message& b) {
  for (int i = 0; i < a.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *a.GetDescriptor()->field(i);
    const FieldDescriptor* other = counterpart(b, field);
    if (other == nullptr || areDifferent({&a, &field}, {&b, other})) return true;
  }
  return false;
}

bool areDifferent(const FieldPlace& a, const FieldPlace& b, int first, int count) {
  for (int i = first; i < first + count; ++i) {
    if (areDifferent({a.holder, a.field, i}, {b.holder, b.field, i})) return true;
  }
  return false;
}

bool areDifferent(const FieldPlace& a, const FieldPlace& b) {
  if (a.field == nullptr || b.field == nullptr || isTimestamp(*a.field)) return false;
  if (a.isSet() != b.isSet()) return true;
  if (!a.isSet()) return false;
  if (a.field->is_repeated() && a.element < 0) {
    const int size = a.size();
    return size != b.size() || areDifferent(a, b, 0, size);
  }
  const Message* inA = a.message();
  const Message* inB = b.message();
  if (inA != nullptr && inB != nullptr) return areDifferent(*inA, *inB);
  return robotlink::visitValue(*a.holder, *a.field, a.element, [&](const auto& own) {
    using Value = std::decay_t<decltype(own)>;
    return robotlink::visitValue(*b.holder, *b.field, b.element, [&](const auto& theirs) {
      if constexpr (!std::is_same_v<Value, std::decay_t<decltype(theirs)>>) {
        return true;
      } else if constexpr (std::is_same_v<Value, robotlink::EnumNumber>) {
        return own.number != theirs.number;
      } else if constexpr (std::is_base_of_v<Message, Value>) {
        return robotlink::wholeSeconds(own) != robotlink::wholeSeconds(theirs) ||
               robotlink::nanoseconds(own) != robotlink::nanoseconds(theirs);
      } else {
        return own != theirs;
      }
    });
  });
}

}  // namespace widgets
