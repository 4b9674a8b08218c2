// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/ProblemReport.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QPlainTextEdit>

#include "app/core/Workbench.h"
#include "foxglove/Robot.pb.h"
#include "tests/app/TickUntil.h"
#include "tests/app/open/FakeFeed.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/Bench.h"
#include "widgets/console/CommandLog.h"

namespace app::test {
namespace {

using widgets::CommandLog;

/// A workbench of which somebody reports a problem.
struct Reporter {
  explicit Reporter(const std::filesystem::path& home) : workbench(home) {}
  bool open(const LoadedPlatform& loaded) {
    workbench.open(fakeOpening(loaded, std::make_shared<FeedNotes>()));
    return tickUntil(workbench, [this] { return !workbench.loading(); });
  }
  void publish(const std::string& text, int seconds, const char* path = "red1/log") {
    auto message = std::make_shared<foxglove::Log>();
    message->set_message(text);
    message->set_name("motion");
    message->set_level(foxglove::Log::WARNING);
    workbench.session().push({path, robotlink::Instant(std::chrono::seconds(seconds)), message});
    workbench.session().tick();
  }
  QString report(const QJsonObject& window = {}) { return problemReport(workbench, log, window); }
  /// What stands below a title.
  QString section(const char* title, const QJsonObject& window = {}) {
    const QString all = report(window), head = QStringLiteral("\n## %1\n\n").arg(QLatin1String(title));
    const int at = all.indexOf(head);
    if (at < 0) qFatal("there is no section %s", title);
    const int begin = at + head.size(), end = all.indexOf(QLatin1String("\n\n## "), begin);
    return all.mid(begin, end < 0 ? -1 : end - begin).trimmed();
  }

  Workbench workbench;
  CommandLog log{workbench.commands(), workbench.session()};
};

}  // namespace

class ProblemReportTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void withoutAnythingOpenItSaysSo() {
    Reporter reporter(home_);
    QVERIFY(reporter.section("Versions").contains(QStringLiteral("Qt ") + QLatin1String(qVersion())));
    for (const char* title : {"Open", "Layout", "Last messages", "Commands and errors"})
      QCOMPARE(reporter.section(title), QStringLiteral("(none)"));
  }

  void whatIsOpenIsListedWithItsLayout() {
    Reporter reporter(home_);
    LoadedPlatform loaded = fakePlatform("tcp://robot:8101");
    loaded.lostChoices = {"red1 could not keep its goal"};
    const auto layout = home_ / "walk.yaml";
    QFile file(QString::fromStdString(layout.string()));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("processes: [motion]") > 0);
    file.close();
    loaded.layout = layout;
    QVERIFY(reporter.open(loaded));
    QCOMPARE(reporter.section("Open"),
             QStringLiteral(
                 "Platform: fake\nSource: tcp://robot:8101\nRobot: red1\nred1 could not keep its goal"));
    QVERIFY(
        reporter.section("Layout").endsWith(QStringLiteral("walk.yaml\n\n```\nprocesses: [motion]\n```")));
  }

  void aLayoutThatCannotBeReadSaysWhy() {
    Reporter reporter(home_);
    LoadedPlatform loaded = fakePlatform("rover");
    loaded.layout = home_ / "gone.yaml";
    QVERIFY(reporter.open(loaded));
    QVERIFY(reporter.section("Layout").contains(QStringLiteral("gone.yaml")));
    QVERIFY(!reporter.section("Layout").contains(QStringLiteral("```")));
  }

  void theLastMessagesOfAllRobotsAreInTheOrderOfTime() {
    Reporter reporter(home_);
    reporter.publish("the leg is hot", 3);
    reporter.publish("the sonar is deaf", 2, "blue1/log");
    const QStringList lines = reporter.section("Last messages").split(QLatin1Char('\n'));
    QCOMPARE(lines, (QStringList{QStringLiteral("```"),
                                 QStringLiteral("2.000  WARNING  blue1/log  motion: the sonar is deaf"),
                                 QStringLiteral("3.000  WARNING  red1/log  motion: the leg is hot"),
                                 QStringLiteral("```")}));
    for (int i = 0; i < 300; ++i) reporter.publish("message " + std::to_string(i), 10 + i);
    const QString last = reporter.section("Last messages");
    QCOMPARE(last.count(QLatin1Char('\n')), 200 + 1);
    QVERIFY(last.contains(QStringLiteral("message 299\n")) && last.contains(QStringLiteral("message 100\n")));
    QVERIFY2(!last.contains(QStringLiteral("message 99\n")), "the last two hundred");
  }

  void whatWasTypedIsToldFromWhatCameOfIt() {
    Reporter reporter(home_);
    reporter.log.add(CommandLog::Kind::kCommand, QStringLiteral("robot.walk 1"));
    reporter.log.add(CommandLog::Kind::kError, QStringLiteral("there is no robot"));
    QCOMPARE(reporter.section("Commands and errors"),
             QStringLiteral("```\n> robot.walk 1\nthere is no robot\n```"));
    for (int i = 0; i < 150; ++i) reporter.log.add(CommandLog::Kind::kOutput, QString::number(i));
    const QString shown = reporter.section("Commands and errors");
    QVERIFY(shown.startsWith(QStringLiteral("```\n50\n")) && shown.endsWith(QStringLiteral("\n149\n```")));
  }

  void theHomeOfTheUserIsNotSaid() {
    Reporter reporter(home_);
    const QString home = QDir::homePath();
    LoadedPlatform loaded = fakePlatform((home + QStringLiteral("/scenes/a.sdf")).toStdString());
    loaded.sources.push_back((home + QStringLiteral("-of-another/b.sdf")).toStdString());
    QVERIFY(reporter.open(loaded));
    const QString open = reporter.section("Open");
    QVERIFY(open.contains(QStringLiteral("Source: ~/scenes/a.sdf")));
    QVERIFY2(open.contains(home + QStringLiteral("-of-another/b.sdf")), qPrintable(open));
    QVERIFY(reporter.section("Window", {{QStringLiteral("folder"), home}})
                .contains(QStringLiteral("\"folder\": \"~\"")));
  }

  void theDialogAddsWhatTheUserWroteAndCopiesIt() {
    QWidget window;
    ProblemDialog dialog(QStringLiteral("\n## Versions\n\n1\n"), &window);
    QCOMPARE(dialog.text(),
             QStringLiteral("# A problem with RobotControl\n\n(nothing written)\n\n## Versions\n\n1\n"));
    auto& story = widgets::test::child<QPlainTextEdit>(dialog, "problemStory");
    QTest::keyClicks(&story, QStringLiteral(" The robot fell. "));
    QVERIFY(widgets::test::child<QPlainTextEdit>(dialog, "problemReport").isReadOnly());
    widgets::test::click(dialog, "problemCopy");
    QCOMPARE(QApplication::clipboard()->text(),
             QStringLiteral("# A problem with RobotControl\n\nThe robot fell.\n\n## Versions\n\n1\n"));
  }
};

const widgets::test::GuiTest<ProblemReportTest> kProblemReportTest;

}  // namespace app::test

#include "ProblemReportTest.moc"
