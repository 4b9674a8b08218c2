// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: keys that work in the whole window, and the question before unsaved work is replaced.
#include <qtadvanceddocking/DockWidget.h>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoStack>
#include <algorithm>
#include <array>

#include "app/core/Workbench.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/UndoOrder.h"
#include "app/robotcontrol/actions/WindowKeys.h"
#include "app/robotcontrol/bars/LogToolBar.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFileActions.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/motions/MotionBench.h"
#include "widgets/motions/MotionFiles.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneDialogs.h"
#include "widgets/sceneedit/SceneEdits.h"

namespace app {
namespace {

using widgets::ReplayKey;

constexpr int kDoneShownMs = 5000;

constexpr std::array kReplayKeys = {
    ReplayKey::kPlayOrPause, ReplayKey::kFrameBack,  ReplayKey::kFrameOn,  ReplayKey::kTenFramesBack,
    ReplayKey::kTenFramesOn, ReplayKey::kSecondBack, ReplayKey::kSecondOn, ReplayKey::kMessageBack,
    ReplayKey::kMessageOn,   ReplayKey::kStart,      ReplayKey::kEnd,      ReplayKey::kBookmark};

/// Whether a command replaces what is open.
bool replaces(const QString& command) {
  const std::string name = command.toStdString();
  const auto& adapters = platformAdapters();
  return name == "log.close" || std::any_of(adapters.begin(), adapters.end(), [&](const auto& adapter) {
           return (adapter.command != nullptr && name == adapter.command) || name == formOf(adapter).command;
         });
}

}  // namespace

void MainWindow::createKeys() {
  keys_ = new WindowKeys(*this);
  undoOrder_ = new UndoOrder(this);
  undoOrder_->add(&widgets::colorBench(context_).undoStack());
  undoOrder_->add(&widgets::openLogs(context_).undoStack());
  undoOrder_->add(&widgets::motionBench(context_).undoStack());
  auto& scene = widgets::sceneEdits(context_);
  const auto step = [this, &scene](robotlink::Result<void> (widgets::SceneEdits::*act)()) {
    const auto done = (scene.*act)();
    if (done) return;
    // The reason follows what the key says itself.
    const QString reason = QString::fromStdString(done.error().describe());
    QMetaObject::invokeMethod(
        this, [this, reason] { statusBar()->showMessage(reason, kDoneShownMs); }, Qt::QueuedConnection);
  };
  undoOrder_->add({&scene, [&scene] { return scene.canUndo(); }, [&scene] { return scene.canRedo(); },
                   [step] { step(&widgets::SceneEdits::undo); },
                   [step] { step(&widgets::SceneEdits::redo); }});
  connect(&scene, &widgets::SceneEdits::historyChanged, undoOrder_, [this, &scene] {
    if (scene.canUndo() || scene.canRedo()) undoOrder_->touch(&scene);
  });
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { findUndoStacks(now); });
  actions_->setGuard([this](const QString& command) { return mayReplace(command); });
  addReplayKeys();
  addColorKeys();
  addEditingKeys();
  // Combo boxes of toolbars do not keep the focus after a click: the next keys are for the view.
  for (QComboBox* box : findChildren<QComboBox*>()) {
    if (qobject_cast<QToolBar*>(box->parentWidget()) != nullptr) box->setFocusPolicy(Qt::TabFocus);
  }
}

void MainWindow::addReplayKeys() {
  auto& replay = widgets::openLogs(context_).replay();
  for (const ReplayKey key : kReplayKeys) {
    QAction* action = logToolBar_->action(key);
    const bool repeats = key != ReplayKey::kPlayOrPause && key != ReplayKey::kBookmark;
    keys_->add({widgets::keySequence(key), action->text(), [&replay] { return replay.open(); },
                [action] { action->trigger(); }, key == ReplayKey::kBookmark, repeats});
  }
}

bool MainWindow::showsColors() const {
  for (const widgets::ViewType& type : widgets::ViewRegistry::all()) {
    const QString id = QLatin1String(type.id);
    if (!id.startsWith(QLatin1String("color-"))) continue;
    for (const ads::CDockWidget* dock : docks_->docks(id)) {
      if (dock->widget() != nullptr && dock->widget()->isVisible()) return true;
    }
  }
  return false;
}

void MainWindow::addColorKeys() {
  auto& bench = widgets::colorBench(context_);
  for (int digit = 0; digit <= 9; ++digit) {
    const QString text = digit == 0 ? tr("Strokes are background, while a color view is shown")
                                    : tr("Strokes are of class %1, while a color view is shown").arg(digit);
    keys_->add({{static_cast<int>(Qt::Key_0) + digit},
                text,
                [this] { return showsColors(); },
                [&bench, digit] { bench.setCurrentClass(digit); }});
  }
}

void MainWindow::addEditingKeys() {
  const auto report = [this](const QObject* stack, const QString& done, const QString& nothing) {
    const QString what = stack == nullptr ? QString() : stack->objectName();
    statusBar()->showMessage(stack == nullptr ? nothing
                             : what.isEmpty() ? done
                                              : QStringLiteral("%1 %2").arg(done, what),
                             kDoneShownMs);
  };
  const auto undo = [this, report] {
    report(undoOrder_->undo(), tr("Last change undone"), tr("Nothing to undo"));
  };
  const auto redo = [this, report] {
    report(undoOrder_->redo(), tr("Change redone"), tr("Nothing to redo"));
  };
  keys_->add({QKeySequence(QStringLiteral("Ctrl+Z")), tr("Undo"), {}, undo, false, true});
  keys_->add({QKeySequence(QStringLiteral("Ctrl+Shift+Z")), tr("Redo"), {}, redo, false, true});
  keys_->add({QKeySequence(QStringLiteral("Ctrl+Y")), tr("Redo"), {}, redo, false, true});
  keys_->add({QKeySequence(QStringLiteral("Ctrl+S")), tr("Save"), {}, [this] { saveWork(); }, true});
}

void MainWindow::findUndoStacks(QWidget* widget) {
  for (; widget != nullptr && widget != this; widget = widget->parentWidget()) {
    for (QUndoStack* stack : widget->findChildren<QUndoStack*>(QString(), Qt::FindDirectChildrenOnly))
      undoOrder_->add(stack);
  }
}

void MainWindow::saveWork() {
  auto& files = widgets::colorFiles(context_);
  auto& motions = widgets::motionFiles(context_);
  widgets::openLogs(context_).saveBookmarks();
  if (motions.changed() && !widgets::saveMotion(motions, this)) return;
  if (!widgets::saveAllScenes(widgets::sceneBench(context_), this)) return;
  if (!files.changed()) {
    statusBar()->showMessage(
        tr("Everything is saved: bookmarks, the color table's samples, the motion and the scene files"),
        kDoneShownMs);
  } else if (widgets::saveSamples(files, this)) {
    statusBar()->showMessage(tr("Saved: %1").arg(QString::fromStdString(files.file().string())),
                             kDoneShownMs);
  }
}

bool MainWindow::mayReplace(const QString& command) {
  auto& files = widgets::colorFiles(context_);
  const LoadedPlatform* loaded = workbench_.loaded();
  if (!replaces(command) || loaded == nullptr || !files.changed()) return true;
  const QString name = QString::fromStdString(loaded->name());
  QMessageBox box(QMessageBox::Warning, tr("Unsaved samples"),
                  tr("Your color samples are not saved, and you are about to close %1.")
                      .arg(name.isEmpty() ? tr("what is open") : name),
                  QMessageBox::Save | QMessageBox::Cancel, this);
  box.setObjectName(QStringLiteral("unsavedWork"));
  box.setInformativeText(tr("Save them first? They stay in the color views either way."));
  auto* proceed = box.addButton(tr("Continue without saving"), QMessageBox::DestructiveRole);
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (box.clickedButton() == proceed) return true;
  return answer == QMessageBox::Save && widgets::saveSamples(files, this);
}

}  // namespace app
