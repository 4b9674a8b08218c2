// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterDelegate.h"

#include <QComboBox>
#include <QLineEdit>

#include "widgets/solutions/ParameterModel.h"

namespace widgets {

QWidget* ParameterDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                         const QModelIndex& index) const {
  const QStringList choices = index.data(ParameterModel::kChoicesRole).toStringList();
  QWidget* editor = nullptr;
  if (choices.isEmpty()) {
    auto* line = new QLineEdit(parent);
    line->setFrame(false);
    editor = line;
  } else {
    auto* box = new QComboBox(parent);
    box->addItems(choices);
    connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box] {
      auto* self = const_cast<ParameterDelegate*>(this);
      Q_EMIT self->commitData(box);
      Q_EMIT self->closeEditor(box);
    });
    editor = box;
  }
  editor->setObjectName(QStringLiteral("parameterEditor"));
  editor->setAccessibleName(index.data(ParameterModel::kPathRole).toString());
  editor->setAutoFillBackground(true);
  return editor;
}

void ParameterDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  // Only once: values that arrive while the user edits must not change what is being typed.
  if (editor->property("filled").toBool()) return;
  editor->setProperty("filled", true);
  const QString text = index.data(Qt::EditRole).toString();
  if (auto* box = qobject_cast<QComboBox*>(editor)) {
    box->setCurrentText(text);
    box->showPopup();
  } else if (auto* line = qobject_cast<QLineEdit*>(editor)) {
    line->setText(text);
    line->selectAll();
  }
}

void ParameterDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                     const QModelIndex& index) const {
  if (auto* box = qobject_cast<QComboBox*>(editor)) model->setData(index, box->currentText(), Qt::EditRole);
  if (auto* line = qobject_cast<QLineEdit*>(editor)) model->setData(index, line->text(), Qt::EditRole);
}

}  // namespace widgets
