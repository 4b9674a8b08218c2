// SPDX-License-Identifier: GPL-3.0-or-later
// The manual in the window.
#include <qtadvanceddocking/DockWidget.h>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>
#include <QTextDocument>

#include "app/robotcontrol/actions/ManualWindow.h"
#include "tests/TestFolder.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

void write(const std::filesystem::path& file, const char* text) {
  QFile to(QString::fromStdString(file.string()));
  QVERIFY(to.open(QIODevice::WriteOnly));
  to.write(text);
}

}  // namespace

class ManualGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void f1ShowsThePageOfTheViewThatHasTheFocus() {
    EmptyDesk desk(home_);
    QVERIFY(QTest::qWaitForWindowActive(&desk.window));
    desk.window.docks().open(QStringLiteral("console"));
    auto& input = desk.find<QLineEdit>("consoleInput");
    input.setFocus();
    QTest::keyClick(&input, Qt::Key_F1);
    auto& manual = desk.find<ManualWindow>("manual");
    QVERIFY(manual.isVisible());
    auto& text = desk.find<QTextBrowser>("manualText");
    QCOMPARE(text.source().fileName(), QStringLiteral("console.md"));
    QVERIFY(text.toPlainText().startsWith(QStringLiteral("Console")));
    desk.choose("help.manual");
    QVERIFY(manual.isVisible());
  }

  void pagesAreListedFoundAndLinked() {
    const TestFolder folder;
    write(folder / "index.md", "# Start\n\nSee [Curves](plots.md).\n");
    write(folder / "plots.md", "# Curves\n\nOver time.\n");
    write(folder / "keys.md", "# Debug keys\n\nOn and off.\n");
    QWidget window;
    ManualWindow manual(QString::fromStdString(folder.path().string()), &window);
    auto* list = manual.findChild<QListWidget*>(QStringLiteral("manualPages"));
    auto* text = manual.findChild<QTextBrowser*>(QStringLiteral("manualText"));
    auto* search = manual.findChild<QLineEdit*>(QStringLiteral("manualSearch"));
    QCOMPARE(list->count(), 3);
    QCOMPARE(list->item(0)->text(), QStringLiteral("Start"));
    manual.showPage(QStringLiteral("no-such-page"));
    QCOMPARE(text->toPlainText(), QStringLiteral("Start\nSee Curves."));
    text->setSource(text->source().resolved(QUrl(QStringLiteral("plots.md"))));  // as its link does
    QVERIFY(text->toPlainText().startsWith(QStringLiteral("Curves")));
    QCOMPARE(list->currentItem()->text(), QStringLiteral("Curves"));
    search->setText(QStringLiteral("off on"));
    QCOMPARE(list->count(), 1);
    list->setCurrentRow(0);
    QVERIFY(text->toPlainText().startsWith(QStringLiteral("Debug keys")));
    manual.findChild<QAction*>(QStringLiteral("manualBackAction"))->trigger();
    QVERIFY(text->toPlainText().startsWith(QStringLiteral("Curves")));
    search->clear();
    QCOMPARE(list->currentItem()->text(), QStringLiteral("Curves"));
  }
};

const widgets::test::GuiTest<ManualGuiTest> kManualGuiTest;

}  // namespace app::test

#include "ManualGuiTest.moc"
