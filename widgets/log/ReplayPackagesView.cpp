// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/ReplayPackagesView.h"

#include <QBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>

#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/log/PackageSourceDelegate.h"

namespace widgets {
namespace {

const ViewRegistration kReplayPackagesViewRegistration{
    {"replay-packages", QT_TRANSLATE_NOOP("View", "Packages"),
     QT_TRANSLATE_NOOP("View",
                       "Chooses which packages of a log are recomputed by the program, and shows how they "
                       "differ from what was logged."),
     "packages", false, create<ReplayPackagesView>}};

}  // namespace

ReplayPackagesView::ReplayPackagesView(ViewContext& context, QWidget* parent)
    : View(context, parent), logs_(openLogs(context)), filtered_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("replayPackagesView"));
  createViews();
  connectSignals();
  tick();
}

void ReplayPackagesView::createViews() {
  auto* search = makeFilterField(
      this, {"packagesSearch", tr("Search packages"), tr("Shows only packages whose name contains this")},
      *filtered_, model_);
  filtered_->setFilterKeyColumn(ReplayPackageModel::kPackage);
  filtered_->setSortRole(ReplayPackageModel::kSortRole);
  table_ = makeTable(this,
                     {"packagesTable", tr("Packages of the replay"),
                      tr("F2 or a double click chooses where a package comes from")},
                     filtered_);
  table_->setItemDelegateForColumn(ReplayPackageModel::kSource, new PackageSourceDelegate(table_));
  table_->setSortingEnabled(true);
  table_->sortByColumn(ReplayPackageModel::kPackage, Qt::AscendingOrder);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setTextElideMode(Qt::ElideRight);
  new ColumnFit(*table_, {ColumnKind::kName, ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kNumber,
                          ColumnKind::kNumber, ColumnKind::kText});
  hint_ = new EmptyHint(table_);
  tasks_ = new QLabel(this);
  tasks_->setObjectName(QStringLiteral("unavailableTasks"));
  tasks_->setWordWrap(true);
  tasks_->setMargin(4);
  tasks_->setTextFormat(Qt::PlainText);
  tasks_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* layout = makeColumn(this, {4, 4, 4, 0}, 4);
  layout->addWidget(search);
  layout->addWidget(table_, 1);
  layout->addWidget(tasks_);
}

void ReplayPackagesView::connectSignals() {
  connect(&model_, &ReplayPackageModel::sourceWanted, this, [this](const QString& package, int source) {
    logs_.replay().choosePackage(package.toStdString(), static_cast<ReplayPackageModel::Source>(source));
  });
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    const int role = index.column() == ReplayPackageModel::kLargest     ? ReplayPackageModel::kLargestRole
                     : index.column() >= ReplayPackageModel::kDifferent ? ReplayPackageModel::kFirstRole
                                                                        : 0;
    const QVariant time = role != 0 ? index.data(role) : QVariant();
    if (time.isValid()) logs_.replay().jumpTo(robotlink::Instant(robotlink::Duration(time.toLongLong())));
  });
}

void ReplayPackagesView::tick() {
  const auto& status = logs_.replay().status();
  model_.setStatus(status, session().timeline().origin());
  showTasks();
  hint_->setHint(
      !logs_.replay().open()
          ? tr("No log is open.\nOpen one with File > Open log…, or drop log files onto the window.")
      : model_.rowCount() == 0 ? tr("No program runs on this log.")
                               : QString());
}

void ReplayPackagesView::showTasks() {
  QStringList lines;
  for (const auto& task : logs_.replay().status().unavailable_tasks()) lines << QString::fromStdString(task);
  const QString text = lines.isEmpty()
                           ? QString()
                           : tr("Tasks that cannot run on this log:\n%1").arg(lines.join(QLatin1Char('\n')));
  if (tasks_->text() != text) tasks_->setText(text);
  tasks_->setVisible(!text.isEmpty());
}

}  // namespace widgets
