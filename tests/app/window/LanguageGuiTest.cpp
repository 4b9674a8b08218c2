// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the window.
#include <qtadvanceddocking/DockWidget.h>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLocale>
#include <QMenuBar>
#include <QPushButton>
#include <QStatusBar>
#include <clocale>

#include "app/robotcontrol/language/Language.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

QStringList menusOf(const MainWindow& window) {
  QStringList titles;
  for (const QAction* action : window.menuBar()->actions()) titles << action->text();
  return titles;
}

}  // namespace

class LanguageGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void theWindowIsInGerman() {
    const Translation german(Language::kGerman);
    QCOMPARE(german.problem(), QString());
    EmptyDesk desk(home_ / "german");
    QVERIFY(menusOf(desk.window).contains(QStringLiteral("&Fenster")));
    desk.window.docks().open(QStringLiteral("debug-keys"));
    desk.window.docks().open(QStringLiteral("motion"));
    QStringList titles;
    for (const auto* dock : desk.window.findChildren<ads::CDockWidget*>()) titles << dock->windowTitle();
    QVERIFY(titles.contains(QStringLiteral("Debug-Schlüssel")));
    QVERIFY(titles.contains(QStringLiteral("Bewegungstester")));
    // A text of the forms, which know no Qt, and one of the commands.
    QCOMPARE(desk.find<QAction>("robot.connect").text(), QStringLiteral("Mit einem &Pioneer verbinden…"));
    QVERIFY(desk.find<QAction>("simulation.start").toolTip().contains(QStringLiteral("Simulation")));
    // Names of commands stay.
    QVERIFY(desk.workbench.commands().runLine("view.close field"));
  }

  void theWindowIsInEnglishIfNothingIsChosen() {
    EmptyDesk desk(home_ / "english");
    QVERIFY(menusOf(desk.window).contains(QStringLiteral("&Window")));
    QVERIFY(desk.find<QAction>("language.system").isChecked());
  }

  void qtsOwnButtonsAreInGerman() {
    const Translation german(Language::kGerman);
    const QDialogButtonBox box(QDialogButtonBox::Cancel);
    QCOMPARE(box.button(QDialogButtonBox::Cancel)->text(), QStringLiteral("Abbrechen"));
  }

  void theLanguageIsChosenAndRemembered() {
    const std::filesystem::path home = home_ / "chosen";
    QCOMPARE(savedLanguage(home / "window.json"), Language::kSystem);
    {
      EmptyDesk desk(home);
      desk.choose("language.de");
      QVERIFY(desk.window.statusBar()->currentMessage().contains(QStringLiteral("Restart")));
      desk.window.keep();
      QCOMPARE(savedLanguage(home / "window.json"), Language::kGerman);
    }
    {
      EmptyDesk desk(home);
      QVERIFY(desk.find<QAction>("language.de").isChecked());
      QVERIFY(desk.workbench.commands().runLine("view.language en"));
      QVERIFY(desk.find<QAction>("language.en").isChecked());
      QVERIFY(!desk.workbench.commands().runLine("view.language klingon"));
      desk.window.keep();
    }
    QCOMPARE(savedLanguage(home / "window.json"), Language::kEnglish);
  }

  void theSystemsLanguageIsTheFirstThatIsKnown() {
    QCOMPARE(preferredLanguage({QStringLiteral("de-AT")}), Language::kGerman);
    QCOMPARE(preferredLanguage({QStringLiteral("fr-FR"), QStringLiteral("de")}), Language::kGerman);
    QCOMPARE(preferredLanguage({QStringLiteral("en-GB"), QStringLiteral("de")}), Language::kEnglish);
    QCOMPARE(preferredLanguage({QStringLiteral("C")}), Language::kEnglish);
    QCOMPARE(preferredLanguage({}), Language::kEnglish);
  }

  void numbersKeepTheirPoint() {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    useNumbersWithPoints();
    QDoubleSpinBox box;
    box.setValue(1.5);
    QCOMPARE(box.text(), QStringLiteral("1.50"));
    bool isNumber = true;
    QLocale().toDouble(QStringLiteral("1,5"), &isNumber);
    QVERIFY(!isNumber);
    QCOMPARE(std::setlocale(LC_NUMERIC, nullptr), "C");
    QLocale::setDefault(before);
  }
};

const widgets::test::GuiTest<LanguageGuiTest> kLanguageGuiTest;

}  // namespace app::test

#include "LanguageGuiTest.moc"
