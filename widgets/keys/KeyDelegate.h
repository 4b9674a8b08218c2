// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace widgets {

/// Edits the columns mode and number of a KeyTreeModel in place. The mode's editor is a combo box
/// ("keyModeEditor") that opens at once and commits when an entry is chosen; the number's editor is a spin
/// box from 1 to 1,000,000 ("keyNumberEditor"). An editor is filled once: a KeyTable that arrives while it is
/// open does not change what the user types. GUI thread.
class KeyDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 private:
  /// Combo box with the names of all KeyValue::Kind, in their order.
  QWidget* createModeEditor(QWidget* parent) const;
};

}  // namespace widgets
