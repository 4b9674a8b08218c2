// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of colors that are not saved: asked about when the window is closed, back after a crash.
#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QStatusBar>

#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/colortool/SampleFixture.h"
#include "tests/widgets/DialogAnswer.h"
#include "widgets/color/ColorFiles.h"

namespace app::test {
namespace {

struct Sitting : EmptyDesk {
  using EmptyDesk::EmptyDesk;

  void passTime() {
    for (int i = 0; i < 62; ++i) window.tick();
  }
};

}  // namespace

class ColorFilesGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void closingAsksAboutSamplesThatAreNotSaved() {
    Sitting at(home_);
    at.colors().change(QStringLiteral("Strokes"), colortool::quarterSamples());
    at.passTime();
    {
      const DialogAnswer cancel(
          [](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::RejectRole); });
      QVERIFY(!at.window.close());
      QVERIFY(cancel.asked());
    }
    QVERIFY(at.window.isVisible());
    const DialogAnswer discard(
        [](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::DestructiveRole); });
    QVERIFY(at.window.close());
    QVERIFY(discard.asked());
    QTRY_VERIFY2(!std::filesystem::exists(home_ / "colors" / "recovery.samples"),
                 "what was given up must not come back");
  }

  void whatWasNotSavedComesBackAtTheNextStart() {
    {
      Sitting crashed(home_);
      crashed.colors().change(QStringLiteral("Strokes"), colortool::quarterSamples());
      crashed.passTime();
    }  // without being asked
    Sitting next(home_);
    QCOMPARE(next.colors().samples(), colortool::quarterSamples());
    QVERIFY(next.window.statusBar()->currentMessage().contains(QStringLiteral("4 strokes")));
    QVERIFY(next.workbench.commands().runLine("color.discard").has_value());
    QVERIFY(next.colors().samples().strokes.empty());
  }

  void aScriptsErrorIsShown() {
    Sitting at(home_);
    Q_EMIT at.colors().failed(QStringLiteral("the disk is full"));
    QCOMPARE(child<QLabel>(at.window, "errorText").text(), QStringLiteral("the disk is full"));
    QVERIFY(at.window.close());  // nothing to ask about
  }
};

const widgets::test::GuiTest<ColorFilesGuiTest> kColorFilesGuiTest;

}  // namespace app::test

#include "ColorFilesGuiTest.moc"
