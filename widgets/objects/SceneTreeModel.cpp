// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/SceneTreeModel.h"

#include <algorithm>

#include "robotcontrol/World.pb.h"
#include "widgets/Counted.h"
#include "widgets/ports/PortNumber.h"

namespace widgets {

using robotcontrol::WorldObject;

namespace {

constexpr int kMaxShownValues = 4;
/// No port has more numbers that differ.
constexpr int kMaxShownRanges = 16;

}  // namespace

SceneTreeModel::SceneTreeModel(QObject* parent) : QAbstractItemModel(parent), nodes_(1) {}
SceneTreeModel::~SceneTreeModel() = default;

void SceneTreeModel::setObjects(std::shared_ptr<const robotcontrol::WorldObjects> objects) {
  if (objects == objects_) return;
  beginResetModel();
  objects_ = std::move(objects);
  build();
  endResetModel();
}

void SceneTreeModel::build() {
  nodes_.assign(1, {});
  byPath_.clear();
  if (!objects_) return;
  for (const WorldObject& object : objects_->objects()) {
    // The first one counts, should a path be there twice.
    if (!byPath_.emplace(object.path(), static_cast<int>(nodes_.size())).second) continue;
    nodes_.push_back({&object, 0, 0, {}});
  }
  const int count = static_cast<int>(nodes_.size());
  for (int i = 1; i < count; ++i) {
    const auto parent = byPath_.find(nodes_[static_cast<std::size_t>(i)].object->parent());
    if (parent != byPath_.end()) nodes_[static_cast<std::size_t>(i)].parent = parent->second;
  }
  // An object that is its own ancestor, as in damaged messages, is put at the root.
  for (int i = 1; i < count; ++i) {
    int at = nodes_[static_cast<std::size_t>(i)].parent;
    for (int steps = 0; at != 0 && at != i && steps < count; ++steps)
      at = nodes_[static_cast<std::size_t>(at)].parent;
    if (at != 0) nodes_[static_cast<std::size_t>(i)].parent = 0;
  }
  for (int i = 1; i < count; ++i) {
    Node& child = nodes_[static_cast<std::size_t>(i)];
    auto& siblings = nodes_[static_cast<std::size_t>(child.parent)].children;
    child.row = static_cast<int>(siblings.size());
    siblings.push_back(i);
  }
}

void SceneTreeModel::setReadings(std::shared_ptr<const robotcontrol::PortReadings> readings) {
  if (readings == readings_) return;
  std::set<std::string> changed;
  const auto noteChanged = [&] {
    for (const Readings* all : {&byPort_, &heldByPort_})
      for (const auto& [port, reading] : *all) changed.insert(port);
  };
  noteChanged();
  readings_ = std::move(readings);
  byPort_.clear();
  heldByPort_.clear();
  if (readings_) {
    for (const auto& reading : readings_->readings()) byPort_[reading.port()] = &reading;
    for (const auto& reading : readings_->held()) heldByPort_[reading.port()] = &reading;
  }
  noteChanged();
  announceValues(changed);
}

void SceneTreeModel::announceValues(const std::set<std::string>& ports) {
  for (const std::string& port : ports) {
    // An object with a port has its path.
    const QModelIndex row = indexOf(port);
    if (!row.isValid()) continue;
    const QModelIndex value = row.siblingAtColumn(kValue);
    Q_EMIT dataChanged(value, value, {Qt::DisplayRole});
  }
}

const SceneTreeModel::Node& SceneTreeModel::node(const QModelIndex& index) const {
  return nodes_[index.isValid() ? static_cast<std::size_t>(index.internalId()) : 0];
}

const WorldObject* SceneTreeModel::object(const QModelIndex& index) const {
  return node(index).object;
}

const WorldObject* SceneTreeModel::object(const std::string& path) const {
  const auto found = byPath_.find(path);
  return found == byPath_.end() ? nullptr : nodes_[static_cast<std::size_t>(found->second)].object;
}

QModelIndex SceneTreeModel::indexOf(const std::string& path) const {
  const auto found = byPath_.find(path);
  if (found == byPath_.end()) return {};
  return createIndex(nodes_[static_cast<std::size_t>(found->second)].row, 0,
                     static_cast<quintptr>(found->second));
}

std::vector<const WorldObject*> SceneTreeModel::actuatorsOf(const QModelIndex& index) const {
  std::vector<const WorldObject*> actuators;
  if (!index.isValid()) return actuators;
  std::vector<int> open{static_cast<int>(index.internalId())};
  while (!open.empty()) {
    const Node& next = nodes_[static_cast<std::size_t>(open.back())];
    open.pop_back();
    if (next.object->has_port() && next.object->port().is_actuator()) actuators.push_back(next.object);
    open.insert(open.end(), next.children.rbegin(), next.children.rend());
  }
  return actuators;
}

const robotcontrol::PortReading* SceneTreeModel::reading(const std::string& port) const {
  const auto found = byPort_.find(port);
  return found == byPort_.end() ? nullptr : found->second;
}

const robotcontrol::PortReading* SceneTreeModel::held(const std::string& port) const {
  const auto found = heldByPort_.find(port);
  return found == heldByPort_.end() ? nullptr : found->second;
}

QString SceneTreeModel::kindText(const WorldObject& object) {
  switch (object.kind()) {
    case WorldObject::ROBOT:
      return tr("robot");
    case WorldObject::BALL:
      return tr("ball");
    case WorldObject::FIELD:
      return tr("field");
    case WorldObject::MODEL:
      return tr("model");
    case WorldObject::LINK:
      return tr("link");
    case WorldObject::JOINT:
      return tr("joint");
    case WorldObject::SHAPE:
      return tr("shape");
    case WorldObject::SOLID:
      return tr("solid");
    case WorldObject::SENSOR:
      return tr("sensor");
    case WorldObject::ACTUATOR:
      return tr("actuator");
    case WorldObject::LIGHT:
      return tr("light");
    case WorldObject::CONTROLLER:
      return tr("controller");
    default:
      return {};
  }
}

QString SceneTreeModel::valuesText(const robotcontrol::PortReading& reading, const std::string& unit) {
  if (reading.values_size() > kMaxShownValues)
    return counted(reading.values_size(), tr("1 value"), tr("%1 values"));
  QStringList values;
  for (const double value : reading.values()) values << QString::number(value, 'g', 4);
  if (!unit.empty()) values << QString::fromStdString(unit);
  return values.join(QLatin1Char(' '));
}

QString SceneTreeModel::valueText(const WorldObject& object) const {
  if (!object.has_port()) return {};
  const robotcontrol::WorldPort& port = object.port();
  if (port.is_actuator()) {
    const auto* values = held(port.path());
    return values == nullptr ? QString() : tr("%1, held").arg(valuesText(*values, port.unit()));
  }
  if (const auto* values = reading(port.path())) return valuesText(*values, port.unit());
  if (!port.image_stream().empty() && port.shape_size() >= 2)
    return QStringLiteral("%1 × %2").arg(port.shape(1)).arg(port.shape(0));
  return QStringLiteral("–");
}

QString SceneTreeModel::toolTip(const WorldObject& object) const {
  QString text = QStringLiteral("%1 (%2)").arg(QString::fromStdString(object.path()), kindText(object));
  if (!object.has_port()) return text;
  const robotcontrol::WorldPort& port = object.port();
  text += QStringLiteral("\n") + QString::fromStdString(port.type());
  // Many numbers have one range.
  QStringList ranges;
  for (int i = 0; i < std::min(numberCount(port), kMaxShownRanges); ++i) {
    const PortNumber number = portNumber(object, i);
    QString range = QString::fromStdString(number.unit);
    if (number.hasRange())
      range = QStringLiteral("%1 … %2 %3")
                  .arg(number.minimum, 0, 'g', 4)
                  .arg(number.maximum, 0, 'g', 4)
                  .arg(range);
    if (!range.isEmpty() && (ranges.isEmpty() || ranges.last() != range)) ranges << range.trimmed();
  }
  return ranges.isEmpty() ? text : text + QStringLiteral(": ") + ranges.join(QStringLiteral("; "));
}

QModelIndex SceneTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column,
                     static_cast<quintptr>(node(parent).children[static_cast<std::size_t>(row)]));
}

QModelIndex SceneTreeModel::parent(const QModelIndex& index) const {
  const int parent = index.isValid() ? node(index).parent : 0;
  if (parent == 0) return {};
  return createIndex(nodes_[static_cast<std::size_t>(parent)].row, 0, static_cast<quintptr>(parent));
}

int SceneTreeModel::rowCount(const QModelIndex& parent) const {
  return parent.column() > 0 ? 0 : static_cast<int>(node(parent).children.size());
}

QVariant SceneTreeModel::data(const QModelIndex& index, int role) const {
  const WorldObject* object = node(index).object;
  if (object == nullptr) return {};
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == kName) return QString::fromStdString(object->name());
      return index.column() == kKind ? kindText(*object) : valueText(*object);
    case Qt::ToolTipRole:
      return toolTip(*object);
    case kPathRole:
      return QString::fromStdString(object->path());
    case kFilterRole:
      return QString::fromStdString(object->path() + ' ' + object->port().type()) + QLatin1Char(' ') +
             kindText(*object);
    default:
      return {};
  }
}

QVariant SceneTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  if (section == kName) return tr("Object");
  if (section == kKind) return tr("Kind");
  return section == kValue ? QVariant(tr("Value")) : QVariant();
}

}  // namespace widgets
