// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/PluginsDialog.h"

#include <QBoxLayout>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QUrl>

#include "app/core/plugins/Plugins.h"
#include "widgets/Controls.h"

namespace app {

PluginsDialog::PluginsDialog(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("pluginsDialog"));
  setWindowTitle(tr("Plug-ins"));
  table_ = new QTableWidget(0, 3, this);
  widgets::describe(*table_, {"pluginsTable", tr("Plug-ins"), {}});
  table_->setHorizontalHeaderLabels(
      {tr("Plug-in"), tr("Version"), tr("What it does, or why it is not loaded")});
  table_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // reasons may be long
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setWordWrap(true);
  fillTable();
  const QString folder = QString::fromStdString(pluginFolder().string());
  auto* note = widgets::makeNote(this, "pluginsFolder", tr("Where plug-ins are"));
  note->setText((loadedPlugins().empty() ? tr("There are no plug-ins. ") : QString()) +
                tr("Plug-ins in the folder %1 are loaded at the next start; load others with --plugin FILE.")
                    .arg(folder));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* open = buttons->addButton(tr("&Open folder"), QDialogButtonBox::ActionRole);
  open->setObjectName(QStringLiteral("pluginsOpenFolder"));
  open->setToolTip(tr("Shows the folder of plug-ins, which is created if it is missing"));
  connect(open, &QPushButton::clicked, this, [folder] {
    QDir().mkpath(folder);
    QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(table_, 1);
  layout->addWidget(note);
  layout->addWidget(buttons);
  resize(760, 320);
}

void PluginsDialog::fillTable() {
  for (const LoadedPlugin& plugin : loadedPlugins()) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    const QString file = QString::fromStdString(plugin.file.string());
    const bool works = plugin.problem.empty();
    const QString name = plugin.name.empty() ? QString::fromStdString(plugin.file.filename().string())
                                             : QString::fromStdString(plugin.name);
    const QString texts[] = {name, QString::fromStdString(plugin.version),
                             works ? QString::fromStdString(plugin.help)
                                   : tr("Not loaded: %1").arg(QString::fromStdString(plugin.problem))};
    for (int column = 0; column < 3; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(column == 2 ? texts[column] : file);
      table_->setItem(row, column, item);
    }
  }
  table_->resizeColumnsToContents();
}

}  // namespace app
