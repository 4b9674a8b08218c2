// SPDX-License-Identifier: GPL-3.0-or-later
// The commands about the window: that they do what its menus and buttons do.
#include <qtadvanceddocking/DockWidget.h>
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTemporaryDir>

#include "app/robotcontrol/actions/Appearance.h"
#include "foxglove/Image.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "widgets/plots/PlotsView.h"

namespace app::test {
namespace {

struct CommandDesk : EmptyDesk {
  using EmptyDesk::EmptyDesk;
  /// The error's id; empty: none.
  QString run(const QString& line) {
    const auto done = workbench.commands().runLine(line.toStdString());
    return done ? QString() : QString::fromStdString(done.error().id);
  }
  bool isOpen(const char* id) { return window.docks().isOpen(QLatin1String(id)); }
};

}  // namespace

class CommandsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void everyDeclaredCommandHasAHandlerInTheWorkbench() {
    CommandDesk desk(home_);
    const auto missing = desk.workbench.commands().unattached();
    QVERIFY2(missing.empty(), missing.empty() ? "" : missing.front().c_str());
  }

  void viewsAreShownClosedAndMaximized() {
    CommandDesk desk(home_);
    QCOMPARE(desk.run(QStringLiteral("view.show plots")), QString());
    QVERIFY(desk.window.docks().isInFront(QStringLiteral("plots")));
    QCOMPARE(desk.run(QStringLiteral("view.another plots")), QString());
    QCOMPARE(desk.window.docks().docks(QStringLiteral("plots")).size(), std::size_t{2});
    QCOMPARE(desk.run(QStringLiteral("view.close plots")), QString());
    QVERIFY(!desk.isOpen("plots"));
    auto* field = desk.window.docks().open(QStringLiteral("field"));
    auto* scene = desk.window.docks().open(QStringLiteral("scene"));
    QVERIFY(field->isVisible() && scene->isVisible());
    QCOMPARE(desk.run(QStringLiteral("view.maximize field")), QString());
    QVERIFY(field->isVisible() && !scene->isVisible());
    QCOMPARE(desk.run(QStringLiteral("view.maximize scene")), QString());
    QVERIFY(!field->isVisible() && scene->isVisible());
    QCOMPARE(desk.run(QStringLiteral("view.restore")), QString());
    QVERIFY(field->isVisible() && scene->isVisible());
    QCOMPARE(desk.run(QStringLiteral("view.close nothing")), QStringLiteral("view.unknown"));
  }

  void aViewThatDoesNotExistIsAnsweredWithThoseThatDo() {
    CommandDesk desk(home_);
    const auto reason = [&](const char* line) {
      const auto done = desk.workbench.commands().runLine(line);
      return done ? QString() : QString::fromStdString(done.error().text);
    };
    QVERIFY(reason("view.show plot").contains(QStringLiteral("did you mean 'plots'?")));
    QVERIFY(reason("view.screenshot camera-calibration x.png").contains(QStringLiteral("camera, color-")));
    QVERIFY(reason("view.close camera-calibration").contains(QStringLiteral("; there are ")));
  }

  void perspectivesAreShownSavedResetAndDeleted() {
    CommandDesk desk(home_);
    QCOMPARE(desk.run(QStringLiteral("view.perspective Motion")), QString());
    QTRY_VERIFY(desk.find<QAction>("perspective.Motion").isChecked());
    QVERIFY(desk.isOpen("motion"));
    QCOMPARE(desk.run(QStringLiteral("view.close motion")), QString());
    QCOMPARE(desk.run(QStringLiteral("view.save-perspective 'My own'")), QString());
    QVERIFY(desk.has("perspective.My own"));
    QCOMPARE(desk.run(QStringLiteral("view.perspective Motion")), QString());
    QCOMPARE(desk.run(QStringLiteral("view.reset")), QString());
    QTRY_VERIFY(desk.isOpen("motion"));
    QCOMPARE(desk.run(QStringLiteral("view.perspective 'My own'")), QString());
    QTRY_VERIFY(!desk.isOpen("motion"));
    QCOMPARE(desk.run(QStringLiteral("view.delete-perspective 'My own'")), QString());
    QTRY_VERIFY(!desk.has("perspective.My own"));
    QCOMPARE(desk.run(QStringLiteral("view.delete-perspective Play")), QStringLiteral("view.perspective"));
    QCOMPARE(desk.run(QStringLiteral("view.perspective Nowhere")), QStringLiteral("view.perspective"));
    QCOMPARE(desk.run(QStringLiteral("view.save-perspective ''")), QStringLiteral("view.perspective"));
  }

  void changesOfTheLayoutAreUndoneAndRedone() {
    CommandDesk desk(home_);
    desk.window.tick();
    QVERIFY(desk.isOpen("field"));
    QCOMPARE(desk.run(QStringLiteral("view.close field")), QString());
    QCOMPARE(desk.run(QStringLiteral("view.undo")), QString());
    QTRY_VERIFY(desk.isOpen("field"));
    QCOMPARE(desk.run(QStringLiteral("view.redo")), QString());
    QTRY_VERIFY(!desk.isOpen("field"));
  }

  void theAppearanceIsChosen() {
    CommandDesk desk(home_);
    QCOMPARE(desk.run(QStringLiteral("view.appearance dark")), QString());
    QVERIFY(desk.find<QAction>("appearance.dark").isChecked());
    QCOMPARE(desk.run(QStringLiteral("view.appearance light")), QString());
    QVERIFY(desk.find<QAction>("appearance.light").isChecked());
    QVERIFY(!desk.run(QStringLiteral("view.appearance purple")).isEmpty());
    QCOMPARE(desk.run(QStringLiteral("view.appearance system")), QString());
  }

  void anyViewIsSavedAsAPicture() {
    CommandDesk desk(home_);
    QTemporaryDir folder;
    for (const char* view : {"field", "messages", "plots"}) {
      const QString file = folder.filePath(QLatin1String(view) + QStringLiteral(".png"));
      QCOMPARE(desk.run(QStringLiteral("view.save %1 %2").arg(QLatin1String(view), file)), QString());
      QVERIFY2(QImage(file).width() > 50, view);
    }
    QVERIFY(!desk.run(QStringLiteral("view.save field /no/such/folder/field.png")).isEmpty());
    QVERIFY(!desk.run(QStringLiteral("view.save plots /no/such/folder/plots.png")).isEmpty());
    QCOMPARE(desk.run(QStringLiteral("view.save nothing x.png")), QStringLiteral("view.unknown"));
  }

  void aViewIsCopiedAsAPictureAndAsNumbers() {
    CommandDesk desk(home_);
    QCOMPARE(desk.run(QStringLiteral("view.copy field picture")), QString());
    QVERIFY(QApplication::clipboard()->image().width() > 50);
    QCOMPARE(desk.run(QStringLiteral("view.copy scene-tree numbers")), QString());
    QVERIFY(QApplication::clipboard()->text().startsWith(QStringLiteral("Object\tKind\tValue\n")));
    QCOMPARE(desk.run(QStringLiteral("view.copy plots numbers")), QString());
    QVERIFY(QApplication::clipboard()->text().startsWith(QStringLiteral("time_s")));
    QCOMPARE(desk.run(QStringLiteral("view.copy nothing numbers")), QStringLiteral("view.unknown"));
    QVERIFY(!desk.run(QStringLiteral("view.copy plots song")).isEmpty());
  }

  void aListIsShownAsColumns() {
    CommandDesk desk(home_);
    QCOMPARE(desk.run(QStringLiteral("columns.show 'range/laser: ranges'")), QString());
    QVERIFY(desk.isOpen("columns"));
    QCOMPARE(desk.run(QStringLiteral("columns.show red1/accelerometer field")), QStringLiteral("view.kind"));
    QCOMPARE(desk.run(QStringLiteral("image.show image gray")), QString());
  }

  void plotsGetAndLoseCurvesAndAreWrittenAsATable() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    const auto run = [&](const QString& line) {
      const auto done = desk.workbench.commands().runLine(line.toStdString());
      return done ? QString() : QString::fromStdString(done.error().id);
    };
    const QString curve = QStringLiteral("\"simulation: time\"");
    QCOMPARE(run(QStringLiteral("plots.add ") + curve), QString());
    QCOMPARE(run(QStringLiteral("plots.add ") + curve), QStringLiteral("plots.add"));
    QCOMPARE(run(QStringLiteral("plots.add \"simulation: time | average\"")),
             QStringLiteral("filter.number"));
    QVERIFY(desk.window.docks().isOpen(QStringLiteral("plots")));
    auto* view = qobject_cast<widgets::PlotsView*>(
        desk.window.docks().docks(QStringLiteral("plots")).front()->widget());
    QVERIFY(view->curves().contains(QStringLiteral("simulation: time")));
    const auto offered = desk.workbench.commands().find("plots.add")->offer({});
    QVERIFY(std::find(offered.begin(), offered.end(), "simulation: time") != offered.end());
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("points.csv"));
    QCOMPARE(run(QStringLiteral("view.save plots ") + file), QString());
    QFile table(file);
    QVERIFY(table.open(QIODevice::ReadOnly));
    QVERIFY(table.readLine().contains("simulation: time"));
    QVERIFY(!table.readLine().isEmpty());
    QCOMPARE(run(QStringLiteral("plots.remove ") + curve), QString());
    QCOMPARE(run(QStringLiteral("plots.remove ") + curve), QStringLiteral("plots.curve"));
    QCOMPARE(run(QStringLiteral("plots.add ") + curve), QString());
    QCOMPARE(run(QStringLiteral("plots.clear")), QString());
    QVERIFY(view->curves().isEmpty());
  }

  void whatAnImageViewShowsIsChosen() {
    CommandDesk desk(home_);
    const QString path = QStringLiteral("red1/camera/image");
    QCOMPARE(desk.run(QStringLiteral("image.stream image ") + path), QStringLiteral("image.stream"));
    desk.workbench.session().push({path.toStdString(), robotlink::Instant(std::chrono::seconds(1)),
                                   std::make_shared<foxglove::RawImage>()});
    desk.window.tick();
    QCOMPARE(desk.run(QStringLiteral("view.another image")), QString());
    QCOMPARE(desk.run(QStringLiteral("image.stream image#2 ") + path), QString());
    QCOMPARE(desk.run(QStringLiteral("image.compare image#2 %1 blend").arg(path)), QString());
    const auto docks = desk.window.docks().docks(QStringLiteral("image"));
    QCOMPARE(docks.size(), std::size_t{2});
    const auto state = [&](std::size_t i) {
      return static_cast<widgets::View*>(docks[i]->widget())->saveState();
    };
    QCOMPARE(state(1)[QStringLiteral("stream")].toString(), path);
    QVERIFY(state(1)[QStringLiteral("compare")].toBool());
    QVERIFY(state(0)[QStringLiteral("stream")].toString() != path);
    QCOMPARE(desk.run(QStringLiteral("image.compare image#2 none")), QString());
    QVERIFY(!state(1)[QStringLiteral("compare")].toBool());
    QCOMPARE(desk.run(QStringLiteral("image.stream field ") + path), QStringLiteral("view.kind"));
    QCOMPARE(desk.run(QStringLiteral("view.drawing field nothing off")), QStringLiteral("view.drawing"));
    QCOMPARE(desk.run(QStringLiteral("view.pose field models/pose")), QString());
    QCOMPARE(desk.run(QStringLiteral("view.pose field nowhere")), QStringLiteral("view.pose"));
    QCOMPARE(desk.run(QStringLiteral("view.pose image true")), QStringLiteral("view.poses"));
  }

  void theDataViewIsComparedAndMessagesArePublished() {
    CommandDesk desk(home_);
    QCOMPARE(desk.run(QStringLiteral("data.compare now --view field")), QStringLiteral("view.kind"));
    QCOMPARE(desk.run(QStringLiteral("data.compare logged")), QString());
    QVERIFY(desk.isOpen("data"));
    QCOMPARE(desk.run(QStringLiteral("data.compare nobody")), QStringLiteral("data.compare"));
    QCOMPARE(desk.run(QStringLiteral("data.publish set-goal '{\"x\": 1}'")), QStringLiteral("data.request"));
    QCOMPARE(desk.run(QStringLiteral("data.publish set-goal '{\"cancelled\": true}'")), QString());
    QCOMPARE(desk.run(QStringLiteral("data.publish nothing")), QStringLiteral("data.message"));
  }

  void messagesAreFilteredAndNothingIsUndoneWhereNothingWasEdited() {
    CommandDesk desk(home_);
    QCOMPARE(desk.run(QStringLiteral("messages.filter ball")), QString());
    QCOMPARE(desk.find<QLineEdit>("messagesFilter").text(), QStringLiteral("ball"));
    QCOMPARE(desk.run(QStringLiteral("messages.filter 'ball(' --regex on")),
             QStringLiteral("messages.filter"));
    QCOMPARE(desk.run(QStringLiteral("messages.filter")), QString());
    QCOMPARE(desk.find<QLineEdit>("messagesFilter").text(), QString());
    QCOMPARE(desk.run(QStringLiteral("parameters.undo")), QStringLiteral("parameters.undo"));
    QCOMPARE(desk.run(QStringLiteral("log.remove-bookmark goal")), QStringLiteral("log.none"));
  }

  void robotsAndTheBallArePlaced() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto& commands = desk.workbench.commands();
    QVERIFY(commands.runLine("scene.place red1 -0.5 0.25 1"));
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.robot() && std::abs(desk.robot()->x() + 0.5) < 0.02 && std::abs(desk.robot()->y() - 0.25) < 0.02,
        kWaitMs);
    const auto nobody = commands.runLine("scene.place nobody 0 0");
    QVERIFY(!nobody);
    QVERIFY(nobody.error().text.find("red1") != std::string::npos);
  }

  void whatWasTypedIsRememberedOverARestart() {
    {
      CommandDesk desk(home_);
      desk.window.docks().open(QStringLiteral("console"));
      auto& input = desk.find<QLineEdit>("consoleInput");
      input.setFocus();
      QTest::keyClicks(&input, QStringLiteral("view.show field"));
      QTest::keyClick(&input, Qt::Key_Return);
      QVERIFY(desk.window.docks().isInFront(QStringLiteral("field")));
      desk.window.keep();
    }
    CommandDesk again(home_);
    again.window.docks().open(QStringLiteral("console"));
    auto& input = again.find<QLineEdit>("consoleInput");
    QTest::keyClick(&input, Qt::Key_Up);
    QCOMPARE(input.text(), QStringLiteral("view.show field"));
  }

  void whatIsRefusedLaterIsShownInTheConsole() {
    CommandDesk desk(home_);
    desk.window.docks().open(QStringLiteral("console"));
    QCOMPARE(desk.run(QStringLiteral("simulation.start")), QString());
    QTRY_VERIFY(desk.find<QPlainTextEdit>("consoleOutput")
                    .toPlainText()
                    .startsWith(QStringLiteral("nothing is running that can do this")));
  }
};

const widgets::test::GuiTest<CommandsGuiTest> kCommandsGuiTest;

}  // namespace app::test

#include "CommandsGuiTest.moc"
