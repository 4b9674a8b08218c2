// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/ViewMenu.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/robotcontrol/docks/ViewDocks.h"
#include "widgets/Icon.h"
#include "widgets/View.h"

namespace app {
namespace {

struct Group {
  QString title;
  QStringList views;
};

/// The groups in the order of the menu; views that are in no group are listed at the end.
std::vector<Group> groups() {
  std::vector<Group> groups = {
      {ViewMenu::tr("The robot and its world"),
       {QStringLiteral("robots"), QStringLiteral("scene"), QStringLiteral("scene-tree"),
        QStringLiteral("scene-properties"), QStringLiteral("field"), QStringLiteral("image"),
        QStringLiteral("radar"), QStringLiteral("game"), QStringLiteral("base-state"),
        QStringLiteral("motion"), QStringLiteral("joints"), QStringLiteral("motion-editor"),
        QStringLiteral("scene-editor")}},
      {ViewMenu::tr("The robot's program"),
       {QStringLiteral("debug-keys"), QStringLiteral("solutions"), QStringLiteral("behavior"),
        QStringLiteral("messages"), QStringLiteral("data"), QStringLiteral("plots"),
        QStringLiteral("columns"), QStringLiteral("timing"), QStringLiteral("errors"),
        QStringLiteral("processes"), QStringLiteral("packets"), QStringLiteral("console")}},
      {ViewMenu::tr("Logs"),
       {QStringLiteral("time-line"), QStringLiteral("search"), QStringLiteral("replay-packages"),
        QStringLiteral("log-streams"), QStringLiteral("bookmarks")}},
      {ViewMenu::tr("Colors"),
       {QStringLiteral("color-image"), QStringLiteral("color-classes"), QStringLiteral("color-space"),
        QStringLiteral("color-samples"), QStringLiteral("color-quality"), QStringLiteral("color-compare"),
        QStringLiteral("color-frames")}},
      {ViewMenu::tr("Others"), {}}};
  for (const widgets::ViewType& type : widgets::ViewRegistry::all()) {
    const QString id = QLatin1String(type.id);
    if (std::none_of(groups.begin(), groups.end(),
                     [&](const Group& group) { return group.views.contains(id); })) {
      groups.back().views << id;
    }
  }
  return groups;
}

}  // namespace

ViewMenu::ViewMenu(ViewDocks& docks, QWidget* parent) : QMenu(tr("&View"), parent), docks_(docks) {
  setObjectName(QStringLiteral("viewMenu"));
  setToolTipsVisible(true);
  for (const Group& group : groups()) {
    if (group.views.isEmpty()) continue;
    addSection(group.title);
    for (const QString& id : group.views) addView(id);
  }
  addSeparator();
  QMenu* another = addMenu(tr("&Another one"));
  another->setObjectName(QStringLiteral("anotherViewMenu"));
  for (const Group& group : groups()) {
    for (const QString& id : group.views) addAnother(*another, id);
  }
  connect(this, &QMenu::aboutToShow, this, &ViewMenu::refresh);
}

void ViewMenu::addView(const QString& id) {
  const widgets::ViewType* type = widgets::ViewRegistry::find(id.toStdString());
  if (type == nullptr) return;
  QAction* action = addAction(widgets::icon(type->icon), QCoreApplication::translate("View", type->title),
                              this, [this, id] { choose(id); });
  action->setObjectName(QStringLiteral("view.") + id);
  action->setToolTip(QCoreApplication::translate("View", type->help));
  action->setCheckable(true);
  action->setIconVisibleInMenu(false);  // the check mark needs its place
  action->setData(id);
}

void ViewMenu::addAnother(QMenu& menu, const QString& id) {
  const widgets::ViewType* type = widgets::ViewRegistry::find(id.toStdString());
  if (type == nullptr || !type->several) return;
  QAction* action =
      menu.addAction(widgets::icon(type->icon), QCoreApplication::translate("View", type->title), this,
                     [this, id] { ViewDocks::focusOn(docks_.openAnother(id)); });
  action->setObjectName(QStringLiteral("another.") + id);
}

void ViewMenu::choose(const QString& id) {
  if (docks_.isInFront(id)) {
    docks_.close(id);
  } else {
    ViewDocks::focusOn(docks_.open(id));
  }
  refresh();
}

void ViewMenu::refresh() {
  for (QAction* action : actions()) {
    if (action->isCheckable()) action->setChecked(docks_.isOpen(action->data().toString()));
  }
}

}  // namespace app
