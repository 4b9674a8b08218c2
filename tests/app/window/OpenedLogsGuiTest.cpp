// SPDX-License-Identifier: GPL-3.0-or-later
// Real log files in the whole window: opened, added, given up, closed again for a scene.
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QProgressBar>

#include "app/robotcontrol/QuitSignals.h"
#include "app/robotcontrol/actions/FileKind.h"
#include "robotlink/expressions/FieldPath.h"
#include "tests/app/ShortLog.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/game/Log.h"
#include "tests/logplayer/ForeignLog.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/search/SearchView.h"

namespace app::test {

class OpenedLogsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    WindowTest::initTestCase();
    QVERIFY(folder_.isValid());
    for (const char* name : {"first.mcap", "second.mcap"})
      QCOMPARE(ShortLog::write(file(name)), std::string());
  }
  void signalsHaveTheEffectThatTheyHadOnceNobodyWaitsForThem() {
    static int caught = 0;
    caught = 0;
    struct sigaction mine = {}, ignore = {}, keptHup = {}, keptTerm = {};
    mine.sa_handler = [](int) { ++caught; };
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGHUP, &mine, &keptHup);
    sigaction(SIGTERM, &ignore, &keptTerm);
    {
      const app::QuitSignals signals;
      ::raise(SIGHUP);
      QCOMPARE(caught, 0);
    }
    ::raise(SIGHUP);
    QCOMPARE(caught, 1);
    struct sigaction now = {};
    sigaction(SIGTERM, nullptr, &now);
    QVERIFY(now.sa_handler == SIG_IGN);
    sigaction(SIGTERM, &keptTerm, nullptr);
    sigaction(SIGHUP, &keptHup, nullptr);
  }

  void aFileIsWhatItsSuffixSaysInCapitalsOrNot() {
    using app::FileKind;
    QCOMPARE(app::kindOfFile("office.map"), FileKind::kScene);
    QCOMPARE(app::kindOfFile("FIELD.SDF"), FileKind::kScene);
    QCOMPARE(app::kindOfFile("OFFICE.MAP"), FileKind::kScene);
    QCOMPARE(app::kindOfFile("compact.yaml"), FileKind::kLayout);
    QCOMPARE(app::kindOfFile("COMPACT.YAML"), FileKind::kLayout);
    QCOMPARE(app::kindOfFile("frame.JPG"), FileKind::kPictures);
    QCOMPARE(app::kindOfFile(home_.parent_path()), FileKind::kPictures);
    QCOMPARE(app::kindOfFile("venue.tm"), FileKind::kColorTable);
    QCOMPARE(app::kindOfFile("game.mcap"), FileKind::kLog);
  }

  void theSimulationsButtonsGoWhileALogIsOpen() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    const auto& menu = *desk.find<QMenu>("simulationMenu").menuAction();
    const auto shown = [&] {
      return std::array{desk.find<QAction>("simulation.step").isVisible(),
                        desk.find<QComboBox>("speedBox").isVisible(), menu.isVisible()};
    };
    QCOMPARE(shown(), (std::array{true, true, true}));
    open(desk, "first.mcap");
    QCOMPARE(shown(), (std::array{false, false, false}));
    QVERIFY(desk.find<QComboBox>("sceneBox").isVisible());  // the way back
    QVERIFY(desk.find<QToolBar>("logToolBar").isVisible());
    desk.choose("closeLog");
    QTRY_COMPARE_WITH_TIMEOUT(shown(), (std::array{true, true, true}), kWaitMs);
    QVERIFY(!desk.find<QToolBar>("logToolBar").isVisible());
  }

  void whoOpensALogSeesItsPerspectiveUnlessHeChoseAnother() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    const auto shows = [&](const char* view) {
      return desk.window.docks().docks(QLatin1String(view)).size() == 1;
    };
    QVERIFY(shows("scene") && !shows("time-line"));
    open(desk, "first.mcap");
    QVERIFY(shows("time-line") && shows("replay-packages") && !shows("scene"));
    QVERIFY(desk.workbench.commands().run("simulation.open", {std::string("house")}));
    QTRY_VERIFY_WITH_TIMEOUT(shows("radar") && !shows("time-line"), kWaitMs);
    QVERIFY(desk.workbench.commands().run("simulation.open", {std::string("field2002")}));
    QTRY_VERIFY_WITH_TIMEOUT(shows("scene"), kWaitMs);
    desk.window.showPerspective(QStringLiteral("Colour"));
    open(desk, "second.mcap");
    QVERIFY(shows("color-image") && !shows("replay-packages"));
  }

  void aSecondLogIsAddedByItsFile() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(!desk.find<QAction>("addLog").isEnabled());
    open(desk, "first.mcap");
    desk.choose("addLog");
    auto& dialog = desk.find<QFileDialog>("openLogDialog");
    auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    name->setText(QString::fromStdString(file("second.mcap").string()));
    QTest::keyClick(name, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(desk.workbench.loaded()->sources.size(), std::size_t{2}, kWaitMs);
  }

  void aLogOfAnotherProgramSaysWhatIsInItAndCanBePlayed() {
    QVERIFY(logplayer::tests::writeForeignLog(file("foreign.mcap")));
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    open(desk, "first.mcap");
    auto& bar = desk.find<QWidget>("logContentsBar");
    QVERIFY(!bar.isVisible());
    QVERIFY(desk.workbench.commands().run("log.open", {file("foreign.mcap").string()}));
    QTRY_VERIFY_WITH_TIMEOUT(bar.isVisible(), kWaitMs);
    QVERIFY(desk.workbench.session().robots().empty());
    const QString text = desk.find<QLabel>("logContentsText").text();
    QVERIFY2(text.contains(QLatin1String("foreign.mcap contains no known robot")), qPrintable(text));
    QVERIFY2(text.contains(QLatin1String("It holds /rosout, a/b/c.")), qPrintable(text));
    QVERIFY2(text.contains(QLatin1String("Not decoded: /camera (flatbuffer), /odom (ros1).")),
             qPrintable(text));
    QTest::mouseClick(&desk.find<QToolButton>("logContents.log-streams"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(desk.has("streamsView"), kWaitMs);
    // Its values are in the history, as those of any robot.
    const auto pose = [&] {
      return desk.workbench.session().store().latest("a/b/c", desk.workbench.session().timeline().newest());
    };
    QVERIFY(desk.workbench.commands().run("log.jump", {0.15}));
    QTRY_VERIFY_WITH_TIMEOUT(pose() != nullptr && robotlink::numberAt(*pose()->value, "position.x") == 1.5,
                             kWaitMs);
    open(desk, "first.mcap");
    QTRY_VERIFY_WITH_TIMEOUT(!bar.isVisible(), kWaitMs);
  }

  void whatALogLacksIsComputedForASearchWhileTheShownProgramStays() {
    game::Log::write(file("game.log"));
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    open(desk, "game.log");
    QVERIFY(desk.workbench.commands().run("view.show", {std::string("search")}));
    auto& view = desk.find<widgets::SearchView>("searchView");
    auto& logs = *desk.window.context().logs;
    QTRY_VERIFY_WITH_TIMEOUT(!logs.logs().empty(), kWaitMs);
    const auto shown = logs.replay().shown();
    QVERIFY(view.search(QStringLiteral("models/ball.known >= 0"), false));
    QTRY_VERIFY_WITH_TIMEOUT(!view.isSearching(), kWaitMs);
    const QString state = desk.find<QLabel>("searchState").text();
    QVERIFY2(state.contains(QStringLiteral("Computed by the program: nao/models/ball")), qPrintable(state));
    QCOMPARE(view.hits().rowCount(), 1);
    QVERIFY(view.hits().row(0).from == game::Log::imageTime(0));
    QVERIFY(logs.replay().shown() == shown);
  }

  void openingSaysHowFarItIsAndCanBeGivenUp() {
    // Nothing marks where anything begins in what it holds, and all of that must be looked through.
    const auto slow = file("slow.mcap");
    std::filesystem::copy_file(file("first.mcap"), slow);
    std::error_code error;
    std::filesystem::resize_file(slow, std::uintmax_t{40} << 30U, error);
    if (error) QSKIP("files with holes cannot be made here");
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& bar = desk.find<QWidget>("openingBar");
    QVERIFY(!bar.isVisible());
    QVERIFY(desk.workbench.commands().run("log.open", {slow.string()}));
    QTRY_VERIFY_WITH_TIMEOUT(bar.isVisible() && desk.find<QProgressBar>("openingProgress").value() > 0,
                             kWaitMs);
    QTest::mouseClick(&desk.find<QToolButton>("openingCancel"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!bar.isVisible(), kWaitMs);
    QVERIFY(!desk.workbench.loaded()->isLogged());
    QVERIFY(desk.workbench.loaded()->isSimulated());
    QVERIFY(!desk.find<QWidget>("errorBar").isVisible());  // it was wanted
  }

 private:
  std::filesystem::path file(const char* name) const {
    return std::filesystem::path(folder_.path().toStdString()) / name;
  }
  void open(Desk& desk, const char* name) {
    QVERIFY(desk.workbench.commands().run("log.open", {file(name).string()}));
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.workbench.loaded()->isLogged() && desk.find<QToolBar>("logToolBar").isVisible(), kWaitMs);
  }

  QTemporaryDir folder_;
};

const widgets::test::GuiTest<OpenedLogsGuiTest> kOpenedLogsGuiTest;

}  // namespace app::test

#include "OpenedLogsGuiTest.moc"
