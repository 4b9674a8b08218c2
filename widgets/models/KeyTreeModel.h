// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <map>
#include <memory>
#include <optional>

#include "widgets/models/KeyEntries.h"

namespace widgets {

/// The debug keys of one robot as a tree by the parts of their names ("ball-percept/circle"). Columns: name,
/// mode, number. Editing a mode or a number changes nothing here but what is shown as wished (in italics);
/// keyChosen() asks the owner to request it, and the next tables or refuse() settle it. Keys of inactive
/// solutions are greyed and can be set all the same. GUI thread.
class KeyTreeModel final : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { kName, kMode, kNumber, kColumns };
  enum Role {
    kKeyRole = Qt::UserRole + 1,  ///< the key's whole name; for a group, the names' common part
    kKindRole,                    ///< KeyValue::Kind as int; invalid for groups
    kActiveRole,                  ///< bool: this key, or one below this group, is not off
  };

  explicit KeyTreeModel(QObject* parent = nullptr);
  ~KeyTreeModel() override;

  /// Takes over what the robot tells. Keeps the rows as long as the names are the same.
  void setKeys(std::vector<KeyEntry> keys);
  const std::vector<KeyEntry>& keys() const { return keys_; }
  /// What is wished for the key, else what it is.
  KeyValue shownValue(const KeyEntry& key) const;
  /// A wish is over: the robot refused it, for this reason.
  void refuse(const std::string& key, const QString& reason);
  /// All keys at or below a row.
  std::vector<std::string> keysBelow(const QModelIndex& index) const;
  void choose(const std::string& key, KeyValue value);

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void keyChosen(const QString& key, const widgets::KeyValue& value);

 private:
  struct Node;
  const Node& nodeOf(const QModelIndex& index) const;
  const KeyEntry* entryOf(const QModelIndex& index) const;
  void build();
  QString display(const Node& node, int column) const;
  QString toolTip(const KeyEntry& key) const;
  int activeBelow(const Node& node, int& all) const;
  void changed(const std::string& key);

  std::vector<KeyEntry> keys_;
  std::unique_ptr<Node> root_;
  std::map<std::string, const Node*> nodes_;  // by key
  std::map<std::string, KeyValue> wishes_;
  std::map<std::string, QString> refusals_;
};

}  // namespace widgets
Q_DECLARE_METATYPE(widgets::KeyValue)
