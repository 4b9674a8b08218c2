// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/PackageSourceDelegate.h"

#include <QComboBox>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>

#include "widgets/log/ReplayPackageModel.h"

namespace widgets {

using robotcontrol::ControlReplay;

QWidget* PackageSourceDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                             const QModelIndex& index) const {
  auto* box = new QComboBox(parent);
  box->setObjectName(QStringLiteral("packageSourceEditor"));
  box->setAccessibleName(tr("Source of the package"));
  box->setFrame(false);
  const auto* proxy = qobject_cast<const QSortFilterProxyModel*>(index.model());
  const auto* model = qobject_cast<const ReplayPackageModel*>(proxy->sourceModel());
  const int row = proxy->mapToSource(index).row();
  for (const auto source : {ControlReplay::AUTOMATIC, ControlReplay::AS_LOGGED, ControlReplay::RECOMPUTED}) {
    const QString reason = model->reason(row, source);
    QString text = ReplayPackageModel::sourceName(source);
    if (!reason.isEmpty()) text = tr("%1: %2").arg(text, reason);
    box->addItem(text, static_cast<int>(source));
    if (!model->allows(row, source))
      qobject_cast<QStandardItemModel*>(box->model())->item(box->count() - 1)->setEnabled(false);
  }
  connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box] {
    auto* self = const_cast<PackageSourceDelegate*>(this);
    Q_EMIT self->commitData(box);
    Q_EMIT self->closeEditor(box);
  });
  return box;
}

void PackageSourceDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  // Only once: a status that arrives while the user chooses must not change the choice.
  if (editor->property("filled").toBool()) return;
  editor->setProperty("filled", true);
  auto* box = qobject_cast<QComboBox*>(editor);
  box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
  box->showPopup();
}

void PackageSourceDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                         const QModelIndex& index) const {
  const auto* box = qobject_cast<QComboBox*>(editor);
  if (box->currentData() != index.data(Qt::EditRole)) model->setData(index, box->currentData(), Qt::EditRole);
}

}  // namespace widgets
