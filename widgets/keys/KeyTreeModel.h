// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <map>
#include <memory>
#include <optional>

#include "widgets/keys/KeyEntries.h"

namespace widgets {

/// The debug keys of one robot as a tree by the parts of their names ("ball-percept/circle"). An edit does
/// not change the keys: the new mode is shown in italics as pending, keyChosen() lets the owner request it,
/// and the next table from the robot, or refuse(), settles it. Keys that no running solution queries are gray
/// and can be set nevertheless. GUI thread.
class KeyTreeModel final : public QAbstractItemModel {
  Q_OBJECT
 public:
  /// Name, mode, and the mode's number.
  enum Column { kName, kMode, kNumber, kColumns };
  enum Role {
    /// The key's whole name; for a group the names' common part (QString).
    kKeyRole = Qt::UserRole + 1,
    /// KeyValue::Kind as int; invalid for groups.
    kKindRole,
    /// Whether this key, or a key below this group, is not off (bool).
    kActiveRole,
  };

  explicit KeyTreeModel(QObject* parent = nullptr);
  ~KeyTreeModel() override;

  /// Replaces the keys and drops all pending modes. Rows, and so selection and expansion, are kept if the
  /// names are the same.
  void setKeys(std::vector<KeyEntry> keys);
  const std::vector<KeyEntry>& keys() const { return keys_; }
  /// The pending mode of the key if there is one, else its mode.
  KeyValue shownValue(const KeyEntry& key) const;
  /// Forgets what was requested and refused; call this before the keys of another robot are set.
  void forget();
  /// Drops the pending mode of a key; the reason is shown in its tooltip.
  void refuse(const std::string& key, const QString& reason);
  /// Names of all keys at or below a row; of all keys for an invalid index.
  std::vector<std::string> keysBelow(const QModelIndex& index) const;
  /// Makes a mode pending and emits keyChosen(). A missing number gets a default: 1 time, every 10th, every
  /// 1000 ms.
  void choose(const std::string& key, KeyValue value);

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Calls choose() with the edited mode or number.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  /// Emitted when the mode of a key is to be requested from the robot.
  void keyChosen(const QString& key, const widgets::KeyValue& value);

 private:
  /// A key or a group.
  struct Node;
  /// The root for an invalid index.
  const Node& nodeOf(const QModelIndex& index) const;
  /// Null for groups.
  const KeyEntry* entryOf(const QModelIndex& index) const;
  /// Builds the tree from keys_.
  void build();
  QString display(const Node& node, int column) const;
  QString toolTip(const KeyEntry& key) const;
  /// Number of keys at or below a node that are not off; adds the number of all keys to `all`.
  int activeBelow(const Node& node, int& all) const;
  /// Announces changed data of a key and its groups.
  void changed(const std::string& key);

  std::vector<KeyEntry> keys_;
  std::unique_ptr<Node> root_;
  /// Keyed by the key's name.
  std::map<std::string, const Node*> nodes_;
  /// Pending modes, by the key's name.
  std::map<std::string, KeyValue> pending_;
  /// Reasons of refusals, by the key's name; kept until the key is edited again.
  std::map<std::string, QString> refusals_;
};

}  // namespace widgets
Q_DECLARE_METATYPE(widgets::KeyValue)
