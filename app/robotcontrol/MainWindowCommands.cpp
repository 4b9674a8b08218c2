// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: commands about the window, its views and perspectives, and the palette.
#include <qtadvanceddocking/DockWidget.h>
#include <QAction>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QJsonDocument>
#include <QMenu>
#include <QPointer>
#include <algorithm>
#include <cmath>
#include <functional>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/actions/AppearanceMenu.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/WindowKeys.h"
#include "app/robotcontrol/commands/CommandPalette.h"
#include "app/robotcontrol/docks/DockSpace.h"
#include "app/robotcontrol/docks/LayoutHistory.h"
#include "app/robotcontrol/docks/MaximizedView.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "app/robotcontrol/language/LanguageMenu.h"
#include "app/robotcontrol/presets/PresetActions.h"
#include "app/robotcontrol/presets/PresetMenu.h"
#include "app/robotcontrol/presets/SweepDialog.h"
#include "robotlink/base/Resources.h"
#include "robotlink/base/Spelling.h"
#include "widgets/ColumnFit.h"
#include "widgets/WrittenPicture.h"
#include "widgets/console/CommandLog.h"
#include "widgets/log/TimeMarks.h"
#include "widgets/motion/ManualSteering.h"
#include "widgets/motion/MotionCommands.h"
#include "widgets/motions/MotionEditorCommands.h"
#include "widgets/plots/PlotsView.h"
#include "widgets/sceneedit/SceneEditorCommands.h"
#include "widgets/search/SearchView.h"
#include "widgets/solutions/ParameterCommands.h"
#include "widgets/solutions/ParameterEdits.h"
#include "widgets/solutions/ParameterSweep.h"
#include "widgets/timeline/TimeLineView.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;
using Values = robotlink::CommandTable::Values;

/// Stands for the whole window where commands name a view.
constexpr char kWindow[] = "window";

QString argumentOf(const Values& values, std::size_t index) {
  return QString::fromStdString(std::get<std::string>(values[index]));
}

std::vector<std::string> toStrings(const QStringList& texts) {
  std::vector<std::string> strings;
  for (const QString& each : texts) strings.push_back(each.toStdString());
  return strings;
}

Result<void> noCurve(const QString& value) {
  const std::string name = value.toStdString();
  return failure("plots.curve", "there is no curve of " + name, {}, {name});
}

std::vector<std::string> viewNames(const std::vector<std::string>& before) {
  std::vector<std::string> names;
  if (!before.empty()) return names;
  for (const widgets::ViewType& type : widgets::ViewRegistry::all()) names.emplace_back(type.id);
  std::ranges::sort(names);
  return names;
}

/// Names the view that was probably meant, or all that there are.
tl::unexpected<robotlink::Error> unknownView(const std::string& id) {
  return failure("view.unknown", "there is no view '" + id + "'" + robotlink::suggestion(id, viewNames({})),
                 {}, {id});
}

}  // namespace

void MainWindow::attachCommands() {
  auto& commands = workbench_.commands();
  widgets::attachMotionCommands(context_);
  widgets::attachMotionEditorCommands(context_);
  widgets::attachSceneEditorCommands(context_);
  auto* parameters = new widgets::ParameterEdits(context_.session, this);
  widgets::attachParameterCommands(commands, *parameters);
  createPresets(*parameters);
  createSweep(*parameters);
  if (commands.isAttached("view.show")) return;
  attachViewCommands();
  attachPerspectiveCommands();
  attachAppearanceCommands();
  attachPlotCommands();
  attachSearchCommands();
  attachExportCommands();
  attachPictureCommands();
  attachPoseCommand();
  attachDataCommands();
  attachToolCommands();
  attachSceneCommands();
  attachSceneViewCommands();
}

void MainWindow::createPresets(widgets::ParameterEdits& parameters) {
  const auto now = [this]() -> robotlink::Preset::Values {
    return {{"perspective", perspectives_.current().toStdString()},
            {"layout", QJsonDocument(docks_->save()).toJson(QJsonDocument::Compact).toStdString()}};
  };
  const auto show = [this](const robotlink::Preset::Values& views) -> Result<void> {
    const auto valueOf = [&](const char* name) {
      const auto found = views.find(name);
      return found == views.end() ? QString() : QString::fromStdString(found->second);
    };
    const QString perspective = valueOf("perspective");
    if (perspectives_.names().contains(perspective)) showPerspective(perspective);
    const QJsonObject layout = QJsonDocument::fromJson(valueOf("layout").toUtf8()).object();
    if (!layout.isEmpty()) whenDocksRest([this, layout] { docks_->restore(layout); });
    return {};
  };
  auto* presets = new PresetActions(workbench_.commands(), context_.session, parameters,
                                    robotlink::userDirectory() / "presets", {now, show}, this);
  findChild<QMenu*>(QStringLiteral("robotMenu"))->addMenu(new PresetMenu(*actions_, *presets, this));
}

void MainWindow::createSweep(widgets::ParameterEdits& parameters) {
  sweep_ = new widgets::ParameterSweep(workbench_.commands(), context_.session, parameters, this);
  widgets::attachSweepCommands(workbench_.commands(), *sweep_);
  workbench_.addJob([sweep = QPointer(sweep_)] { return sweep ? sweep->working() : Result<bool>(false); });
  QAction* action = findChild<QMenu*>(QStringLiteral("robotMenu"))->addAction(tr("S&weep a parameter…"));
  action->setObjectName(QStringLiteral("parameters.sweep"));
  connect(action, &QAction::triggered, this, [this, &parameters] {
    auto* dialog = new SweepDialog(*sweep_, parameters, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  });
}

void MainWindow::attach(const char* name, WindowCommand run, robotlink::CommandTable::Offer offer) {
  const auto act = [window = QPointer(this), run = std::move(run)](const Values& values) -> Result<void> {
    if (window) return run(*window, values);
    return failure("window.closed", "the window is closed");
  };
  workbench_.commands().attach(name, act, std::move(offer));
}

void MainWindow::attachViewCommands() {
  const auto attachForView = [this](const char* name, void (*run)(MainWindow&, const QString& id)) {
    const auto act = [run](MainWindow& window, const Values& values) -> Result<void> {
      const QString id = argumentOf(values, 0);
      if (widgets::ViewRegistry::find(id.toStdString()) == nullptr) return unknownView(id.toStdString());
      run(window, id);
      return {};
    };
    attach(name, act, viewNames);
  };
  attach(
      "view.show",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const auto dock = window.openView(std::get<std::string>(values[0]));
        if (!dock) return tl::unexpected(dock.error());
        return {};
      },
      viewNames);
  attachForView("view.another",
                [](MainWindow& window, const QString& id) { window.docks_->openAnother(id); });
  attachForView("view.close", [](MainWindow& window, const QString& id) {
    window.maximizedView_->restore();
    window.docks_->close(id);
  });
  attachForView("view.maximize", [](MainWindow& window, const QString& id) {
    window.maximizedView_->maximize(*window.docks_->open(id));
  });
  attach("view.restore", [](MainWindow& window, const Values&) -> Result<void> {
    window.maximizedView_->restore();
    return {};
  });
  const auto attachForFile =
      [this](const char* name, Result<void> (MainWindow::*save)(const std::string&, const std::string&)) {
        const auto act = [save](MainWindow& window, const Values& values) {
          return (window.*save)(std::get<std::string>(values[0]), std::get<std::string>(values[1]));
        };
        attach(name, act, viewNames);
      };
  attachForFile("view.screenshot", &MainWindow::saveScreenshot);
  attachForFile("view.save", &MainWindow::saveView);
}

void MainWindow::attachPerspectiveCommands() {
  const auto names = [window = QPointer(this)](const auto&) {
    return window ? toStrings(window->perspectives_.names()) : std::vector<std::string>();
  };
  const auto attachForPerspective = [&](const char* name,
                                        Result<void> (*run)(MainWindow&, const QString& name)) {
    const auto act = [run](MainWindow& window, const Values& values) -> Result<void> {
      const QString wanted = argumentOf(values, 0);
      const QStringList known = window.perspectives_.names();
      if (known.contains(wanted)) return run(window, wanted);
      return failure("view.perspective",
                     QStringLiteral("there is no perspective %1; there are %2")
                         .arg(wanted, known.join(QStringLiteral(", ")))
                         .toStdString(),
                     {}, {wanted.toStdString()});
    };
    attach(name, act, names);
  };
  attachForPerspective("view.perspective", [](MainWindow& window, const QString& name) -> Result<void> {
    window.choosePerspective(name);
    return {};
  });
  attachForPerspective("view.delete-perspective", [](MainWindow& window, const QString& name) {
    return window.removePerspective(name);
  });
  attach(
      "view.save-perspective",
      [](MainWindow& window, const Values& values) { return window.savePerspective(argumentOf(values, 0)); },
      names);
  attach("view.export-perspective", [](MainWindow& window, const Values& values) {
    return window.writePerspective(std::get<std::string>(values[0]));
  });
  attach("view.import-perspective", [](MainWindow& window, const Values& values) {
    return window.readPerspective(std::get<std::string>(values[0]));
  });
  const auto attachSimple = [this](const char* name, void (*run)(MainWindow&)) {
    attach(name, [run](MainWindow& window, const Values&) -> Result<void> {
      run(window);
      return {};
    });
  };
  attachSimple("view.reset", [](MainWindow& window) { window.resetPerspective(); });
  attachSimple("view.undo", [](MainWindow& window) { window.stepLayout(&LayoutHistory::undo); });
  attachSimple("view.redo", [](MainWindow& window) { window.stepLayout(&LayoutHistory::redo); });
}

void MainWindow::attachAppearanceCommands() {
  attach("view.appearance", [](MainWindow& window, const Values& values) -> Result<void> {
    window.appearance_->setAppearance(appearanceFromName(argumentOf(values, 0)));
    return {};
  });
  attach("view.language", [](MainWindow& window, const Values& values) -> Result<void> {
    window.language_->setLanguage(languageFromName(argumentOf(values, 0)));
    return {};
  });
  attach("view.text-size", [](MainWindow& window, const Values& values) -> Result<void> {
    const double percent = std::get<double>(values[0]);
    if (!(percent >= AppearanceMenu::kMinTextSize && percent <= AppearanceMenu::kMaxTextSize))
      return failure("view.text-size", "the size must be between " +
                                           std::to_string(AppearanceMenu::kMinTextSize) + " and " +
                                           std::to_string(AppearanceMenu::kMaxTextSize) + " percent");
    window.appearance_->setTextSize(static_cast<int>(std::lround(percent)));
    return {};
  });
}

void MainWindow::attachPlotCommands() {
  const auto offers = [this](QStringList (widgets::PlotsView::*texts)() const) {
    return [texts, window = QPointer(this)](const auto&) {
      const auto* plots = window ? window->findView<widgets::PlotsView>("plots") : nullptr;
      return plots == nullptr ? std::vector<std::string>() : toStrings((plots->*texts)());
    };
  };
  attach(
      "plots.add",
      [](MainWindow& window, const Values& values) -> Result<void> {
        return window.shownView<widgets::PlotsView>("plots")->addCurve(argumentOf(values, 0));
      },
      offers(&widgets::PlotsView::sources));
  attach(
      "plots.remove",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const QString value = argumentOf(values, 0);
        auto* plots = window.findView<widgets::PlotsView>("plots");
        return plots != nullptr && plots->removeCurve(value) ? Result<void>() : noCurve(value);
      },
      offers(&widgets::PlotsView::curves));
  attach(
      "plots.states",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const QString value = argumentOf(values, 0);
        auto* plots = window.findView<widgets::PlotsView>("plots");
        return plots != nullptr && plots->setStrip(value, std::get<bool>(values[1])) ? Result<void>()
                                                                                     : noCurve(value);
      },
      offers(&widgets::PlotsView::curves));
  attach("plots.spectrum", [](MainWindow& window, const Values& values) -> Result<void> {
    window.shownView<widgets::PlotsView>("plots")->setSpectrum(std::get<bool>(values[0]),
                                                               argumentOf(values, 1));
    return {};
  });
  attach("plots.equal-axes", [](MainWindow& window, const Values& values) -> Result<void> {
    window.shownView<widgets::PlotsView>("plots")->setEqualAxes(std::get<bool>(values[0]));
    return {};
  });
  attach("plots.clear", [](MainWindow& window, const Values&) -> Result<void> {
    if (auto* plots = window.findView<widgets::PlotsView>("plots")) plots->clear();
    return {};
  });
}

void MainWindow::attachSearchCommands() {
  attach("search.start", [](MainWindow& window, const Values& values) {
    auto* view = window.shownView<widgets::SearchView>("search");
    return view->search(argumentOf(values, 0), argumentOf(values, 1) == QStringLiteral("texts"));
  });
  const auto attachToView = [this](const char* name, Result<void> (*run)(widgets::SearchView&)) {
    attach(name, [run](MainWindow& window, const Values&) -> Result<void> {
      if (auto* view = window.findView<widgets::SearchView>("search")) return run(*view);
      return failure("search.closed", "there is no search yet; start one: search.start CONDITION");
    });
  };
  attachToView("search.cancel", [](widgets::SearchView& view) -> Result<void> {
    view.cancel();
    return {};
  });
  attachToView("search.next", [](widgets::SearchView& view) { return view.go(1); });
  attachToView("search.previous", [](widgets::SearchView& view) { return view.go(-1); });
  workbench_.addJob([window = QPointer(this)]() -> Result<bool> {
    const auto* view = window ? window->findView<widgets::SearchView>("search") : nullptr;
    return view != nullptr && view->isSearching();
  });
  attach("timeline.track", [](MainWindow& window, const Values& values) -> Result<void> {
    return window.shownView<widgets::TimeLineView>("time-line")->addTrack(argumentOf(values, 0));
  });
  attach(
      "timeline.remove-track",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const QString value = argumentOf(values, 0);
        auto* view = window.findView<widgets::TimeLineView>("time-line");
        return view != nullptr && view->removeTrack(value) ? Result<void>() : noCurve(value);
      },
      [window = QPointer(this)](const auto&) {
        const auto* view = window ? window->findView<widgets::TimeLineView>("time-line") : nullptr;
        return view == nullptr ? std::vector<std::string>() : toStrings(view->tracks());
      });
  attach("timeline.mark-texts", [](MainWindow& window, const Values& values) -> Result<void> {
    const QString wrong =
        widgets::TimeMarks::of(widgets::openLogs(window.context_)).setPattern(argumentOf(values, 0));
    if (wrong.isEmpty()) return {};
    return failure("timeline.pattern", "not a valid regular expression: " + wrong.toStdString());
  });
}

template <typename V>
V* MainWindow::findView(const char* id) const {
  for (const ads::CDockWidget* dock : docks_->docks(QLatin1String(id))) {
    if (!dock->isClosed()) return qobject_cast<V*>(dock->widget());
  }
  return nullptr;
}

template <typename V>
V* MainWindow::shownView(const char* id) {
  if (V* view = findView<V>(id)) return view;
  ads::CDockWidget* dock = docks_->open(QLatin1String(id));
  return dock == nullptr ? nullptr : qobject_cast<V*>(dock->widget());
}

Result<ads::CDockWidget*> MainWindow::openView(const std::string& id) {
  if (ads::CDockWidget* dock = docks_->open(QString::fromStdString(id))) return dock;
  return unknownView(id);
}

void MainWindow::finishPictures(QWidget& shown) {
  constexpr int kLimit = 3000, kEventsLimit = 100;  // ms
  // The changes of a tick are laid out by events, and a resized view may need to read more.
  constexpr int kRounds = 4;
  QList<widgets::View*> views = shown.findChildren<widgets::View*>();
  if (auto* view = qobject_cast<widgets::View*>(&shown)) views << view;
  QElapsedTimer since;
  since.start();
  const auto isMissing = [](const widgets::View* view) {
    return view->isVisible() && !view->isPictureReady();
  };
  for (int round = 0; since.elapsed() < kLimit && (round < kRounds || std::ranges::any_of(views, isMissing));
       ++round) {
    docks_->tick();
    dockSpace_->fitTabs();
    // Tables fit their columns a moment after their contents have changed.
    for (auto* fit : shown.findChildren<widgets::ColumnFit*>()) fit->fit();
    QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents, kEventsLimit);
  }
}

Result<void> MainWindow::saveScreenshot(const std::string& view, const std::string& file) {
  QWidget* shown = this;
  if (view != kWindow) {
    const auto dock = openView(view);
    if (!dock) return tl::unexpected(dock.error());
    shown = (*dock)->widget();
  }
  finishPictures(*shown);
  return widgets::writePicture(shown->grab().toImage(), QString::fromStdString(file));
}

Result<void> MainWindow::saveView(const std::string& id, const std::string& file) {
  const auto dock = openView(id);
  if (!dock) return tl::unexpected(dock.error());
  finishPictures(*(*dock)->widget());
  return static_cast<widgets::View*>((*dock)->widget())->saveTo(QString::fromStdString(file));
}

void MainWindow::stepLayout(void (LayoutHistory::*step)()) {
  whenDocksRest([this, step] {
    layouts_->look();  // what was changed just now is a step, too
    std::invoke(step, layouts_);
  });
}

Result<void> MainWindow::savePerspective(const QString& name) {
  if (name.trimmed().isEmpty()) return failure("view.perspective", "a perspective needs a name");
  perspectives_.keep(name.trimmed(), *docks_);
  keepWindow();
  fillPerspectiveMenu();
  return {};
}

Result<void> MainWindow::removePerspective(const QString& name) {
  if (perspectives_.isShipped(name))
    return failure("view.perspective", name.toStdString() + " is shipped and cannot be deleted", {},
                   {name.toStdString()});
  whenDocksRest([this, name] {
    const bool isShown = name == perspectives_.current();
    perspectives_.remove(name);
    if (isShown) perspectives_.show(QStringLiteral("Play"), *docks_);
    if (isShown) layouts_->forget();
    fillPerspectiveMenu();
  });
  return {};
}

void MainWindow::createPalette() {
  const auto views = [this] {
    std::vector<PaletteEntry> entries;
    for (const ads::CDockWidget* dock : docks_->openDocks())
      entries.push_back({dock->windowTitle(), {}, {}, dock->objectName()});
    return entries;
  };
  const auto go = [this](const QString& name) { ViewDocks::focusOn(docks_->open(name)); };
  palette_ =
      new CommandPalette({*actions_, workbench_.commands(), widgets::commandLog(context_), views, go}, this);
  auto* action = new QAction(tr("&Commands…"), this);
  action->setObjectName(QStringLiteral("help.commands"));
  action->setShortcut(QKeySequence(QStringLiteral("Ctrl+P")));
  action->setShortcutContext(Qt::ApplicationShortcut);
  action->setToolTip(tr("Finds commands and menu entries by their words, and runs them"));
  connect(action, &QAction::triggered, palette_, &CommandPalette::open);
  addAction(action);
  if (auto* menu = findChild<QMenu*>(QStringLiteral("helpMenu")))
    menu->insertAction(menu->actions().value(0), action);
  auto* going = new QAction(tr("&Go to view…"), this);
  going->setObjectName(QStringLiteral("view.go"));
  going->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+J")));
  going->setShortcutContext(Qt::ApplicationShortcut);
  going->setToolTip(tr("Lists the open views; type a part of a title to bring that view to the front"));
  connect(going, &QAction::triggered, palette_, &CommandPalette::openViews);
  addAction(going);
  if (auto* menu = findChild<QMenu*>(QStringLiteral("viewMenu")))
    menu->insertAction(menu->actions().value(0), going);
}

}  // namespace app
