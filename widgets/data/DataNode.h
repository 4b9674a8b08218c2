// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/process/Link.h"
#include "widgets/data/FieldText.h"

namespace widgets {

/// A row of the tree of all data: a robot, a stream of it, a field of the stream's messages, or elements of a
/// repeated field. Rows of fields have no values of their own: they find them in the stream's message when
/// they are painted. Repeated fields with more than kRange elements are divided into ranges.
struct DataNode {
  enum class Kind : std::uint8_t { kSession, kRobot, kStream, kField, kRange, kElement };
  /// The maximum number of elements listed in one place.
  static constexpr int kRange = 1000;

  DataNode() = default;
  DataNode(Kind nodeKind, DataNode* nodeParent) : kind(nodeKind), parent(nodeParent) {}

  Kind kind = Kind::kSession;
  /// Null for the session.
  DataNode* parent = nullptr;
  /// Index in the parent's children.
  int row = 0;
  /// The name of a robot, empty for the streams of no robot; the whole path of a stream.
  std::string name = {};
  /// The field of rows that are fields, ranges or elements. The stream's message keeps it alive.
  const google::protobuf::FieldDescriptor* field = nullptr;
  /// Index of an element; of a range that of its first one.
  int first = 0;
  /// Number of elements when the rows were last brought up to date.
  int count = 0;
  /// Whether there was something to unfold then.
  bool hasContents = false;
  /// Whether the children have been made, and whether they are shown and so brought up to date.
  bool isListed = false, isFollowed = false;
  std::vector<std::unique_ptr<DataNode>> children = {};

  // Only of streams.
  /// The debug key that publishes the stream; empty if it is published.
  std::string key = {};
  /// The message that is shown, and the one that it is compared with; null: none.
  robotlink::PackagePtr value = {}, other = {};

  /// The data computed of a value only when it changes: `own` and `other` are the messages that it was
  /// computed of.
  struct Computed {
    robotlink::PackagePtr own = {}, other = {};
    std::optional<QString> text = {};
    std::optional<bool> isChanged = {};
  };
  mutable Computed computed = {};

  bool isList() const;
  /// The stream that the row belongs to; null for robots.
  const DataNode* stream() const;
};

/// The places of a row's value, in the message that is shown and in the other one.
struct NodePlaces {
  FieldPlace own, other;
};
/// Elements are found in the other message by their names if they have some. Only of fields, ranges (which
/// give the whole field) and elements.
NodePlaces placesOf(const DataNode& node);

/// The message that a row unfolds into its fields, and its counterpart; null if there is none.
struct NodeMessages {
  const google::protobuf::Message* own = nullptr;
  const google::protobuf::Message* other = nullptr;
};
NodeMessages messagesOf(const DataNode& node);

/// The path of a field below its stream, as expressions and plots take it: "joints[head.pan].position"; empty
/// for robots and streams. A range has that of its list.
std::string fieldPathOf(const DataNode& node);
/// The path with its stream: "red1/joints/states.joints[head.pan].position".
QString pathTextOf(const DataNode& node);
/// Identifies a row: its path, elements by name if they have one, ranges by their first element. Unlike the
/// path it is found without a look at other elements, so elements of the same name share it.
QString rowKeyOf(const DataNode& node);
/// The text in the column of names: "position", "[3] head.pan", "[1000 … 1999]".
QString labelOf(const DataNode& node);

/// Whether two values differ. Timestamps do not count, since they differ in any two messages.
bool areDifferent(const google::protobuf::Message& a, const google::protobuf::Message& b);
bool areDifferent(const FieldPlace& a, const FieldPlace& b);
/// Whether any of `count` elements of two lists differ, from the element `first` on.
bool areDifferent(const FieldPlace& a, const FieldPlace& b, int first, int count);

}  // namespace widgets
