// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QTest>
#include <QTreeView>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/CommandTable.h"
#include "robotlink/session/Session.h"
#include "widgets/View.h"

/// The base of tests of views: a session with the robots "red1" (selected) and "blue1". Requests are recorded
/// instead of sent, and the test controls the time. Any Qt warning, except for those of the offscreen plugin,
/// aborts the program.
class Bench {
 public:
  Bench() {
    session.setRobots({"red1", "blue1"});
    session.selectRobot("red1");
    session.setRequestSink([this](const robotcontrol::Request& request) { requests.push_back(request); });
  }

  /// For initTestCase(): aborts on warnings, uses the resources of this source tree and a home folder of its
  /// own.
  static void prepare(const char* sourceDirectory) {
    const auto home = std::filesystem::temp_directory_path() /
                      ("robotcontrol-test-" + std::to_string(QCoreApplication::applicationPid()));
    std::filesystem::create_directories(home);
    std::filesystem::permissions(home, std::filesystem::perms::owner_all);
    qputenv("XDG_CONFIG_HOME", home.c_str());
    qputenv("XDG_RUNTIME_DIR", home.c_str());
    qputenv("ROBOTCONTROL_RESOURCES", (std::string(sourceDirectory) + "/resources").c_str());
    previous() = qInstallMessageHandler(failOnWarning);
  }
  /// For cleanupTestCase(): removes the home folder.
  static void tidyUp() {
    std::error_code error;
    std::filesystem::remove_all(std::filesystem::path(qgetenv("XDG_CONFIG_HOME").toStdString()), error);
  }

  /// Creates and shows a view.
  template <typename V>
  std::unique_ptr<V> open(QSize size = {700, 500}) {
    auto view = std::make_unique<V>(context);
    view->resize(size);
    view->show();
    if (!QTest::qWaitForWindowActive(view.get())) qFatal("the view's window never became active");
    tick(*view);
    return view;
  }

  template <typename T>
  void push(const std::string& path, const T& message, double time) {
    session.push(
        {path, robotlink::Instant(robotlink::fromSeconds(time)), std::make_shared<const T>(message)});
  }
  void tick(widgets::View& view) {
    session.tick();
    view.tick();
  }
  /// Replies to the last request.
  void answer(bool accepted, const std::string& reason = {}) { answer(requests.back(), accepted, reason); }
  void answer(const robotcontrol::Request& request, bool accepted, const std::string& reason = {}) {
    robotcontrol::RequestResult result;
    result.set_id(request.id());
    result.set_accepted(accepted);
    result.set_reason(reason);
    session.pushResult(result);
  }

  robotlink::Session session;
  robotlink::CommandTable commands;
  widgets::ViewContext context{session, commands, nullptr, {}};
  std::vector<robotcontrol::Request> requests;

 private:
  static QtMessageHandler& previous() {
    static QtMessageHandler handler = nullptr;
    return handler;
  }
  static void failOnWarning(QtMsgType type, const QMessageLogContext& where, const QString& text) {
    if (text.startsWith(QStringLiteral("This plugin does not support"))) return;
    if (type == QtWarningMsg || type == QtCriticalMsg) {
      std::fprintf(stderr, "Qt warns: %s\n", qPrintable(text));
      std::abort();
    }
    if (previous() != nullptr) previous()(type, where, text);
  }
};

/// A widget of a view by its object name; aborts the program if there is none.
template <typename W>
W& child(QWidget& of, const char* name) {
  W* found = of.findChild<W*>(QString::fromLatin1(name));
  if (found == nullptr) qFatal("no widget is called %s", name);
  return *found;
}

inline void click(QWidget& widget) {
  QTest::mouseClick(&widget, Qt::LeftButton);
}

/// The index that shows `text` in the first column, anywhere in the tree; invalid if there is none.
inline QModelIndex find(const QTreeView& tree, const QString& text, int column = 0) {
  const auto hits = tree.model()->match(tree.model()->index(0, 0), Qt::DisplayRole, text, 1,
                                        Qt::MatchExactly | Qt::MatchRecursive);
  return hits.isEmpty() ? QModelIndex() : hits.first().siblingAtColumn(column);
}

inline void clickCell(QTreeView& tree, const QModelIndex& index) {
  tree.scrollTo(index);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(index).center());
}
