// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: docks, perspectives, and the undo history of the layout.
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/FloatingDockContainer.h>
#include <QApplication>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QShowEvent>
#include <QTimer>
#include <QVBoxLayout>
#include <filesystem>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/actions/WindowKeys.h"
#include "app/robotcontrol/docks/DockSpace.h"
#include "app/robotcontrol/docks/LayoutHistory.h"
#include "app/robotcontrol/docks/MaximizedView.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "widgets/EmptyHint.h"
#include "widgets/scene/SceneView.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneEditorView.h"

namespace app {
namespace {

constexpr qint64 kLookAtDocksEveryMs = 250;
constexpr int kAskAgainMs = 50;

}  // namespace

void MainWindow::createDocks() {
  ads::CDockManager::setConfigFlags(ads::CDockManager::DefaultOpaqueConfig);
  ads::CDockManager::setConfigFlag(ads::CDockManager::XmlCompressionEnabled, false);
  // The titles need the room; other tabs are closed by the middle button of the mouse, or by their menu.
  ads::CDockManager::setConfigFlag(ads::CDockManager::ActiveTabHasCloseButton, true);
  ads::CDockManager::setConfigFlag(ads::CDockManager::TabCloseButtonIsToolButton, true);
  ads::CDockManager::setConfigFlag(ads::CDockManager::MiddleMouseButtonClosesTab, true);
  auto* center = new QWidget(this);
  auto* layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  dockSpace_ = new DockSpace(center);
  layout->addWidget(dockSpace_, 1);
  setCentralWidget(center);
  // Floating docks are windows of their own; keys that they do not handle are handled by this one.
  connect(dockSpace_, &ads::CDockManager::floatingWidgetCreated, this,
          [this](ads::CFloatingDockContainer* floating) { floating->installEventFilter(this); });
  docks_ = new ViewDocks(*dockSpace_, context_, this);
  connect(docks_, &ViewDocks::leftOut, this, [this](const QString& sentence) {
    showErrors({{"window.views", sentence.toStdString(), {}, {}}});
  });
  layouts_ = new LayoutHistory(*docks_, this);
  noViews_ = new widgets::EmptyHint(dockSpace_);
  noViews_->setObjectName(QStringLiteral("noViews"));
}

void MainWindow::tickDocks() {
  docks_->tick();
  dockSpace_->nameFloats();
  if (sinceLooked_.elapsed() < kLookAtDocksEveryMs || QApplication::mouseButtons() != Qt::NoButton ||
      dockSpace_->busy())
    return;
  if (maximizedView_->active()) return;  // all other views are hidden temporarily
  sinceLooked_.restart();
  dockSpace_->fitTabs();
  layouts_->look();
  undoLayout_->setEnabled(layouts_->canUndo());
  redoLayout_->setEnabled(layouts_->canRedo());
  noViews_->setHint(
      dockSpace_->hasVisibleDocks()
          ? QString()
          : tr("No view is open here. The View menu opens one; Window > Undo layout change "
               "(%1) brings back what was closed last; Window > Reset perspective shows all "
               "views of %2 again.")
                .arg(undoLayout_->shortcut().toString(QKeySequence::NativeText), perspectives_.current()));
}

void MainWindow::whenDocksRest(std::function<void()> change) {
  if (!dockSpace_->busy()) return change();
  QTimer::singleShot(kAskAgainMs, this,
                     [this, change = std::move(change)]() mutable { whenDocksRest(std::move(change)); });
}

void MainWindow::showPerspective(const QString& name) {
  whenDocksRest([this, name] {
    // The views have no sizes before the window is visible.
    if (isVisible()) perspectives_.keep(perspectives_.current(), *docks_);
    perspectives_.show(name, *docks_);
    layouts_->forget();
    fillPerspectiveMenu();
    QTimer::singleShot(0, keys_, &WindowKeys::focusContent);  // after the old views are deleted
  });
}

bool MainWindow::showViewsOfScene(const LoadedPlatform& loaded) {
  const bool isScene = loaded.isSimulated() && !loaded.sources.empty();
  const std::string scene = isScene ? loaded.sources.front() : std::string();
  if (scene == shownScene_) return false;
  // The views have no sizes before the window is visible.
  if (!shownScene_.empty() && isVisible()) perspectives_.keepFor(shownScene_, *docks_);
  shownScene_ = scene;
  // A perspective that was just chosen is what the user wants.
  if (scene.empty() || isPerspectiveWanted_ || dockSpace_->busy()) return false;
  const QString before = perspectives_.current();
  if (isVisible()) perspectives_.keep(before, *docks_);
  // At the start, the window has the views of the scene that was open last. To restore them again would close
  // and open floating views, and undo what the user has changed meanwhile.
  const bool hasThem = beginning_.isEmpty() && perspectives_.hasRestoredFor(scene);
  if (!hasThem && !perspectives_.showFor(scene, *docks_)) return false;
  beginning_ = Perspectives::beginningWith(loaded);
  if (hasThem) return true;
  layouts_->forget();
  fillPerspectiveMenu();
  QTimer::singleShot(0, keys_, &WindowKeys::focusContent);  // after the old views are deleted
  return true;
}

bool MainWindow::goesOnEditing(const LoadedPlatform& loaded) {
  const widgets::SceneFile* edited = widgets::sceneBench(context_).current();
  bool isEditorShown = false, isSceneShown = false;
  for (const ads::CDockWidget* dock : docks_->openDocks()) {
    isEditorShown = isEditorShown || qobject_cast<const widgets::SceneEditorView*>(dock->widget()) != nullptr;
    isSceneShown = isSceneShown || qobject_cast<const widgets::SceneView*>(dock->widget()) != nullptr;
  }
  if (edited == nullptr || !isEditorShown || !isSceneShown) return false;
  if (!loaded.isSimulated() || loaded.sources.empty()) return false;
  std::error_code unknown;
  return std::filesystem::equivalent(edited->path(), loaded.sources.front(), unknown);
}

void MainWindow::choosePerspective(const QString& name) {
  showPerspective(name);
  const LoadedPlatform* loaded = workbench_.loaded();
  isPerspectiveWanted_ = loaded == nullptr;
  if (loaded == nullptr || loaded->sources.empty()) return;
  // Later, if a dock is being dragged.
  whenDocksRest([this, source = loaded->sources.front()] { perspectives_.chooseFor(source); });
}

void MainWindow::exportPerspective() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Export perspective"),
      QString(perspectives_.current()).replace(QLatin1Char('/'), QLatin1Char('-')) +
          QStringLiteral(".perspective.json"),
      tr("Perspectives (*.perspective.json);;All files (*)"));
  if (file.isEmpty()) return;
  if (const auto written = writePerspective(file.toStdString()); !written) showErrors({written.error()});
}

void MainWindow::importPerspective() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Import perspective"), {}, tr("Perspectives (*.perspective.json *.json);;All files (*)"));
  if (file.isEmpty()) return;
  if (const auto read = readPerspective(file.toStdString()); !read) showErrors({read.error()});
}

robotlink::Result<void> MainWindow::writePerspective(const std::filesystem::path& file) {
  perspectives_.keep(perspectives_.current(), *docks_);
  return perspectives_.write(perspectives_.current(), file);
}

robotlink::Result<void> MainWindow::readPerspective(const std::filesystem::path& file) {
  const auto name = perspectives_.read(file);
  if (!name) return tl::unexpected(name.error());
  choosePerspective(*name);
  return {};
}

void MainWindow::resetPerspective() {
  whenDocksRest([this] {
    layouts_->keepAll();
    perspectives_.showShipped(perspectives_.current(), *docks_);
  });
}

void MainWindow::fillPerspectiveMenu() {
  perspectiveMenu_->clear();
  int number = 1;
  for (const QString& name : perspectives_.names()) {
    QAction* action = perspectiveMenu_->addAction(name, this, [this, name] { choosePerspective(name); });
    action->setObjectName(QStringLiteral("perspective.") + name);
    action->setCheckable(true);
    action->setChecked(name == perspectives_.current());
    if (number <= 9) action->setShortcut(QKeySequence(QStringLiteral("Ctrl+%1").arg(number++)));
    action->setShortcutContext(Qt::ApplicationShortcut);  // also works in floating docks
  }
  perspectiveMenu_->addSeparator();
  QAction* remove = perspectiveMenu_->addAction(tr("&Delete this perspective"), this, [this] {
    if (const auto removed = removePerspective(perspectives_.current()); !removed)
      showErrors({removed.error()});
  });
  remove->setObjectName(QStringLiteral("deletePerspective"));
  remove->setEnabled(!perspectives_.isShipped(perspectives_.current()));
}

void MainWindow::savePerspectiveAs() {
  bool accepted = false;
  const QString name = QInputDialog::getText(this, tr("Save perspective"), tr("Name of the perspective:"),
                                             QLineEdit::Normal, perspectives_.current(), &accepted)
                           .trimmed();
  if (!accepted || name.isEmpty()) return;
  if (const auto saved = savePerspective(name); !saved) showErrors({saved.error()});
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (!event->spontaneous()) dockSpace_->openFloats();
}

}  // namespace app
