// SPDX-License-Identifier: GPL-3.0-or-later
// Files of the window whose docks and toolbars are damaged, or are more than a window can have.
#include <qtadvanceddocking/DockWidget.h>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QToolBar>

#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {

class DamagedDocksGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aFileWithVeryManyViewsOpensTheFirstOnesAndSaysSo() {
    {
      Desk desk(home_);
      settle(desk);
      desk.window.close();
    }
    const QString name = QString::fromStdString((home_ / "window.json").string());
    QFile file(name);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QJsonObject root = QJsonDocument::fromJson(file.readAll()).object();
    file.close();
    QJsonObject all = root[QStringLiteral("perspectives")].toObject();
    QJsonObject play = all[QStringLiteral("Play")].toObject();
    QJsonArray views = play[QStringLiteral("views")].toArray();
    for (int i = 2; i < 2000; ++i)
      views.append(QJsonObject{{QStringLiteral("id"), QStringLiteral("messages")},
                               {QStringLiteral("dock"), QStringLiteral("messages#%1").arg(i)}});
    play[QStringLiteral("views")] = views;
    all[QStringLiteral("Play")] = play;
    for (const char* word : {"views", "perspectives"}) {
      root[QStringLiteral("perspectives")] = all;
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(QJsonDocument(root).toJson());
      file.close();
      app::Workbench workbench(home_);
      const app::MainWindow window(workbench, home_);
      QVERIFY(window.findChildren<ads::CDockWidget*>().size() <= app::ViewDocks::kMaxRestored);
      const auto* said = window.findChild<QLabel*>(QStringLiteral("errorText"));
      QVERIFY2(said->text().contains(QLatin1String(word)), qPrintable(said->text()));
      for (int i = 0; i < 500; ++i) all[QStringLiteral("of mine %1").arg(i)] = QJsonObject();
    }
  }

  void aDamagedLayoutIsRefusedAndLeavesTheDocksAsTheyAre_data() {
    QTest::addColumn<QString>("whole");
    QTest::addColumn<QString>("damaged");
    const auto splitter = QStringLiteral("<Splitter Orientation=\"-\" Count=");
    const auto container = QStringLiteral("<Container Floating=\"0\">");
    QTest::newRow("a splitter without a count") << splitter << splitter.chopped(1) + QStringLiteral("er=");
    QTest::newRow("two roots in a window")
        << container
        << container + QStringLiteral(
                           "<Area Tabs=\"1\" Current=\"messages#1\"><Widget Name=\"messages#1\" "
                           "Closed=\"0\"/></Area>");
    QTest::newRow("splitters a hundred thousand deep")
        << container
        << container + QStringLiteral("<Splitter Orientation=\"|\" Count=\"1\">").repeated(100000);
  }

  void aDamagedLayoutIsRefusedAndLeavesTheDocksAsTheyAre() {
    QFETCH(QString, whole);
    QFETCH(QString, damaged);
    EmptyDesk desk(home_);
    settle(desk);
    QJsonObject state = desk.window.docks().save();
    QString layout = state[QStringLiteral("docks")].toString();
    QVERIFY(layout.contains(whole));
    state[QStringLiteral("docks")] = layout.replace(whole, damaged);
    QVERIFY(!desk.window.docks().restore(state));
    settle(desk);
    QVERIFY(desk.window.docks().docks(QStringLiteral("messages")).front()->isVisible());
    QVERIFY(desk.window.docks().isOpen(QStringLiteral("scene")));
  }

  void aWindowOpensAtOnceWhateverItsFileSaysOfToolbars() {
    QJsonObject root, window;
    const auto file = QString::fromStdString((home_ / "window.json").string());
    {
      EmptyDesk desk(home_);
      desk.find<QToolBar>("recordingToolBar").hide();
      desk.window.close();
      QFile kept(file);
      QVERIFY(kept.open(QIODevice::ReadOnly));
      root = QJsonDocument::fromJson(kept.readAll()).object();
      window = root[QStringLiteral("window")].toObject();
    }
    QVERIFY(!EmptyDesk(home_).find<QToolBar>("recordingToolBar").isVisible());
    const auto state = QByteArray::fromBase64(window[QStringLiteral("toolbars")].toString().toLatin1());
    const auto lines = state.indexOf('\xfc') + 1;
    QVERIFY(lines > 0);
    for (const auto at : {lines, lines + 8}) {
      QByteArray damaged = state;
      damaged.replace(at, 4, "\x7f\xff\xff\xff");
      window[QStringLiteral("toolbars")] = QString::fromLatin1(damaged.toBase64());
      root[QStringLiteral("window")] = window;
      QFile written(file);
      QVERIFY(written.open(QIODevice::WriteOnly));
      written.write(QJsonDocument(root).toJson());
      written.close();
      EmptyDesk desk(home_);
      QVERIFY(desk.find<QToolBar>("simulationToolBar").isVisible());
    }
  }
};

const widgets::test::GuiTest<DamagedDocksGuiTest> kDamagedDocksGuiTest;

}  // namespace app::test

#include "DamagedDocksGuiTest.moc"
