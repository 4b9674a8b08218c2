// SPDX-License-Identifier: GPL-3.0-or-later
// Several views of one kind, and their export as videos and images, in the window.
#include <qtadvanceddocking/DockWidget.h>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include "tests/TestFolder.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "widgets/RobotChoice.h"
#include "widgets/export/ExportBar.h"
#include "widgets/export/ExportDialog.h"

namespace app::test {
namespace {

struct ExportDesk : Desk {
  using Desk::Desk;
  QString run(const QString& line) {
    const auto done = workbench.commands().runLine(line.toStdString());
    return done ? QString() : QString::fromStdString(done.error().text);
  }
  QString outcome() { return find<QLabel>("exportText").text(); }
  /// Runs the simulation for a while, then pauses it.
  void play(double until) {
    click("simulation.start");
    if (!comes([&] { return status() != nullptr && status()->time() > until; }))
      qFatal("the simulation does not run");
    click("simulation.pause");
  }
  /// Waits for the end of the export.
  bool finishes() {
    return comes([this] { return find<QToolButton>("exportDismiss").isVisible(); });
  }
  widgets::View& view(const char* dock) {
    return *static_cast<widgets::View*>(window.docks().named(QLatin1String(dock))->widget());
  }
};

}  // namespace

class ExportGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aVideoOfTheFieldIsExportedFromTheMenu() {
    TestFolder folder;
    ExportDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.play(1.2);
    desk.window.docks().open(QStringLiteral("field"));
    desk.choose("file.export");
    auto& dialog = desk.find<widgets::ExportDialog>("exportDialog");
    auto& view = child<QComboBox>(dialog, "exportView");
    view.setCurrentIndex(view.findData(QStringLiteral("field#1")));
    const auto file = folder.path() / "field.avi";
    child<QComboBox>(dialog, "exportKind").setCurrentIndex(1);
    auto& target = child<QLineEdit>(dialog, "exportTarget");
    target.selectAll();
    QTest::keyClicks(&target, QString::fromStdString((folder.path() / "none" / "field.avi").string()));
    child<QDoubleSpinBox>(dialog, "exportFrom").setValue(0.2);
    child<QDoubleSpinBox>(dialog, "exportUntil").setValue(1);
    child<QDoubleSpinBox>(dialog, "exportRate").setValue(10);
    child<QSpinBox>(dialog, "exportWidth").setValue(320);
    child<QSpinBox>(dialog, "exportHeight").setValue(240);
    QTest::mouseClick(&child<QPushButton>(dialog, "exportOk"), Qt::LeftButton);
    QVERIFY(dialog.isVisible());
    QVERIFY(child<QLabel>(dialog, "exportProblem").text().contains(QStringLiteral("there is no folder")));
    target.setText(QString::fromStdString(file.string()));
    QTest::mouseClick(&child<QPushButton>(dialog, "exportOk"), Qt::LeftButton);
    QVERIFY(desk.find<widgets::ExportBar>("exportBar").isVisibleTo(&desk.window) || desk.finishes());
    QVERIFY(desk.finishes());
    QVERIFY2(desk.outcome().contains(QStringLiteral("field.avi: a video of 9 pictures")),
             qPrintable(desk.outcome()));
    QVERIFY(std::filesystem::file_size(file) > 5000);
    QVERIFY2(desk.workbench.session().timeline().live(), "the views follow the robot again");
  }

  void aScriptWaitsForImagesOfTheSecondView() {
    TestFolder folder;
    ExportDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.play(1);
    QCOMPARE(desk.run(QStringLiteral("view.show field")), QString());
    QCOMPARE(desk.run(QStringLiteral("view.another field")), QString());
    const QString line =
        QStringLiteral("export.images field#2 '%1' --from 0.5 --to 0.9 --rate=5 --size 200x150")
            .arg(QString::fromStdString((folder.path() / "pictures").string()));
    QCOMPARE(desk.run(line), QString());
    QVERIFY(desk.workbench.working() && *desk.workbench.working());
    QVERIFY2(desk.run(line).contains(QStringLiteral("under way")), "one after the other");
    QVERIFY(desk.finishes());
    QVERIFY(desk.workbench.working() && !*desk.workbench.working());
    for (const char* name : {"field-2-00001.png", "field-2-00003.png"}) {
      const QImage image(QString::fromStdString((folder.path() / "pictures" / name).string()));
      QCOMPARE(image.size(), QSize(200, 150));
    }
    QVERIFY(!QFile::exists(QString::fromStdString((folder.path() / "pictures/field-2-00004.png").string())));
    QVERIFY(desk.run(line).contains(QStringLiteral("earlier export")));
    QVERIFY(desk.run(QStringLiteral("export.video field a.mkv")).contains(QStringLiteral(".mp4 (H.264)")));
    QVERIFY(
        desk.run(QStringLiteral("export.video nothing a.avi")).contains(QStringLiteral("there is no view")));
    QVERIFY(desk.run(QStringLiteral("export.cancel")).contains(QStringLiteral("nothing is being exported")));
  }

  void anExportIsCanceledByItsCommand() {
    TestFolder folder;
    ExportDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.play(1);
    const QString file = QString::fromStdString((folder.path() / "scene.mp4").string());
    QCOMPARE(desk.run(QStringLiteral("export.video field '%1' --rate 200").arg(file)), QString());
    QCOMPARE(desk.run(QStringLiteral("export.cancel")), QString());
    QVERIFY(desk.finishes());
    QVERIFY(desk.outcome().startsWith(QStringLiteral("Canceled")));
    QVERIFY(std::filesystem::is_empty(folder.path()));
    QVERIFY(!desk.workbench.working());
  }

  void eachViewKeepsItsRobotOverARestart() {
    {
      ExportDesk desk(home_);
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
      QCOMPARE(desk.run(QStringLiteral("view.show field")), QString());
      desk.choose("another.field");
      child<widgets::RobotChoice>(desk.view("field#2"), "fieldRobot").setChoice(QStringLiteral("red1"));
      QTRY_COMPARE(desk.window.docks().named(QStringLiteral("field#2"))->windowTitle(),
                   QStringLiteral("Field, red1"));
      QVERIFY(child<widgets::RobotChoice>(desk.view("field#1"), "fieldRobot").choice().isEmpty());
      desk.window.keep();
    }
    ExportDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QCOMPARE(child<widgets::RobotChoice>(desk.view("field#2"), "fieldRobot").choice(),
             QStringLiteral("red1"));
    QVERIFY(child<widgets::RobotChoice>(desk.view("field#1"), "fieldRobot").choice().isEmpty());
  }
};

const widgets::test::GuiTest<ExportGuiTest> kExportGuiTest;

}  // namespace app::test

#include "ExportGuiTest.moc"
