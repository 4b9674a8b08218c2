// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog without robots; RobotsGuiTest connects some.
#include "app/robotcontrol/remote/RobotsDialog.h"

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "app/core/Workbench.h"
#include "app/core/deploy/RobotSet.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/remote/RobotColumns.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/Bench.h"

namespace app::test {
namespace {

using widgets::test::child;

/// The dialog, and what a person does with it.
struct OpenDialog {
  explicit OpenDialog(const std::filesystem::path& home) : workbench(home) { dialog.setVisible(true); }
  void press(const char* button) { child<QPushButton>(dialog, button).click(); }
  QTreeWidget& table() { return child<QTreeWidget>(dialog, "robotsTable"); }
  QTreeWidgetItem& row(int number) { return *table().topLevelItem(number); }
  QStringList names() {
    QStringList all;
    for (int i = 0; i < table().topLevelItemCount(); ++i) all << row(i).text(kSetName);
    return all;
  }
  QString state() { return child<QLabel>(dialog, "robotsState").text(); }

  Workbench workbench;
  CommandActions actions{workbench.commands(), nullptr};
  RobotsDialog dialog{workbench, actions};
};

}  // namespace

class RobotsDialogTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void addedRobotsHaveNamesOfTheirOwn() {
    OpenDialog open(home_);
    open.press("robotsAdd");
    open.press("robotsAdd");
    QCOMPARE(open.names(), (QStringList{QStringLiteral("robot1"), QStringLiteral("robot2")}));
    open.table().setCurrentItem(&open.row(0));
    open.press("robotsRemove");
    open.press("robotsAdd");
    QCOMPARE(open.names(), (QStringList{QStringLiteral("robot2"), QStringLiteral("robot3")}));
  }

  void whyRobotsCannotBeConnectedIsSaidOfEachOfThem() {
    OpenDialog open(home_);
    for (int i = 0; i < 3; ++i) {
      open.press("robotsAdd");
      open.row(i).setText(kSetAddress, QStringLiteral("nowhere://%1").arg(i));
    }
    open.row(1).setCheckState(kSetName, Qt::Unchecked);
    open.press("robotsConnect");
    const QStringList lines = open.state().split(QLatin1Char('\n'));
    QVERIFY2(lines.first().startsWith(QStringLiteral("robot1: ")), qPrintable(open.state()));
    QVERIFY2(lines.last().startsWith(QStringLiteral("robot3: ")), qPrintable(open.state()));
    QVERIFY(!open.state().contains(QStringLiteral("robot2: ")));
  }

  void theTipOfACellIsWhatIsInIt() {
    OpenDialog open(home_);
    open.press("robotsAdd");
    open.row(0).setText(kSetAddress, QStringLiteral("ws://10.0.0.1:8765"));
    QCOMPARE(open.row(0).toolTip(kSetAddress), QStringLiteral("ws://10.0.0.1:8765"));
  }

  void aSetThatCannotBeReadLeavesTheOneThatIsShown() {
    OpenDialog open(home_);
    open.press("robotsAdd");
    QVERIFY(robotlink::writeFileAtomically(home_ / "bad.yaml", "robots: 3\n").has_value());
    open.dialog.openSet(QString::fromStdString((home_ / "bad.yaml").string()));
    QVERIFY2(open.state().contains(QStringLiteral("bad.yaml")), qPrintable(open.state()));
    QCOMPARE(open.names(), QStringList{QStringLiteral("robot1")});
    QCOMPARE(open.dialog.file(), QString());
  }

  void whatCouldNotBeReadAgainIsNotSaved() {
    OpenDialog open(home_);
    const auto file = home_ / "set.yaml";
    const RobotSet set{"Home", {{.name = "red1", .address = "ws://10.0.0.1:8765"}}};
    QVERIFY(robotlink::writeFileAtomically(file, toText(set)).has_value());
    const auto before = robotlink::readFile(file);
    open.dialog.openSet(QString::fromStdString(file.string()));
    QVERIFY(!open.dialog.isWindowModified());
    open.row(0).setText(kSetName, QString());
    QVERIFY(open.dialog.isWindowModified());
    open.press("robotsSave");
    QVERIFY2(open.state().startsWith(QStringLiteral("Not saved: ")), qPrintable(open.state()));
    QVERIFY(open.dialog.isWindowModified());
    QCOMPARE(robotlink::readFile(file).value_or(""), before.value_or("?"));
    open.row(0).setText(kSetName, QStringLiteral(" red2 "));
    open.press("robotsSave");
    QVERIFY(!open.dialog.isWindowModified());
    const auto read = readRobotSet(file);
    QVERIFY(read.has_value());
    QCOMPARE(read->robots.front().name, std::string("red2"));
  }

  void withoutRobotsThereIsNothingToConnect() {
    OpenDialog open(home_);
    const auto isEnabled = [&](const char* button) {
      return child<QPushButton>(open.dialog, button).isEnabled();
    };
    for (const char* button : {"robotsConnect", "robotsDisconnect", "robotsCheck", "robotsDeploy",
                               "robotsRemove", "robotsChoose", "robotsRestart", "robotsCancel"})
      QVERIFY2(!isEnabled(button), button);
    open.press("robotsAdd");
    QVERIFY(isEnabled("robotsConnect") && isEnabled("robotsRemove") && !isEnabled("robotsChoose"));
    open.table().setCurrentItem(&open.row(0), kSetLayout);
    QVERIFY(isEnabled("robotsChoose"));
    open.press("robotsRemove");
    QVERIFY(!isEnabled("robotsConnect") && !isEnabled("robotsRemove"));
  }
};

const widgets::test::GuiTest<RobotsDialogTest> kRobotsDialogTest;

}  // namespace app::test

#include "RobotsDialogTest.moc"
