// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: commands about views of the scene: how objects are drawn, what the camera follows.
#include <qtadvanceddocking/DockWidget.h>
#include <QPointer>
#include <algorithm>
#include <iterator>
#include <variant>

#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "widgets/scene/SceneView.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;
using widgets::SceneView;
using Values = robotlink::CommandTable::Values;
using SceneViews = std::vector<SceneView*>;

const std::string& sceneWord(const Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}

SceneViews openSceneViews(const ViewDocks& docks) {
  SceneViews views;
  for (ads::CDockWidget* dock : docks.openDocks())
    if (auto* view = qobject_cast<SceneView*>(dock->widget())) views.push_back(view);
  return views;
}

SceneView::Following followingOf(const std::string& word) {
  using enum SceneView::Following;
  if (word == "position") return kPosition;
  if (word == "heading") return kHeading;
  return word == "first-person" ? kFirstPerson : kOff;
}

}  // namespace

Result<void> MainWindow::inSceneViews(const std::string& name,
                                      const std::function<Result<void>(SceneView&)>& run) {
  SceneViews views;
  if (name.empty()) views = openSceneViews(*docks_);
  if (views.empty()) {
    const auto dock = openView(name.empty() ? "scene" : name);
    if (!dock) return tl::unexpected(dock.error());
    auto* view = qobject_cast<SceneView*>((*dock)->widget());
    if (view == nullptr) return failure("view.kind", "the view " + name + " shows no scene", {}, {name});
    views.push_back(view);
  }
  for (SceneView* view : views) {
    view->tick();  // a view that was just opened knows no objects yet
    if (const auto done = run(*view); !done) return done;
  }
  return {};
}

void MainWindow::attachSceneViewCommands() {
  const auto paths = [window = QPointer(this)](const std::vector<std::string>& before) {
    if (!window || !before.empty()) return std::vector<std::string>();
    const SceneViews views = openSceneViews(*window->docks_);
    return views.empty() ? std::vector<std::string>() : views.front()->objectPaths();
  };
  using Run = std::function<Result<void>(SceneView&, const Values&)>;
  // The view is the last argument of all of them.
  const auto addFor = [&](const char* name, Run run, robotlink::CommandTable::Offer offer) {
    attach(
        name,
        [run = std::move(run)](MainWindow& window, const Values& values) {
          return window.inSceneViews(sceneWord(values, values.size() - 1),
                                     [&](SceneView& view) { return run(view, values); });
        },
        std::move(offer));
  };
  const auto add = [&](const char* name, Run run) { addFor(name, std::move(run), paths); };
  add("scene.view",
      [](SceneView& view, const Values& values) { return view.drawObject({}, sceneWord(values, 0)); });
  add("scene.draw", [](SceneView& view, const Values& values) {
    return view.drawObject(sceneWord(values, 0), sceneWord(values, 1));
  });
  add("scene.opacity", [](SceneView& view, const Values& values) {
    return view.setOpacity(sceneWord(values, 0), std::get<double>(values[1]));
  });
  add("scene.hide",
      [](SceneView& view, const Values& values) { return view.hideObject(sceneWord(values, 0)); });
  addFor(
      "scene.show",
      [](SceneView& view, const Values& values) { return view.showObject(sceneWord(values, 0)); },
      [window = QPointer(this)](const std::vector<std::string>& before) {
        std::vector<std::string> hidden;
        if (!window || !before.empty()) return hidden;
        for (const SceneView* view : openSceneViews(*window->docks_))
          std::ranges::copy(view->hiddenPaths(), std::back_inserter(hidden));
        return hidden;
      });
  add("scene.layer", [](SceneView& view, const Values& values) {
    return view.showLayer(sceneWord(values, 0), std::get<bool>(values[1]));
  });
  add("scene.follow", [](SceneView& view, const Values& values) {
    return view.followObject(sceneWord(values, 0), followingOf(sceneWord(values, 1)));
  });
  add("scene.only",
      [](SceneView& view, const Values& values) { return view.showOnly(sceneWord(values, 0), true); });
  attach(
      "scene.open",
      [](MainWindow& window, const Values& values) -> Result<void> {
        ads::CDockWidget* dock = window.docks_->openAnother(QStringLiteral("scene"));
        auto* view = dock == nullptr ? nullptr : qobject_cast<SceneView*>(dock->widget());
        if (view == nullptr) return failure("view.kind", "the view of the scene cannot be opened");
        view->tick();
        return view->showOnly(sceneWord(values, 0), sceneWord(values, 1) == "alone");
      },
      paths);
}

}  // namespace app
