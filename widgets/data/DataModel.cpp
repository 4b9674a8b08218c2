// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/DataModel.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <set>

#include "robotlink/debugging/Streams.h"
#include "robotlink/session/RobotTables.h"
#include "widgets/TypedStreams.h"
#include "widgets/data/FieldJson.h"

namespace widgets {

DataModel::DataModel(QObject* parent) : QAbstractItemModel(parent), root_(std::make_unique<DataNode>()) {
  root_->isListed = root_->isFollowed = true;
}

DataModel::~DataModel() = default;

void DataModel::update(const robotlink::StreamStore& store, robotlink::Instant shown) {
  const bool isLater = store_ != &store || shown != shown_;
  store_ = &store;
  shown_ = shown;
  thumbnails_.tick();
  if (streams_.update(store)) mergeStreams();
  held_.clear();
  for (const std::string& robot : robots()) {
    if (auto held = robotlink::heldPackages(store, robot, shown); !held.empty())
      held_.emplace(robot, std::move(held));
  }
  for (const auto& robot : root_->children) {
    if (!robot->isFollowed) continue;
    for (const auto& stream : robot->children) {
      if (stream->isFollowed) follow(*stream);
    }
    if (isLater) announce(*robot);  // the ages of its streams
  }
}

void DataModel::setFollowed(const QModelIndex& index, bool isFollowed) {
  DataNode& node = nodeAt(index);
  node.isFollowed = isFollowed;
  if (!isFollowed) return;
  if (canFetchMore(index)) fetchMore(index);
  if (node.kind == DataNode::Kind::kStream) {
    follow(node);
  } else if (node.field != nullptr && node.isListed) {
    refresh(node);
  }
}

void DataModel::setWords(const QString& words) {
  beginResetModel();
  filter_.setWords(words);
  root_->children.clear();
  endResetModel();
  if (store_ != nullptr) mergeStreams();
}

void DataModel::setComparison(const DataComparison& comparison) {
  comparison_ = comparison;
  for (const auto& robot : root_->children) {
    for (const auto& stream : robot->children) {
      if (stream->isListed) follow(*stream);
    }
    announce(*robot);
  }
}

void DataModel::remember() {
  remembered_.clear();
  if (store_ == nullptr) return;
  for (const auto* stream : store_->streams()) {
    if (auto message = shownMessage(stream->path)) remembered_[stream->path] = std::move(message);
  }
  setComparison(comparison_);
}

void DataModel::mergeStreams() {
  std::vector<DataStream> robots;
  std::map<std::string, std::vector<DataStream>> found;
  for (const auto& [robot, streams] : streams_.robots()) {
    auto& listed = found[robot];
    std::ranges::copy_if(streams, std::back_inserter(listed), [this](const auto& s) { return isFound(s); });
    if (!listed.empty()) robots.push_back({robot});
  }
  merge(*root_, DataNode::Kind::kRobot, robots);
  for (const auto& robot : root_->children) merge(*robot, DataNode::Kind::kStream, found[robot->name]);
}

void DataModel::merge(DataNode& parent, DataNode::Kind kind, const std::vector<DataStream>& wanted) {
  const std::set<DataStream, decltype([](const DataStream& a, const DataStream& b) {
                   return std::tie(a.path, a.key) < std::tie(b.path, b.key);
                 })>
      names(wanted.begin(), wanted.end());
  const QModelIndex index = indexOf(parent);
  Children& children = parent.children;
  const auto number = [&children] {
    for (std::size_t i = 0; i < children.size(); ++i) children[i]->row = static_cast<int>(i);
  };
  for (int row = static_cast<int>(children.size()) - 1; row >= 0; --row) {
    const auto& child = children[static_cast<std::size_t>(row)];
    if (names.contains({child->name, child->key})) continue;
    beginRemoveRows(index, row, row);
    children.erase(children.begin() + row);
    number();
    endRemoveRows();
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i < children.size() && children[i]->name == wanted[i].path) continue;
    beginInsertRows(index, static_cast<int>(i), static_cast<int>(i));
    auto child = std::make_unique<DataNode>(kind, &parent);
    child->name = wanted[i].path;
    child->key = wanted[i].key;
    child->isListed = kind == DataNode::Kind::kRobot;
    children.insert(children.begin() + static_cast<std::ptrdiff_t>(i), std::move(child));
    number();
    endInsertRows();
  }
}

bool DataModel::isFound(const DataStream& stream) const {
  if (filter_.isEmpty()) return true;
  DataNode node(DataNode::Kind::kStream, nullptr);
  node.name = stream.path;
  const QString text = searched(node);
  if (filter_.finds(text)) return true;
  const robotlink::PackagePtr message = shownMessage(stream.path);
  return message != nullptr && filter_.findsWithin(text, *message);
}

robotlink::PackagePtr DataModel::shownMessage(const std::string& path) const {
  const auto* message = store_ == nullptr ? nullptr : store_->latest(path, shown_);
  return message == nullptr ? nullptr : message->value;
}

robotlink::PackagePtr DataModel::otherMessage(const std::string& path) const {
  const std::string robot = robotlink::streams::robotOf(path);
  const std::string below = robot.empty() ? path : path.substr(robot.size() + 1);
  switch (comparison_.with) {
    case DataComparison::With::kNothing:
      return nullptr;
    case DataComparison::With::kRobot:
      return robot.empty() || robot == comparison_.robot ? nullptr
                                                         : shownMessage(comparison_.robot + '/' + below);
    case DataComparison::With::kLogged:
      return robot.empty() ? nullptr : shownMessage(robot + '/' + robotlink::streams::kLogged + below);
    case DataComparison::With::kRemembered:
      break;
  }
  const auto found = remembered_.find(path);
  return found == remembered_.end() ? nullptr : found->second;
}

void DataModel::follow(DataNode& stream) {
  robotlink::PackagePtr value = shownMessage(stream.name);
  robotlink::PackagePtr other = otherMessage(stream.name);
  if (value == stream.value && other == stream.other) return;
  const auto typeOf = [](const robotlink::PackagePtr& message) {
    return message == nullptr ? nullptr : message->GetDescriptor();
  };
  const bool isSameType = typeOf(value) == typeOf(stream.value);
  if (!isSameType && stream.isListed) unlist(stream);
  stream.value = std::move(value);
  stream.other = std::move(other);
  if (!isSameType && stream.isFollowed) list(stream);
  refresh(stream);
}

const DataNode* DataModel::node(const QModelIndex& index) const {
  return index.isValid() ? static_cast<const DataNode*>(index.internalPointer()) : nullptr;
}

QModelIndex DataModel::find(const QString& row) const {
  std::vector<const DataNode*> unread{root_.get()};
  while (!unread.empty()) {
    const DataNode* at = unread.back();
    unread.pop_back();
    for (const auto& child : at->children) {
      const QString here = rowKeyOf(*child);
      if (here == row) return indexOf(*child);
      const bool isAbove = child->kind == DataNode::Kind::kRange || row.startsWith(here);
      if (isAbove) unread.push_back(child.get());
    }
  }
  return {};
}

QString DataModel::json(const QModelIndex& index) const {
  const DataNode* row = node(index);
  if (row == nullptr || row->kind == DataNode::Kind::kRobot) return {};
  if (row->kind != DataNode::Kind::kStream) return jsonOf(placesOf(*row).own);
  const robotlink::PackagePtr message = shownMessage(row->name);
  return message == nullptr ? QString() : jsonOf(*message);
}

std::vector<std::string> DataModel::robots() const {
  std::vector<std::string> names;
  for (const auto& [robot, streams] : streams_.robots()) {
    if (!robot.empty()) names.push_back(robot);
  }
  return names;
}

}  // namespace widgets
