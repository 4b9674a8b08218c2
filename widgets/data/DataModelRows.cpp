// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>

#include "widgets/data/DataModel.h"

// The rows of a DataModel: how they are made, and follow the messages.
namespace widgets {

namespace {

/// Returns the number of rows for a list of `count` elements: elements, or ranges of them.
int rowsOfList(int count) {
  return count <= DataNode::kRange ? count : (count + DataNode::kRange - 1) / DataNode::kRange;
}

std::unique_ptr<DataNode> rowOfList(DataNode& list, int row) {
  const bool hasRanges = list.count > DataNode::kRange;
  auto node =
      std::make_unique<DataNode>(hasRanges ? DataNode::Kind::kRange : DataNode::Kind::kElement, &list);
  node->field = list.field;
  node->first = list.first + (hasRanges ? row * DataNode::kRange : row);
  node->count = hasRanges ? std::min(DataNode::kRange, list.first + list.count - node->first) : 0;
  return node;
}

}  // namespace

QModelIndex DataModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, nodeAt(parent).children[static_cast<std::size_t>(row)].get());
}

QModelIndex DataModel::parent(const QModelIndex& child) const {
  return child.isValid() ? indexOf(*nodeAt(child).parent) : QModelIndex();
}

int DataModel::rowCount(const QModelIndex& parent) const {
  return parent.column() > 0 ? 0 : static_cast<int>(nodeAt(parent).children.size());
}

int DataModel::columnCount(const QModelIndex&) const {
  return kColumns;
}

bool DataModel::hasChildren(const QModelIndex& parent) const {
  if (parent.column() > 0) return false;
  const DataNode& node = nodeAt(parent);
  return node.isListed ? !node.children.empty() : hasContents(node);
}

bool DataModel::canFetchMore(const QModelIndex& parent) const {
  const DataNode& node = nodeAt(parent);
  return parent.column() <= 0 && !node.isListed && hasContents(node);
}

void DataModel::fetchMore(const QModelIndex& parent) {
  DataNode& node = nodeAt(parent);
  if (node.kind == DataNode::Kind::kStream) {
    node.value = shownMessage(node.name);
    node.other = otherMessage(node.name);
  }
  if (!node.isListed) list(node);
}

DataNode& DataModel::nodeAt(const QModelIndex& index) const {
  return index.isValid() ? *static_cast<DataNode*>(index.internalPointer()) : *root_;
}

QModelIndex DataModel::indexOf(const DataNode& node) const {
  return node.parent == nullptr ? QModelIndex() : createIndex(node.row, 0, const_cast<DataNode*>(&node));
}

bool DataModel::hasContents(const DataNode& node) const {
  if (node.kind == DataNode::Kind::kStream) return node.key.empty();
  if (node.kind == DataNode::Kind::kRange) return true;
  if (node.field == nullptr) return !node.children.empty();
  const FieldPlace place = placesOf(node).own;
  if (node.isList()) return place.size() > 0;
  const auto* message = place.message();
  return message != nullptr && message->GetDescriptor()->field_count() > 0;
}

DataModel::Children DataModel::childrenOf(DataNode& node) const {
  return node.isList() ? elementsOf(node) : fieldsOf(node);
}

DataModel::Children DataModel::fieldsOf(DataNode& node) const {
  Children children;
  const auto* message = messagesOf(node).own;
  if (message == nullptr) return children;
  for (int i = 0; i < message->GetDescriptor()->field_count(); ++i) {
    auto child = std::make_unique<DataNode>(DataNode::Kind::kField, &node);
    child->field = message->GetDescriptor()->field(i);
    child->count = placesOf(*child).own.size();
    child->hasContents = hasContents(*child);
    if (isListed(*child)) children.push_back(std::move(child));
  }
  return children;
}

DataModel::Children DataModel::elementsOf(DataNode& node) const {
  Children children;
  for (int row = 0; row < rowsOfList(node.count); ++row) {
    auto child = rowOfList(node, row);
    if (isListed(*child)) children.push_back(std::move(child));
  }
  return children;
}

QString DataModel::searched(const DataNode& node) const {
  QString path = pathTextOf(node);
  const DataNode* stream = node.stream();
  if (stream != nullptr) path += QLatin1Char(' ') + labelOf(*stream);
  return path;
}

bool DataModel::isListed(const DataNode& node) const {
  if (filter_.isEmpty() || filter_.finds(searched(node))) return true;  // paths contain those above them
  const auto* message = messagesOf(node).own;
  if (message != nullptr) return filter_.findsWithin(searched(node), *message);
  if (!node.isList()) return false;
  DataNode list = DataNode(node.kind, node.parent);
  list.field = node.field;
  list.first = node.first;
  list.count = node.count;
  for (int row = 0; row < rowsOfList(list.count); ++row) {
    if (isListed(*rowOfList(list, row))) return true;
  }
  return false;
}

void DataModel::list(DataNode& node) {
  node.isListed = true;
  insert(node, childrenOf(node));
}

void DataModel::unlist(DataNode& node) {
  remove(node, 0);
  node.isListed = false;
}

void DataModel::insert(DataNode& parent, Children children) {
  if (children.empty()) return;
  const int first = static_cast<int>(parent.children.size());
  beginInsertRows(indexOf(parent), first, first + static_cast<int>(children.size()) - 1);
  for (auto& child : children) {
    child->row = static_cast<int>(parent.children.size());
    parent.children.push_back(std::move(child));
  }
  endInsertRows();
}

void DataModel::remove(DataNode& parent, int from) {
  if (from >= static_cast<int>(parent.children.size())) return;
  beginRemoveRows(indexOf(parent), from, static_cast<int>(parent.children.size()) - 1);
  parent.children.resize(static_cast<std::size_t>(from));
  endRemoveRows();
}

void DataModel::refresh(DataNode& node) {
  if (!node.isListed) return;
  if (node.kind == DataNode::Kind::kRange) {
    announce(node);
    return;
  }
  for (const auto& child : node.children) {
    if (child->kind == DataNode::Kind::kField) {
      const bool hadContents = std::exchange(child->hasContents, hasContents(*child));
      const int count = placesOf(*child).own.size();
      if (child->field->is_repeated()) {
        refreshList(*child, count);
      } else if (hadContents && !child->hasContents) {
        unlist(*child);
      } else if (!hadContents && child->hasContents) {
        list(*child);  // the tree learns from new rows that there is something to unfold
      }
    }
    if (child->isListed && child->isFollowed) refresh(*child);
  }
  announce(node);
}

void DataModel::refreshList(DataNode& list, int count) {
  const int before = std::exchange(list.count, count);
  if (before == count) return;
  if (!list.isListed) {
    if (before == 0 || count == 0) this->list(list);  // see refresh()
    return;
  }
  const bool keepsRows = (before > DataNode::kRange) == (count > DataNode::kRange) && filter_.isEmpty();
  if (!keepsRows) remove(list, 0);
  const int rows = rowsOfList(count);
  remove(list, rows);
  // The last range may have another length than before.
  if (count > DataNode::kRange && !list.children.empty()) {
    DataNode& last = *list.children.back();
    refreshList(last, std::min(DataNode::kRange, count - last.first));
  }
  Children added;
  for (int row = static_cast<int>(list.children.size()); row < rows; ++row) {
    auto child = rowOfList(list, row);
    if (isListed(*child)) added.push_back(std::move(child));
  }
  insert(list, std::move(added));
}

void DataModel::announce(const DataNode& parent) {
  const int rows = static_cast<int>(parent.children.size());
  if (rows == 0) return;
  const QModelIndex index = indexOf(parent);
  Q_EMIT dataChanged(this->index(0, 0, index), this->index(rows - 1, kColumns - 1, index));
}

}  // namespace widgets
