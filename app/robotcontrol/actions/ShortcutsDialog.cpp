// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/ShortcutsDialog.h"

#include <qtadvanceddocking/DockWidget.h>
#include <QAction>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QScreen>
#include <QShortcut>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/robotcontrol/actions/WindowKeys.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/View.h"

namespace app {
namespace {

constexpr QSize kWanted{640, 720};

/// The view to which an object belongs; null if it belongs to the window.
const widgets::View* viewOf(const QObject* object) {
  while (object != nullptr && qobject_cast<const widgets::View*>(object) == nullptr)
    object = object->parent();
  return static_cast<const widgets::View*>(object);
}

/// The title of a view's kind ("Image"), whatever it shows now; the same as in the menu.
QString titleOf(const widgets::View* view) {
  const QObject* object = view;
  while (object != nullptr && qobject_cast<const ads::CDockWidget*>(object) == nullptr)
    object = object->parent();
  const QString id = object != nullptr ? object->objectName().section(QLatin1Char('#'), 0, 0) : QString();
  const widgets::ViewType* type = widgets::ViewRegistry::find(id.toStdString());
  return type != nullptr ? QCoreApplication::translate("View", type->title) : id;
}

void add(std::vector<Shortcut>& all, Shortcut shortcut) {
  const auto same = [&](const Shortcut& other) {
    return other.key == shortcut.key && other.text == shortcut.text && other.view == shortcut.view;
  };
  if (!shortcut.key.isEmpty() && std::ranges::none_of(all, same)) all.push_back(std::move(shortcut));
}

}  // namespace

std::vector<Shortcut> shortcutsOf(const QWidget& window, const WindowKeys& keys) {
  std::vector<Shortcut> all;
  for (const auto& binding : keys.bindings()) add(all, {binding.key, binding.text, {}, nullptr});
  for (const QAction* action : window.findChildren<QAction*>()) {
    const widgets::View* view = viewOf(action);
    for (const QKeySequence& key : action->shortcuts()) {
      add(all, {key, action->text().remove(QLatin1Char('&')), view != nullptr ? titleOf(view) : QString(),
                action});
    }
  }
  for (const auto* shortcut : window.findChildren<QShortcut*>()) {
    const widgets::View* view = viewOf(shortcut);
    const QString text = shortcut->whatsThis();
    if (view != nullptr && !text.isEmpty()) add(all, {shortcut->key(), text, titleOf(view), shortcut});
  }
  return all;
}

ShortcutsDialog::ShortcutsDialog(const WindowKeys& keys, QWidget* window) : QDialog(window) {
  setObjectName(QStringLiteral("shortcutsDialog"));
  setWindowTitle(tr("Keyboard shortcuts"));
  auto* search = widgets::makeSearchField(
      this, {"shortcutsSearch", tr("Search"), tr("Shows only entries that contain these words")});
  list_ = new QTreeWidget(this);
  widgets::describe(*list_, {"shortcutsList", tr("Keyboard shortcuts"), {}});
  list_->setHeaderLabels({tr("What it does"), tr("Key")});
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  widgets::styleTree(*list_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(search, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(search);
  layout->addWidget(list_, 1);
  layout->addWidget(buttons);
  fill(shortcutsOf(*window, keys));
  fitScreen();
}

void ShortcutsDialog::fill(const std::vector<Shortcut>& shortcuts) {
  QString longestKey;
  std::vector<QString> views{QString()};
  for (const Shortcut& shortcut : shortcuts) {
    if (std::ranges::find(views, shortcut.view) == views.end()) views.push_back(shortcut.view);
  }
  std::sort(views.begin() + 1, views.end());
  for (const QString& view : views) {
    auto* group =
        new QTreeWidgetItem(list_, {view.isEmpty() ? tr("Everywhere") : tr("In the view %1").arg(view)});
    for (const Shortcut& shortcut : shortcuts) {
      if (shortcut.view != view) continue;
      auto* row =
          new QTreeWidgetItem(group, {shortcut.text, shortcut.key.toString(QKeySequence::NativeText)});
      if (row->text(1).size() > longestKey.size()) longestKey = row->text(1);
      row->setToolTip(0, shortcut.text);
    }
  }
  list_->expandAll();
  auto* fit = new widgets::ColumnFit(*list_, {widgets::ColumnKind::kText, widgets::ColumnKind::kName});
  fit->expect(1, longestKey);
}

void ShortcutsDialog::filter(const QString& text) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = list_->topLevelItem(i);
    bool some = false;
    for (int j = 0; j < group->childCount(); ++j) {
      QTreeWidgetItem* row = group->child(j);
      const bool fits = (group->text(0) + row->text(0) + row->text(1)).contains(text, Qt::CaseInsensitive);
      row->setHidden(!fits);
      some = some || fits;
    }
    group->setHidden(!some);
  }
}

void ShortcutsDialog::fitScreen() {
  resize(kWanted.boundedTo(parentWidget()->screen()->availableSize() * 0.9));
}

}  // namespace app
