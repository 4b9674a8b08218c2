// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/keys/KeyDelegate.h"

#include <QComboBox>
#include <QSpinBox>

#include "widgets/Controls.h"
#include "widgets/keys/KeyTreeModel.h"

namespace widgets {

QWidget* KeyDelegate::createModeEditor(QWidget* parent) const {
  auto* box = new QComboBox(parent);
  describe(*box, {"keyModeEditor", tr("Mode of the debug key"), {}});
  box->setFrame(false);
  for (int kind = 0; kind <= static_cast<int>(KeyValue::Kind::kEveryMs); ++kind) {
    box->addItem(kindName(static_cast<KeyValue::Kind>(kind)));
  }
  connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box] {
    auto* self = const_cast<KeyDelegate*>(this);
    Q_EMIT self->commitData(box);
    Q_EMIT self->closeEditor(box);
  });
  return box;
}

QWidget* KeyDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                   const QModelIndex& index) const {
  if (index.column() == KeyTreeModel::kMode) return createModeEditor(parent);
  auto* spin = new QSpinBox(parent);
  describe(*spin, {"keyNumberEditor", tr("Number of the debug key's mode"), {}});
  spin->setFrame(false);
  spin->setRange(1, 1'000'000);
  return spin;
}

void KeyDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  // Only once: a KeyTable that arrives while the user edits must not change what is being typed.
  if (editor->property("filled").toBool()) return;
  editor->setProperty("filled", true);
  const int value = index.data(Qt::EditRole).toInt();
  if (auto* box = qobject_cast<QComboBox*>(editor)) {
    box->setCurrentIndex(value);
    box->showPopup();
  } else if (auto* spin = qobject_cast<QSpinBox*>(editor)) {
    spin->setValue(value);
    spin->selectAll();
  }
}

void KeyDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  if (auto* box = qobject_cast<QComboBox*>(editor)) model->setData(index, box->currentIndex(), Qt::EditRole);
  if (auto* spin = qobject_cast<QSpinBox*>(editor)) {
    spin->interpretText();
    model->setData(index, spin->value(), Qt::EditRole);
  }
}

}  // namespace widgets
