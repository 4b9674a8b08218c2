// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: commands about what views show: images, drawings, data, messages, parameters.
#include <qtadvanceddocking/DockWidget.h>
#include <QPointer>
#include <variant>

#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "robotlink/session/Session.h"
#include "widgets/data/DataView.h"
#include "widgets/data/RequestText.h"
#include "widgets/image/ImageStreamView.h"
#include "widgets/messages/MessagesView.h"
#include "widgets/picture/PictureView.h"
#include "widgets/solutions/ParameterPanel.h"
#include "widgets/solutions/SolutionsView.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;
using Values = robotlink::CommandTable::Values;
using Names = std::vector<std::string>;

const std::string& textAt(const Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}

/// The open views of a class, by the names that commands use.
template <typename V>
Names openNames(const ViewDocks& docks) {
  Names names;
  for (const ads::CDockWidget* dock : docks.openDocks()) {
    if (qobject_cast<const V*>(dock->widget()) == nullptr) continue;
    QString name = dock->objectName();
    if (name.endsWith(QLatin1String("#1"))) name.chop(2);
    names.push_back(name.toStdString());
  }
  return names;
}

/// The open view of this name; null if there is none of this class.
template <typename V>
const V* namedView(const ViewDocks& docks, const std::string& name) {
  const ads::CDockWidget* dock = docks.named(QString::fromStdString(name));
  return dock == nullptr ? nullptr : qobject_cast<const V*>(dock->widget());
}

}  // namespace

template <typename V>
Result<V*> MainWindow::openAs(const std::string& name) {
  const auto dock = openView(name);
  if (!dock) return tl::unexpected(dock.error());
  if (V* view = qobject_cast<V*>((*dock)->widget())) return view;
  return failure("view.kind", "the view " + name + " cannot do this", {}, {name});
}

void MainWindow::attachPictureCommands() {
  const auto streams = [window = QPointer(this)](const Names& before) {
    if (!window || before.size() > 1) return Names();
    if (before.empty()) return openNames<widgets::ImageStreamView>(*window->docks_);
    const auto* view = namedView<widgets::ImageStreamView>(*window->docks_, before.front());
    return view == nullptr ? Names() : view->streamChoices();
  };
  attach(
      "image.stream",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const auto view = window.openAs<widgets::ImageStreamView>(textAt(values, 0));
        if (!view) return tl::unexpected(view.error());
        return (*view)->showStream(textAt(values, 1));
      },
      streams);
  attach(
      "image.compare",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const auto view = window.openAs<widgets::ImageStreamView>(textAt(values, 0));
        if (!view) return tl::unexpected(view.error());
        if (textAt(values, 1) != "none") return (*view)->compareWith(textAt(values, 1), textAt(values, 2));
        (*view)->endComparison();
        return {};
      },
      [streams](const Names& before) {
        Names names = streams(before);
        if (before.size() == 1) names.emplace_back("none");
        return names;
      });
  attach(
      "view.drawing",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const auto view = window.openAs<widgets::PictureView>(textAt(values, 0));
        if (!view) return tl::unexpected(view.error());
        return (*view)->showDrawing(textAt(values, 1), std::get<bool>(values[2]));
      },
      [window = QPointer(this)](const Names& before) {
        Names names;
        if (!window || before.size() > 1) return names;
        if (before.empty()) return openNames<widgets::PictureView>(*window->docks_);
        const auto* view = namedView<widgets::PictureView>(*window->docks_, before.front());
        if (view == nullptr) return names;
        for (const QString& name : view->drawingNames()) names.push_back(name.toStdString());
        return names;
      });
}

void MainWindow::attachPoseCommand() {
  attach(
      "view.pose",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const auto view = window.openAs<widgets::PictureView>(textAt(values, 0));
        if (!view) return tl::unexpected(view.error());
        return (*view)->choosePose(textAt(values, 1));
      },
      [window = QPointer(this)](const Names& before) {
        Names names;
        if (!window || before.size() > 1) return names;
        if (before.empty()) return openNames<widgets::PictureView>(*window->docks_);
        const auto* view = namedView<widgets::PictureView>(*window->docks_, before.front());
        if (view == nullptr || view->poseNames().empty()) return names;
        names.emplace_back("default");
        for (const QString& name : view->poseNames()) names.push_back(name.toStdString());
        return names;
      });
}

void MainWindow::attachDataCommands() {
  attach(
      "data.compare",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const auto view = window.openAs<widgets::DataView>(textAt(values, 1));
        if (!view) return tl::unexpected(view.error());
        return (*view)->compareWith(textAt(values, 0));
      },
      [window = QPointer(this)](const Names& before) {
        if (!window || before.size() > 1) return Names();
        return before.empty() ? widgets::DataView::comparisons(window->context_.session)
                              : openNames<widgets::DataView>(*window->docks_);
      });
  attach(
      "data.publish",
      [](MainWindow& window, const Values& values) {
        return widgets::publish(window.context_.session, textAt(values, 0), textAt(values, 1),
                                textAt(values, 2));
      },
      [window = QPointer(this)](const Names& before) {
        if (before.empty()) return widgets::requestWords();
        return window && before.size() == 2 ? window->context_.session.robots() : Names();
      });
}

void MainWindow::attachToolCommands() {
  attach(
      "messages.filter",
      [](MainWindow& window, const Values& values) -> Result<void> {
        const auto view = window.openAs<widgets::MessagesView>(textAt(values, 2));
        if (!view) return tl::unexpected(view.error());
        return (*view)->setFilter(textAt(values, 0), std::get<bool>(values[1]));
      },
      [window = QPointer(this)](const Names& before) {
        return window && before.size() == 2 ? openNames<widgets::MessagesView>(*window->docks_) : Names();
      });
  const auto attachStep = [this](const char* name, bool (widgets::ParameterPanel::*step)()) {
    attach(name, [step](MainWindow& window, const Values&) -> Result<void> {
      const auto view = window.openAs<widgets::SolutionsView>("solutions");
      if (!view) return tl::unexpected(view.error());
      if (((*view)->parameters().*step)()) return {};
      return failure("parameters.undo", "no edit in the view Solutions can be undone or redone");
    });
  };
  attachStep("parameters.undo", &widgets::ParameterPanel::undo);
  attachStep("parameters.redo", &widgets::ParameterPanel::redo);
}

}  // namespace app
