// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/process/Link.h"

namespace robotcontrol {
class PortReading;
class PortReadings;
class WorldObject;
class WorldObjects;
}  // namespace robotcontrol

namespace widgets {

/// All objects of a scene as a tree, with the values of their ports. GUI thread.
class SceneTreeModel final : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { kName, kKind, kValue, kColumns };
  enum Role {
    /// The path of the object, QString.
    kPathRole = Qt::UserRole,
    /// The text that a search looks through: path, kind and type of the port.
    kFilterRole
  };

  explicit SceneTreeModel(QObject* parent = nullptr);
  ~SceneTreeModel() override;

  /// Shows these objects; null: none. Resets the model unless it is the same message.
  void setObjects(std::shared_ptr<const robotcontrol::WorldObjects> objects);
  /// Shows these readings of ports; null: none.
  void setReadings(std::shared_ptr<const robotcontrol::PortReadings> readings);

  const robotcontrol::WorldObject* object(const QModelIndex& index) const;
  /// Null if there is none of this path.
  const robotcontrol::WorldObject* object(const std::string& path) const;
  /// Invalid if there is none of this path.
  QModelIndex indexOf(const std::string& path) const;
  /// The actuators among an object and all that are below it.
  std::vector<const robotcontrol::WorldObject*> actuatorsOf(const QModelIndex& index) const;
  /// The values of a sensor, or the outcome of an actuator's last command; null: not known.
  const robotcontrol::PortReading* reading(const std::string& port) const;
  /// The values at which an actuator is held; null: it is not.
  const robotcontrol::PortReading* held(const std::string& port) const;

  /// Returns the name of a kind of object.
  static QString kindText(const robotcontrol::WorldObject& object);
  /// "0.5 rad", "0.1 0.2 9.8 m/s²", or of many values their number.
  static QString valuesText(const robotcontrol::PortReading& reading, const std::string& unit);

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& = {}) const override { return kColumns; }
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// A row; its number is its place in nodes_. Number 0 is the root, which shows nothing.
  struct Node {
    const robotcontrol::WorldObject* object = nullptr;
    int parent = 0, row = 0;
    std::vector<int> children;
  };
  void build();
  const Node& node(const QModelIndex& index) const;
  QString valueText(const robotcontrol::WorldObject& object) const;
  QString toolTip(const robotcontrol::WorldObject& object) const;
  /// Announces the values of those ports.
  void announceValues(const std::set<std::string>& ports);

  std::shared_ptr<const robotcontrol::WorldObjects> objects_;
  std::shared_ptr<const robotcontrol::PortReadings> readings_;
  std::vector<Node> nodes_;
  std::map<std::string, int> byPath_;
  /// The entries of readings_, keyed by port.
  using Readings = std::map<std::string, const robotcontrol::PortReading*>;
  Readings byPort_, heldByPort_;
};

}  // namespace widgets
