// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class PackageCopy;
class ParameterLimits;
class ParameterValues;
}  // namespace robotcontrol

namespace widgets {

/// The parameters of a solution, a protobuf message of any type, as a tree of its fields. An edit changes
/// nothing here: edited() carries the message before and after it, and the owner of the undo stack calls
/// setValue(). Types that are not compiled into this program are built from the descriptors that come with
/// the values. GUI thread.
class ParameterModel final : public QAbstractItemModel {
  Q_OBJECT
 public:
  /// Name of the field, its value, its default, which the solution's file has, and what holds without one.
  enum Column { kField, kValue, kDefault, kBuiltIn, kColumns };
  enum Role {
    /// QStringList: the names of an enumeration; empty for other types.
    kChoicesRole = Qt::UserRole + 1,
    /// bool: the value, or one below it, differs from the default.
    kChangedRole,
    /// QString: "walk.step_height".
    kPathRole,
    /// A number as it is; invalid for other values.
    kNumberRole,
    /// double: the limits of a number; invalid if it has none. The maximum may be infinite.
    kMinRole,
    kMaxRole,
  };

  explicit ParameterModel(QObject* parent = nullptr);
  ~ParameterModel() override;

  /// Shows the parameters. False, and the model is empty, if the type is unknown or the bytes cannot be
  /// parsed. If the message has no defaults, its values count as the defaults.
  bool setParameters(const robotcontrol::ParameterValues& values);
  void clear();
  /// The message, serialized, as setValue() takes it; empty without parameters.
  QByteArray value() const;
  /// Replaces the values. Bytes that cannot be parsed are ignored. The model is reset only if a list has
  /// another number of elements than before.
  void setValue(const QByteArray& value);
  QByteArray defaults() const;
  /// Whether a value differs from its default.
  bool isChanged() const;
  /// The text of a parameter file after what differs from the defaults was written into it; without a text,
  /// that of a new file with all values. `file` is for errors only.
  tl::expected<std::string, robotlink::Errors> inFile(const std::optional<std::string>& text,
                                                      const std::string& file) const;
  /// Full name of the message's type; empty without parameters.
  std::string typeName() const;
  /// Emits edited() with the defaults of a row and of all below it; of all rows for an invalid index.
  void reset(const QModelIndex& index);

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Emits edited() if the value is valid and differs.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  /// Messages before and after an edit, serialized; `what` names the edit for an undo stack.
  void edited(const QByteArray& before, const QByteArray& after, const QString& what);

 private:
  /// A field of the message.
  struct Node;
  /// The messages with values and defaults and, if need be, the descriptors of their type.
  struct Values;
  const Node& nodeOf(const QModelIndex& index) const;
  void build();
  /// Adds the fields of the message at a node, recursively.
  void addFields(Node& node);
  /// Whether the node, or one below it, differs from its default.
  bool differs(const Node& node) const;
  /// Null: any value makes sense.
  const robotcontrol::ParameterLimits* limitsOf(const Node& node) const;
  QString toolTipOf(const Node& node) const;
  /// Writes the defaults of a node and of all below it into `values`.
  void resetInto(const Node& node, Values& values) const;

  /// Null: no parameters.
  std::unique_ptr<Values> values_;
  std::unique_ptr<Node> root_;
};

}  // namespace widgets
