// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/keys/KeyTreeModel.h"

#include <QFont>
#include <QGuiApplication>
#include <algorithm>
#include <functional>

#include "widgets/Theme.h"

namespace widgets {

struct KeyTreeModel::Node {
  QString label;
  std::string path;
  Node* parent = nullptr;
  int row = 0;
  int key = -1;  // index into keys_; -1: a group
  std::vector<std::unique_ptr<Node>> children;

  Node& child(const std::string& part) {
    const QString wanted = QString::fromStdString(part);
    for (auto& node : children) {
      if (node->label == wanted) return *node;
    }
    auto& added = children.emplace_back(std::make_unique<Node>());
    added->label = wanted;
    added->path = path.empty() ? part : path + '/' + part;
    added->parent = this;
    added->row = static_cast<int>(children.size()) - 1;
    return *added;
  }
};

namespace {

/// Adds a useful default if the mode has a number and none was set.
KeyValue withNumber(KeyValue value) {
  if (!hasNumber(value.kind)) {
    value.n = 0;
  } else if (value.n == 0) {
    value.n = value.kind == KeyValue::Kind::kTimes ? 1 : value.kind == KeyValue::Kind::kEveryNth ? 10 : 1000;
  }
  return value;
}

bool sameNames(const std::vector<KeyEntry>& a, const std::vector<KeyEntry>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const KeyEntry& x, const KeyEntry& y) { return x.name == y.name; });
}

}  // namespace

KeyTreeModel::KeyTreeModel(QObject* parent) : QAbstractItemModel(parent), root_(std::make_unique<Node>()) {}
KeyTreeModel::~KeyTreeModel() = default;

void KeyTreeModel::setKeys(std::vector<KeyEntry> keys) {
  pending_.clear();
  if (!sameNames(keys, keys_)) {
    beginResetModel();
    keys_ = std::move(keys);
    refusals_.clear();
    build();
    endResetModel();
    return;
  }
  keys_ = std::move(keys);
  for (const KeyEntry& key : keys_) changed(key.name);
}

void KeyTreeModel::build() {
  root_ = std::make_unique<Node>();
  nodes_.clear();
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    Node* node = root_.get();
    const std::string& name = keys_[i].name;
    for (std::size_t begin = 0; begin <= name.size();) {
      const std::size_t end = std::min(name.find('/', begin), name.size());
      node = &node->child(name.substr(begin, end - begin));
      begin = end + 1;
    }
    node->key = static_cast<int>(i);
    nodes_[name] = node;
  }
}

KeyValue KeyTreeModel::shownValue(const KeyEntry& key) const {
  const auto pending = pending_.find(key.name);
  return pending == pending_.end() ? key.value : pending->second;
}

void KeyTreeModel::choose(const std::string& key, KeyValue value) {
  value = withNumber(value);
  pending_[key] = value;
  refusals_.erase(key);
  changed(key);
  Q_EMIT keyChosen(QString::fromStdString(key), value);
}

void KeyTreeModel::forget() {
  pending_.clear();
  refusals_.clear();
}

void KeyTreeModel::refuse(const std::string& key, const QString& reason) {
  pending_.erase(key);
  refusals_[key] = reason;
  changed(key);
}

void KeyTreeModel::changed(const std::string& key) {
  const auto found = nodes_.find(key);
  if (found == nodes_.end()) return;
  for (const Node* node = found->second; node != root_.get(); node = node->parent) {
    auto* shown = const_cast<Node*>(node);
    Q_EMIT dataChanged(createIndex(node->row, kName, shown), createIndex(node->row, kNumber, shown));
  }
}

std::vector<std::string> KeyTreeModel::keysBelow(const QModelIndex& index) const {
  std::vector<std::string> names;
  const std::function<void(const Node&)> collect = [&](const Node& node) {
    if (node.key >= 0) names.push_back(keys_[static_cast<std::size_t>(node.key)].name);
    for (const auto& child : node.children) collect(*child);
  };
  collect(nodeOf(index));
  return names;
}

const KeyTreeModel::Node& KeyTreeModel::nodeOf(const QModelIndex& index) const {
  return index.isValid() ? *static_cast<const Node*>(index.internalPointer()) : *root_;
}

const KeyEntry* KeyTreeModel::entryOf(const QModelIndex& index) const {
  const Node& node = nodeOf(index);
  return node.key < 0 ? nullptr : &keys_[static_cast<std::size_t>(node.key)];
}

QModelIndex KeyTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, nodeOf(parent).children[static_cast<std::size_t>(row)].get());
}

QModelIndex KeyTreeModel::parent(const QModelIndex& child) const {
  if (!child.isValid()) return {};
  Node* parent = nodeOf(child).parent;
  return parent == root_.get() ? QModelIndex() : createIndex(parent->row, 0, parent);
}

int KeyTreeModel::rowCount(const QModelIndex& parent) const {
  return parent.column() > 0 ? 0 : static_cast<int>(nodeOf(parent).children.size());
}

int KeyTreeModel::columnCount(const QModelIndex&) const {
  return kColumns;
}

int KeyTreeModel::activeBelow(const Node& node, int& all) const {
  int active = 0;
  if (node.key >= 0) {
    ++all;
    active += shownValue(keys_[static_cast<std::size_t>(node.key)]).kind != KeyValue::Kind::kOff ? 1 : 0;
  }
  for (const auto& child : node.children) active += activeBelow(*child, all);
  return active;
}

QString KeyTreeModel::display(const Node& node, int column) const {
  if (column == kName) return node.label;
  if (node.key >= 0) {
    const KeyValue value = shownValue(keys_[static_cast<std::size_t>(node.key)]);
    return column == kMode ? kindName(value.kind) : keyValueText(value);
  }
  int all = 0;
  const int active = column == kMode ? activeBelow(node, all) : 0;
  return active > 0 ? tr("%1 of %2 on").arg(active).arg(all) : QString();
}

QString KeyTreeModel::toolTip(const KeyEntry& key) const {
  QStringList lines{QStringLiteral("<b>%1</b>").arg(QString::fromStdString(key.name).toHtmlEscaped())};
  lines << key.help.toHtmlEscaped();
  if (!key.solutions.isEmpty()) lines << tr("Used by: %1").arg(key.solutions.join(QStringLiteral(", ")));
  if (!key.inUse) {
    lines << tr(
        "Inactive: none of its solutions is running. What you set takes effect when one is switched on.");
  }
  if (!key.clients.isEmpty())
    lines << tr("Requested by: %1").arg(key.clients.join(QStringLiteral(", ")).toHtmlEscaped());
  const auto refusal = refusals_.find(key.name);
  if (refusal != refusals_.end()) lines << tr("Refused: %1").arg(refusal->second.toHtmlEscaped());
  return lines.join(QStringLiteral("<br>"));
}

QVariant KeyTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Node& node = nodeOf(index);
  const KeyEntry* key = entryOf(index);
  int all = 0;
  switch (role) {
    case Qt::DisplayRole:
      return display(node, index.column());
    case kKeyRole:
      return QString::fromStdString(node.path);
    case kActiveRole:
      return activeBelow(node, all) > 0;
    default:
      break;
  }
  if (key == nullptr) return {};
  const KeyValue value = shownValue(*key);
  switch (role) {
    case kKindRole:
      return static_cast<int>(value.kind);
    case Qt::EditRole:
      return index.column() == kNumber ? static_cast<int>(value.n) : static_cast<int>(value.kind);
    case Qt::ToolTipRole:
      return toolTip(*key);
    case Qt::ForegroundRole:
      if (refusals_.count(key->name) > 0) return colorOf(Meaning::kBad, QGuiApplication::palette());
      return key->inUse ? QVariant() : colorOf(Meaning::kMuted, QGuiApplication::palette());
    case Qt::FontRole: {
      QFont font;
      font.setItalic(pending_.count(key->name) > 0);
      font.setBold(index.column() == kName && value.kind != KeyValue::Kind::kOff);
      return font;
    }
    default:
      return {};
  }
}

QVariant KeyTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == kName ? tr("Key") : section == kMode ? tr("Mode") : tr("n");
}

Qt::ItemFlags KeyTreeModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractItemModel::flags(index);
  const KeyEntry* key = index.isValid() ? entryOf(index) : nullptr;
  if (key == nullptr) return flags;
  const bool editable =
      index.column() == kMode || (index.column() == kNumber && hasNumber(shownValue(*key).kind));
  return editable ? flags | Qt::ItemIsEditable : flags;
}

bool KeyTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const KeyEntry* key = index.isValid() ? entryOf(index) : nullptr;
  if (key == nullptr || role != Qt::EditRole) return false;
  KeyValue chosen = shownValue(*key);
  if (index.column() == kMode) {
    const auto kind = static_cast<KeyValue::Kind>(std::clamp(value.toInt(), 0, 4));
    if (kind == chosen.kind) return false;
    chosen = {kind, 0};
  } else if (index.column() == kNumber && hasNumber(chosen.kind) && value.toInt() > 0) {
    chosen.n = value.toUInt();
  } else {
    return false;
  }
  choose(std::string(key->name), chosen);
  return true;
}

}  // namespace widgets
