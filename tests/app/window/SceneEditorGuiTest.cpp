// SPDX-License-Identifier: GPL-3.0-or-later
// The scene editor with the simulator, as a person uses it: a new room, its errors, and going on after an
// edit.
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>

#include "robotlink/base/AtomicFile.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/DialogAnswer.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneLanguage.h"

namespace app::test {
namespace {

struct SceneDesk : Desk {
  explicit SceneDesk(const std::filesystem::path& home)
      : Desk(home, Opens::kNothing), file(home / "rooms" / "hall.sdf") {}
  /// Why a command fails; empty: it does not.
  QString run(const std::string& line) {
    const auto done = workbench.commands().runLine(line);
    return done ? QString() : QString::fromStdString(done.error().describe());
  }
  widgets::SceneBench& bench() { return *window.context().scenes; }
  bool isChecked() { return bench().current() != nullptr && bench().current()->isChecked(); }
  /// Opens a new room with a robot by the dialog of the menu.
  void makeRoom() {
    DialogAnswer answer([](QDialog& dialog) {
      dialog.findChild<QLineEdit*>(QStringLiteral("newSceneName"))->setText(QStringLiteral("hall"));
      auto* robot = dialog.findChild<QComboBox*>(QStringLiteral("newSceneRobot"));
      robot->setCurrentIndex(robot->findText(QStringLiteral("burger")));
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    find<QAction>("file.newScene").trigger();
    QVERIFY(answer.asked());
    QCOMPARE(run("scene.save '" + file.string() + "'"), QString());
  }
  const std::filesystem::path file;
};

}  // namespace

class SceneEditorGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aNewRoomRunsAndGoesOnAfterAnEdit() {
    SceneDesk desk(home_);
    desk.makeRoom();
    QTRY_VERIFY_WITH_TIMEOUT(desk.isChecked(), kWaitMs);
    QVERIFY(desk.bench().current()->problems().empty());
    QVERIFY(desk.bench().run().has_value());
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QCOMPARE(desk.run("simulation.step"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->steps() == 2, kWaitMs);
    // The lamp is lower now, which is nothing to the robot.
    auto& text = desk.find<QPlainTextEdit>("sceneText");
    QString changed = text.toPlainText();
    QVERIFY(changed.contains(QStringLiteral("0.5 -0.5 3.5")));
    text.selectAll();
    text.insertPlainText(changed.replace(QStringLiteral("0.5 -0.5 3.5"), QStringLiteral("0.5 -0.5 2.5")));
    QVERIFY(desk.bench().hasUnsaved());
    QVERIFY(desk.bench().run().has_value());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.workbench.loading(), kWaitMs);
    QCOMPARE(desk.status()->steps(), 2U);
    QCOMPARE(robotlink::readFile(desk.file).value_or(""), changed.toStdString());
  }

  void theWindowStaysAsItIsWhenTheEditedSceneRuns() {
    SceneDesk desk(home_);
    QCOMPARE(desk.run("simulation.open field2002"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.makeRoom();
    QVERIFY(desk.bench().run().has_value());
    QTRY_VERIFY_WITH_TIMEOUT(desk.bench().runningScene() == desk.bench().current()->path(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.workbench.loading(), kWaitMs);
    // A robot on wheels would bring its own views otherwise.
    QVERIFY(desk.window.findChild<QPlainTextEdit*>(QStringLiteral("sceneText")) != nullptr);
  }

  void whatIsWrongIsFoundInTheTextThatIsNotSaved() {
    SceneDesk desk(home_);
    desk.makeRoom();
    auto& text = desk.find<QPlainTextEdit>("sceneText");
    const QString wrong =
        text.toPlainText().replace(QStringLiteral("<gravity>0 0 -9.81"), QStringLiteral("<gravity>0 0"));
    text.selectAll();
    text.insertPlainText(wrong);
    QTRY_VERIFY_WITH_TIMEOUT(desk.isChecked() && !desk.bench().current()->problems().empty(), kWaitMs);
    const widgets::SceneProblem& problem = desk.bench().current()->problems().front();
    QCOMPARE(problem.line, 5);
    QVERIFY(problem.file.empty());
    QVERIFY(QString::fromStdString(problem.text).contains(QStringLiteral("gravity")));
    QCOMPARE(desk.run("scene.save"), QString());
  }

  void theAppearanceChangesAndTheCursorStays() {
    SceneDesk desk(home_);
    desk.window.show();
    desk.makeRoom();
    QCOMPARE(desk.run("view.show scene-editor"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(desk.find<QPlainTextEdit>("sceneText").isVisible(), kWaitMs);
    auto& text = desk.find<QPlainTextEdit>("sceneText");
    QTextCursor cursor = text.textCursor();
    cursor.setPosition(200);
    cursor.setPosition(260, QTextCursor::KeepAnchor);
    text.setTextCursor(cursor);
    desk.find<QAction>("appearance.dark").trigger();
    const auto isKept = [&] {
      const QTextCursor now = desk.find<QPlainTextEdit>("sceneText").textCursor();
      return now.anchor() == 200 && now.position() == 260;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isKept(), kWaitMs);
    desk.find<QAction>("textSize.150").trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isKept(), kWaitMs);
    desk.find<QAction>("textSize.100").trigger();
    desk.find<QAction>("appearance.light").trigger();
  }

  void theSpecificationSaysWhatMayBeWritten() {
    SceneDesk desk(home_);
    const auto& language = *desk.window.context().sceneLanguage;
    const auto link = language.element({"sdf", "world", "model", "link"});
    QVERIFY(link.has_value());
    QVERIFY(!link->help.empty());
    QVERIFY(!language.children({"sdf", "world"}).empty());
    QVERIFY(language.modelFile("model://burger", desk.file).has_value());
  }
};

const widgets::test::GuiTest<SceneEditorGuiTest> kSceneEditorGuiTest;

}  // namespace app::test

#include "SceneEditorGuiTest.moc"
