// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: scene files that are edited, their recovery, and the questions about them.
#include <QAction>
#include <QMenu>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "app/core/Workbench.h"
#include "app/platforms/simulated/scenetext/SceneFileText.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/Icon.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneDialogs.h"
#include "widgets/sceneedit/SceneEdits.h"
#include "widgets/sceneedit/SceneFile.h"
#include "widgets/world/SceneRename.h"
#include "widgets/world/SceneSelection.h"

namespace app {
namespace {

constexpr int kSceneMessageShownMs = 15'000;

}  // namespace

void MainWindow::createScenes(const std::filesystem::path& userFolder) {
  auto& bench = widgets::sceneBench(context_);
  connect(&bench, &widgets::SceneBench::reported, this, [this](const QString& text, bool bad) {
    if (bad)
      showErrors({{"scene.failed", text.toStdString(), {}, {}}});
    else
      statusBar()->showMessage(text.section(QLatin1Char('\n'), 0, 0), kSceneMessageShownMs);
    if (!bad) forgetErrors("scene.failed");
  });
  widgets::sceneEdits(context_).setHost(
      [this](const widgets::SceneEdits::Texts& unsaved,
             const widgets::SceneEdits::Refused& refused) -> robotlink::Result<void> {
        const LoadedPlatform* loaded = workbench_.loaded();
        if (loaded == nullptr || !loaded->isSimulated() || loaded->sources.empty())
          return robotlink::failure("scene.file",
                                    "no scene is open here that could be reloaded; open one first");
        if (!refused) {
          workbench_.reloadScene(unsaved);
        } else {
          workbench_.fitScene(
              unsaved, [refused](const robotlink::Errors& errors) { refused(robotlink::describe(errors)); });
        }
        return {};
      },
      [this](const std::filesystem::path& file) {
        const LoadedPlatform* loaded = workbench_.loaded();
        return loaded != nullptr && loaded->isSimulated() && !loaded->sources.empty() &&
               isFileOfScene(file, loaded->sources.front(), robotlink::resource("scenes/models"));
      });
  workbench_.onSceneRead([this, &bench] {
    QStringList names;
    for (const widgets::SceneFile* file : bench.files()) {
      if (file->isChanged() && bench.isRunning(*file)) names << file->name();
    }
    if (names.isEmpty()) return;
    const QString all = names.join(QStringLiteral(", "));
    statusBar()->showMessage(
        tr("The simulation continues with the saved files. The editor keeps unsaved changes: %1; scene.apply "
           "applies them.")
            .arg(all),
        kSceneMessageShownMs);
  });
  if (!isOfScript_) bench.startRecovery(userFolder / "scenes");
}

void MainWindow::followRenames() {
  auto& session = context_.session;
  if (isRobotRenamed_) session.selectRobot(selectedRobot_);
  const auto* known = dynamic_cast<const robotcontrol::WorldObjects*>(objects_.get());
  const bool isThere = std::ranges::find(session.robots(), selectedRobot_) != session.robots().end();
  // While the scene has it, only the list of robots or the one of objects is still of another name.
  const bool isAwaited = known != nullptr && std::ranges::count(known->objects(), selectedRobot_,
                                                                &robotcontrol::WorldObject::path) > 0;
  if (isThere || !isAwaited) {
    selectedRobot_ = session.selectedRobot();
    isRobotRenamed_ = false;
  }
  const auto* message = session.store().latest(robotlink::streams::kObjects, session.timeline().newest());
  const robotlink::PackagePtr value = message == nullptr ? nullptr : message->value;
  if (value == objects_) return;
  const robotlink::PackagePtr last = std::exchange(objects_, value);
  const auto* now = dynamic_cast<const robotcontrol::WorldObjects*>(value.get());
  const auto rename =
      known == nullptr || now == nullptr ? std::nullopt : widgets::renameBetween(*known, *now);
  isRobotRenamed_ = rename && rename->from == selectedRobot_;
  selectedRobot_ = isRobotRenamed_ ? rename->to : session.selectedRobot();
  if (!rename) return;
  docks_->follow(*rename);
  auto& selection = widgets::sceneSelection(context_);
  selection.select(widgets::withRename(QString::fromStdString(selection.object()), *rename).toStdString());
}

void MainWindow::addSceneEntries(QMenu& menu) {
  QAction* action = menu.addAction(widgets::icon("file-new"), tr("&New scene…"), this, [this] {
    if (const auto shown = openView("scene-editor"); !shown) return showErrors({shown.error()});
    widgets::newScene(widgets::sceneBench(context_), this);
  });
  action->setObjectName(QStringLiteral("file.newScene"));
  action->setToolTip(tr("Starts a room with walls, light, and a robot in the scene editor"));
}

bool MainWindow::mayLoseScenes() {
  auto& bench = widgets::sceneBench(context_);
  if (!widgets::mayLoseScenes(bench, this)) return false;
  bench.forget();
  return true;
}

}  // namespace app
