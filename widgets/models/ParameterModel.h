// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <vector>

namespace robotcontrol {
class PackageCopy;
class ParameterValues;
}  // namespace robotcontrol

namespace widgets {

/// The parameters of a solution, any protobuf message, as a tree of fields. Columns: field, value, default.
/// An edit changes nothing here: edited() carries the message before and after it, and whoever keeps the undo
/// stack calls setValue(). Types that this program does not know are built from the descriptors that come
/// with the values. GUI thread.
class ParameterModel final : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { kField, kValue, kDefault, kColumns };
  enum Role {
    kChoicesRole = Qt::UserRole + 1,  ///< QStringList: an enumeration's names
    kChangedRole,                     ///< bool: differs from the default
    kPathRole,                        ///< QString: "walk.step_height"
  };

  explicit ParameterModel(QObject* parent = nullptr);
  ~ParameterModel() override;

  /// False, and empty, if the type is unknown or the bytes are not of it. Without defaults told, the first
  /// values seen are the defaults.
  bool setParameters(const robotcontrol::ParameterValues& values);
  void clear();
  /// The message, serialised; what setValue() takes.
  QByteArray value() const;
  void setValue(const QByteArray& value);
  QByteArray defaults() const;
  std::string typeName() const;
  /// Asks for the default of a row and of all below it.
  void reset(const QModelIndex& index);

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void edited(const QByteArray& before, const QByteArray& after, const QString& what);

 private:
  struct Node;
  struct Values;
  const Node& nodeOf(const QModelIndex& index) const;
  void build();
  void addFields(Node& node);
  bool differs(const Node& node) const;
  void resetInto(const Node& node, Values& values) const;

  std::unique_ptr<Values> values_;  // null: no parameters
  std::unique_ptr<Node> root_;
};

}  // namespace widgets
