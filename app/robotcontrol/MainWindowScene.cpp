// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: what views of a scene show, copies of views, and the files of the scene.
#include <qtadvanceddocking/DockWidget.h>
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QPointer>
#include <variant>

#include "app/core/Workbench.h"
#include "app/platforms/simulated/scenetext/SceneFileText.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "robotlink/base/Resources.h"
#include "widgets/Icon.h"
#include "widgets/image/ImageStreamView.h"
#include "widgets/objects/ColumnsView.h"
#include "widgets/world/SceneFileEdit.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;
using Values = robotlink::CommandTable::Values;

const std::string& wordAt(const Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}

/// The dock that contains a widget; null: none.
const ads::CDockWidget* dockAround(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget())
    if (const auto* dock = qobject_cast<const ads::CDockWidget*>(widget)) return dock;
  return nullptr;
}

/// The view of a dock; null while it has none.
widgets::View* viewOf(const ads::CDockWidget& dock) {
  return qobject_cast<widgets::View*>(dock.widget());
}

}  // namespace

void MainWindow::attachSceneCommands() {
  const auto views = [](const auto& before) {
    std::vector<std::string> names;
    if (!before.empty()) return names;
    for (const widgets::ViewType& type : widgets::ViewRegistry::all()) names.emplace_back(type.id);
    return names;
  };
  attach(
      "view.copy",
      [](MainWindow& window, const Values& values) {
        return window.copyView(wordAt(values, 0), wordAt(values, 1) == "numbers");
      },
      views);
  attach("columns.show", [](MainWindow& window, const Values& values) -> Result<void> {
    const auto dock = window.openView(wordAt(values, 1));
    if (!dock) return tl::unexpected(dock.error());
    auto* view = qobject_cast<widgets::ColumnsView*>((*dock)->widget());
    if (view == nullptr)
      return failure("view.kind", "the view " + wordAt(values, 1) + " cannot do this", {},
                     {wordAt(values, 1)});
    return view->showSource(wordAt(values, 0));
  });
  attach("image.show", [](MainWindow& window, const Values& values) -> Result<void> {
    const auto dock = window.openView(wordAt(values, 0));
    if (!dock) return tl::unexpected(dock.error());
    auto* view = qobject_cast<widgets::ImageStreamView*>((*dock)->widget());
    if (view == nullptr)
      return failure("view.kind", "the view " + wordAt(values, 0) + " cannot do this", {},
                     {wordAt(values, 0)});
    view->setMode(wordAt(values, 1));
    return {};
  });
}

Result<void> MainWindow::copyView(const std::string& id, bool asNumbers) {
  widgets::View* view = nullptr;
  if (id.empty()) {
    const ads::CDockWidget* dock = dockAround(QApplication::focusWidget());
    view = dock == nullptr ? nullptr : viewOf(*dock);
    if (view == nullptr) return failure("view.copy", "no view has the focus; click one first");
  } else {
    const auto dock = openView(id);
    if (!dock) return tl::unexpected(dock.error());
    view = viewOf(**dock);
    if (view == nullptr) return failure("view.copy", "the view " + id + " has failed", {}, {id});
    finishPictures(*view);
  }
  if (!asNumbers) {
    QApplication::clipboard()->setImage(view->shownPicture());
    return {};
  }
  const auto numbers = view->numbers();
  if (!numbers)
    return failure("view.copy", "this view shows no table of numbers; copy its picture instead", {}, {id});
  QApplication::clipboard()->setText(*numbers);
  return {};
}

void MainWindow::addCopying(QMenu& menu) {
  const auto add = [&](const char* name, const QString& text, const QString& tip, bool asNumbers) {
    QAction* action = menu.addAction(widgets::icon("copy"), text, this, [this, asNumbers] {
      if (const auto copied = copyView({}, asNumbers); !copied) showErrors({copied.error()});
    });
    action->setObjectName(QLatin1String(name));
    action->setToolTip(tip);
    return action;
  };
  add("file.copyPicture", tr("Copy view as picture"), tr("Copies the picture of the view that has the focus"),
      false);
  add("file.copyNumbers", tr("Copy view as numbers"),
      tr("Copies the table of the view that has the focus, with tabs between the columns"), true);
}

void MainWindow::offerSceneFiles() {
  context_.writeScene = [this](const std::vector<widgets::SceneFileEdit>& edits) -> Result<void> {
    const LoadedPlatform* loaded = workbench_.loaded();
    if (loaded == nullptr || !loaded->isSimulated() || loaded->sources.empty())
      return failure("scene.file", "no scene is open here, so none of its files can be changed");
    std::vector<SceneFileChange> changes;
    for (const widgets::SceneFileEdit& edit : edits) changes.push_back({edit.file, edit.element, edit.value});
    return writeSceneChanges(loaded->sources.front(), robotlink::resource("scenes/models"), changes);
  };
}

}  // namespace app
