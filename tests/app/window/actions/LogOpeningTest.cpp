// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/LogOpening.h"

#include <QAction>
#include <QMenu>
#include <QMimeData>
#include <QUrl>
#include <QtTest>

#include "app/robotcontrol/actions/CommandActions.h"
#include "tests/TestFolder.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {
namespace {

using robotlink::CommandTable;

/// The menu of logs, with commands that note how they were run.
struct ShownMenu {
  ShownMenu() {
    for (const char* name : {"log.open", "simulation.open", "layout.open", "color.open-pictures",
                             "robot.color-table", "motion.open", "view.show"})
      add(name, {{"file"}});
    add("log.add", {{"file"}, {"offset", CommandTable::Type::kNumber}});
    add("log.close", {});
    opening.fillMenu(menu);
  }
  void add(const char* name, std::vector<CommandTable::Argument> arguments) {
    commands.add({name, "", std::move(arguments),
                  [this, name](const CommandTable::Values& values) -> robotlink::Result<void> {
                    QString line = QLatin1String(name);
                    if (!values.empty())
                      line +=
                          QLatin1Char(' ') + QString::fromStdString(std::get<std::string>(values.front()));
                    ran << line;
                    return {};
                  }});
  }
  void drop(const QStringList& files, bool isAdded = false) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls << QUrl::fromLocalFile(file);
    data.setUrls(urls);
    opening.drop(data, isAdded);
  }
  QAction& action(const char* name) {
    auto* found = menu.findChild<QAction*>(QLatin1String(name));
    if (found == nullptr) qFatal("there is no %s", name);
    return *found;
  }
  QMenu& recentMenu() { return *menu.findChild<QMenu*>(QStringLiteral("recentLogs")); }

  QWidget window;
  QMenu menu{&window};
  QStringList ran;
  CommandTable commands;
  CommandActions actions{commands, &window};
  LogOpening opening{actions, &window};
};

QStringList paths(std::initializer_list<const char*> texts) {
  QStringList all;
  for (const char* text : texts) all << QLatin1String(text);
  return all;
}

}  // namespace

class LogOpeningTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void severalLogsThatAreDroppedShareOneTimeline() {
    ShownMenu shown;
    shown.drop(paths({"/logs/a.mcap", "/logs/b.log"}));
    QCOMPARE(shown.ran, paths({"log.open /logs/a.mcap", "log.add /logs/b.log"}));
    shown.ran.clear();
    shown.drop(paths({"/logs/c.mcap"}), true);
    QCOMPARE(shown.ran, paths({"log.add /logs/c.mcap"}));
  }

  void eachFileIsOpenedAsWhatItIs() {
    ShownMenu shown;
    shown.drop(paths({"/a/field.sdf", "/a/walk.yaml", "/a/frame.png", "/a/venue.c64"}));
    QCOMPARE(shown.ran, paths({"simulation.open /a/field.sdf", "layout.open /a/walk.yaml",
                               "color.open-pictures /a/frame.png", "robot.color-table /a/venue.c64"}));
    shown.ran.clear();
    shown.drop(paths({"/a/sit.mof", "/a/game.mcap"}));
    QCOMPARE(shown.ran,
             paths({"motion.open /a/sit.mof", "view.show motion-editor", "log.open /a/game.mcap"}));
  }

  void aFolderHasPicturesWhateverItIsCalled() {
    const TestFolder folder;
    std::filesystem::create_directories(folder / "frames.mcap");
    ShownMenu shown;
    shown.drop({QString::fromStdString((folder / "frames.mcap").string())});
    QCOMPARE(shown.ran.size(), 1);
    QVERIFY(shown.ran.front().startsWith(QStringLiteral("color.open-pictures ")));
  }

  void onlyFilesOfThisMachineAreTaken() {
    QMimeData data;
    QVERIFY(!LogOpening::takes(data));
    data.setText(QStringLiteral("/logs/a.mcap"));
    QVERIFY2(!LogOpening::takes(data), "a text is no file");
    data.setUrls({QUrl(QStringLiteral("https://robots.org/a.mcap"))});
    QVERIFY(!LogOpening::takes(data));
    ShownMenu shown;
    shown.opening.drop(data, false);
    QVERIFY(shown.ran.isEmpty());
    data.setUrls(
        {QUrl(QStringLiteral("https://robots.org/a.mcap")), QUrl::fromLocalFile(QStringLiteral("/b.mcap"))});
    QVERIFY(LogOpening::takes(data));
    shown.opening.drop(data, false);
    QCOMPARE(shown.ran, paths({"log.open /b.mcap"}));
  }

  void theLastTenLogsAreOfferedTheLatestFirst() {
    ShownMenu shown;
    QVERIFY(!shown.recentMenu().isEnabled());
    for (int i = 1; i <= 12; ++i) shown.opening.remember(QStringLiteral("/logs/%1.mcap").arg(i));
    QCOMPARE(shown.opening.recent().size(), 10);
    QCOMPARE(shown.opening.recent().front(), QStringLiteral("/logs/12.mcap"));
    shown.opening.remember(QStringLiteral("/logs/5.mcap"));
    QCOMPARE(shown.opening.recent().mid(0, 2), paths({"/logs/5.mcap", "/logs/12.mcap"}));
    QCOMPARE(shown.opening.recent().count(QStringLiteral("/logs/5.mcap")), 1);
    QVERIFY(shown.recentMenu().isEnabled());
    QAction& first = *shown.recentMenu().actions().front();
    QCOMPARE(first.text(), QStringLiteral("5.mcap"));
    QCOMPARE(first.toolTip(), QStringLiteral("/logs/5.mcap"));
    first.trigger();
    QCOMPARE(shown.ran, paths({"log.open /logs/5.mcap"}));
    shown.opening.setRecent({});
    QVERIFY(!shown.recentMenu().isEnabled() && shown.recentMenu().isEmpty());
  }

  void onlyAnOpenLogIsAddedToOrClosed() {
    ShownMenu shown;
    QVERIFY(!shown.action("addLog").isEnabled() && !shown.action("closeLog").isEnabled());
    QVERIFY(shown.action("openLog").isEnabled());
    shown.opening.setLogOpen(true);
    QVERIFY(shown.action("addLog").isEnabled());
    shown.action("closeLog").trigger();
    QCOMPARE(shown.ran, paths({"log.close"}));
    shown.opening.setLogOpen(false);
    QVERIFY(!shown.action("addLog").isEnabled());
  }
};

const widgets::test::GuiTest<LogOpeningTest> kLogOpeningTest;

}  // namespace app::test

#include "LogOpeningTest.moc"
