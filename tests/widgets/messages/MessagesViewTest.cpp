// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/MessagesView.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>

#include "foxglove/Robot.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"
#include "tests/widgets/LogBench.h"
#include "tests/widgets/timeline/MadeUpArchive.h"

namespace widgets::test {

using foxglove::Log;

namespace {

Log log(Log::Level level, const std::string& source, const std::string& text) {
  Log message;
  message.set_level(level);
  message.set_name(source);
  message.set_message(text);
  return message;
}

void someMessages(Bench& bench) {
  bench.push("red1/log", log(Log::INFO, "cognition/ball-percept", "ball seen"), 1.0);
  bench.push("red1/log", log(Log::WARNING, "motion/walk", "paw slips"), 1.1);
  bench.push("blue1/log", log(Log::ERROR, "cognition/behavior", "lost the ball"), 1.2);
  bench.push("red1/log", log(Log::DEBUG, "cognition/pose", "42 particles"), 1.3);
}

QString cell(const QTableView& table, int row, int column) {
  return table.model()->index(row, column).data().toString();
}

}  // namespace

class MessagesViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatAllRobotsSayComesInOrderOfTime() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    auto& table = child<QTableView>(*view, "messagesTable");
    QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QVERIFY(child<QLabel>(*view, "emptyHint").isVisible());
    someMessages(bench);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 4);
    QCOMPARE(cell(table, 2, 0), QStringLiteral("1.200"));
    QCOMPARE(cell(table, 2, 1), QStringLiteral("error"));
    QCOMPARE(cell(table, 2, 2), QStringLiteral("blue1"));
    QCOMPARE(cell(table, 2, 3), QStringLiteral("cognition/behavior"));
    QCOMPARE(cell(table, 2, 4), QStringLiteral("lost the ball"));
  }

  void whatIsShownIsSavedAsTableOrTextAndNothingElse() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    bench.push("red1/log", log(Log::INFO, "a", "one, \"two\""), 1.0);
    bench.push("red1/log", log(Log::ERROR, "b", "three"), 2.0);
    bench.tick(*view);
    const TestFolder folder;
    const auto save = [&](const char* name) {
      return view->saveTo(QString::fromStdString((folder / name).string()));
    };
    QVERIFY(save("m.csv"));
    const std::string csv = robotlink::readFile(folder / "m.csv").value_or("none");
    QVERIFY2(
        csv.find("1.000,info,red1,a,\"one, \"\"two\"\"\"\n2.000,error,red1,b,three\n") != std::string::npos,
        csv.c_str());
    QVERIFY(csv.starts_with("Time"));
    QVERIFY(save("m.txt"));
    QVERIFY(robotlink::readFile(folder / "m.txt").value_or("none").find("error\tred1\tb\tthree\n") !=
            std::string::npos);
    const auto refused = save("m.json");
    QVERIFY(!refused);
    QVERIFY(refused.error().text.find(".png") != std::string::npos);
    QVERIFY(!std::filesystem::exists(folder / "m.json"));
  }

  void afterAJumpOnlyWhatWasSaidBeforeIsShown() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    auto& table = child<QTableView>(*view, "messagesTable");
    bench.push("red1/log", log(Log::INFO, "behavior", "kicked"), 8.72);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 1);
    bench.session.restart();  // as many as before, but others
    bench.push("red1/log", log(Log::INFO, "behavior", "the ball is seen"), 0.04);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 1);
    QCOMPARE(cell(table, 0, 4), QStringLiteral("the ball is seen"));
    bench.session.restart();  // more than before, and later
    bench.push("red1/log", log(Log::INFO, "behavior", "walks"), 2);
    bench.push("red1/log", log(Log::INFO, "behavior", "kicks"), 3);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 2);
    QCOMPARE(cell(table, 0, 4), QStringLiteral("walks"));
    bench.session.restart();
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 0);
  }

  void afterAResetWhatWasSaidLaterIsGone() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    auto& table = child<QTableView>(*view, "messagesTable");
    bench.push("red1/log", log(Log::INFO, "behavior", "kicked"), 8);
    bench.push("blue1/log", log(Log::INFO, "behavior", "fell"), 9);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 2);
    bench.push("red1/log", log(Log::INFO, "behavior", "stands"), 0.1);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 1);
    QCOMPARE(cell(table, 0, 4), QStringLiteral("stands"));
  }

  void allThatALogHoldsIsListedBeforeItIsPlayed() {
    LogBench bench;
    bench.shapeOverview = [](widgets::LogOverview& overview) {
      std::vector<widgets::LogEntry> texts = overview.said;
      texts.push_back({at(35), widgets::LogEntry::Level::kInfo, QStringLiteral("nao"),
                       QStringLiteral("motion"), QStringLiteral("stands")});
      overview.texts = std::make_shared<const std::vector<widgets::LogEntry>>(std::move(texts));
    };
    bench.openLog("/logs/game.mcap");
    auto view = bench.openView<widgets::MessagesView>();
    bench.showTime(18.5);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "messagesTable");
    QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(table.model()->rowCount(), 3);
    QCOMPARE(cell(table, 0, 0), QStringLiteral("8.000"));
    QCOMPARE(table.currentIndex().row(), 0);
    // What is played is the same message; what a program recomputes stands between the others.
    bench.push("nao/log", log(Log::ERROR, "motion", "a servo does not answer"), 31);
    bench.push("nao/log", log(Log::INFO, "cognition", "computed here"), 30);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 4);
    QCOMPARE(cell(table, 1, 4), QStringLiteral("computed here"));
    const QRect row = table.visualRect(table.model()->index(3, widgets::LogModel::kText));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, row.center());
    QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, row.center());
    QCOMPARE(bench.asked().time(), at(35).time_since_epoch().count());
  }

  void aFullTableDropsItsOldestTextForANewerOne() {
    widgets::LogModel model(3);
    QAbstractItemModelTester tester(&model);
    const auto entry = [](int second) {
      widgets::LogEntry one;
      one.time = robotlink::Instant(std::chrono::seconds(second));
      one.text = QString::number(second);
      return one;
    };
    model.append({entry(2), entry(4), entry(6)});
    model.insert({entry(1), entry(5), entry(7)});
    QStringList texts;
    for (int row = 0; row < model.rowCount(); ++row) texts << model.entry(row).text;
    QCOMPARE(texts, QStringList({QStringLiteral("5"), QStringLiteral("6"), QStringLiteral("7")}));
  }

  void whatCameLateStandsWhereItsTimeBelongs() {
    widgets::LogModel model(1000);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    const auto entry = [](double time) {
      widgets::LogEntry made;
      made.time = at(time);
      return made;
    };
    model.insert({entry(1), entry(3)});
    model.insert({entry(4), entry(2)});
    QCOMPARE(model.rowAt(at(2.5)), 1);
    QCOMPARE(model.entry(3).time, at(4));
    QCOMPARE(model.rowAt(at(0.5)), -1);
  }

  void oneMessageIsNotCalledMessages() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    bench.push("red1/log", log(Log::INFO, "a", "only"), 1);
    bench.tick(*view);
    QCOMPARE(child<QLabel>(*view, "messagesState").text(), QStringLiteral("1 message"));
  }

  void nothingIsShownTwiceAndAMessageThatCameLateIsNotLost() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    auto& table = child<QTableView>(*view, "messagesTable");
    someMessages(bench);
    bench.tick(*view);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 4);
    bench.push("red1/log", log(Log::INFO, "a", "new"), 2.0);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 5);
    QCOMPARE(cell(table, 4, 4), QStringLiteral("new"));
  }

  void filtersByLevelRobotAndText() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    someMessages(bench);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "messagesTable");
    auto& level = child<QComboBox>(*view, "messagesLevel");
    level.setCurrentIndex(level.findText(QStringLiteral("warning")));
    QCOMPARE(table.model()->rowCount(), 2);
    auto& robot = child<QComboBox>(*view, "messagesRobot");
    robot.setCurrentIndex(robot.findText(QStringLiteral("blue1")));
    QCOMPARE(table.model()->rowCount(), 1);
    level.setCurrentIndex(0);
    robot.setCurrentIndex(0);
    QTest::keyClicks(&child<QLineEdit>(*view, "messagesFilter"), QStringLiteral("BALL"));
    QCOMPARE(table.model()->rowCount(), 2);
    QCOMPARE(child<QLabel>(*view, "messagesState").text(), QStringLiteral("2 of 4 messages"));
  }

  void aWrongExpressionIsExplainedAndTheFilterStays() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    someMessages(bench);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "messagesTable");
    click(child<QToolButton>(*view, "messagesRegex"));
    auto& filter = child<QLineEdit>(*view, "messagesFilter");
    QTest::keyClicks(&filter, QStringLiteral("^ball|^paw"));
    QCOMPARE(table.model()->rowCount(), 2);
    QTest::keyClicks(&filter, QStringLiteral("("));
    QVERIFY(child<QLabel>(*view, "messagesProblem").isVisible());
    QCOMPARE(table.model()->rowCount(), 2);
    filter.clear();
    QVERIFY(!child<QLabel>(*view, "messagesProblem").isVisible());
    QCOMPARE(table.model()->rowCount(), 4);
  }

  void theFilterIsReadAnewWhenItBecomesAnExpression() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    someMessages(bench);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "messagesTable");
    QTest::keyClicks(&child<QLineEdit>(*view, "messagesFilter"), QStringLiteral("ball|paw"));
    QCOMPARE(table.model()->rowCount(), 0);
    click(child<QToolButton>(*view, "messagesRegex"));
    QCOMPARE(table.model()->rowCount(), 3);
  }

  void theFilterIsSetByCommands() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    someMessages(bench);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "messagesTable");
    QVERIFY(view->setFilter("^ball|^paw", true));
    QCOMPARE(table.model()->rowCount(), 2);
    QVERIFY(!view->setFilter("(", true));
    QVERIFY(view->setFilter("(", false));
    QCOMPARE(table.model()->rowCount(), 0);
    QVERIFY(view->setFilter("", false));
    QCOMPARE(table.model()->rowCount(), 4);
    QVERIFY(!child<QToolButton>(*view, "messagesRegex").isChecked());
  }

  void enterSearchesOn() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    someMessages(bench);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "messagesTable");
    auto& search = child<QLineEdit>(*view, "messagesSearch");
    QTest::keyClicks(&search, QStringLiteral("ball"));
    const int first = table.currentIndex().row();
    QTest::keyClick(&search, Qt::Key_Return);
    QVERIFY(table.currentIndex().row() != first);
  }

  void searchGoesFromMatchToMatchAndAround() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    someMessages(bench);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "messagesTable");
    QTest::keyClicks(&child<QLineEdit>(*view, "messagesSearch"), QStringLiteral("ball"));
    QCOMPARE(table.currentIndex().row(), 0);
    click(child<QToolButton>(*view, "messagesNext"));
    QCOMPARE(table.currentIndex().row(), 2);
    click(child<QToolButton>(*view, "messagesNext"));
    QCOMPARE(table.currentIndex().row(), 0);
    click(child<QToolButton>(*view, "messagesPrevious"));
    QCOMPARE(table.currentIndex().row(), 2);
  }

  void pauseHoldsMessagesBackAndClearEmptiesTheList() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    auto& table = child<QTableView>(*view, "messagesTable");
    click(child<QToolButton>(*view, "messagesPause"));
    someMessages(bench);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 0);
    click(child<QToolButton>(*view, "messagesPause"));
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 4);
    click(child<QToolButton>(*view, "messagesClear"));
    QCOMPARE(table.model()->rowCount(), 0);
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 0);
  }

  void whatIsOnDiskIsListedWhenTheViewIsOpenedOrSeenAgain() {
    Bench bench;
    bench.session.history().setArchive(std::make_unique<MadeUpArchive>(true));
    bench.session.store().setBytes(20'000);
    int said = 0;
    const auto say = [&] {
      for (const int end = said + 300; said < end; ++said) {
        bench.push("red1/log", log(Log::INFO, "a", "text " + std::to_string(said)), 1 + 0.1 * said);
        if (said % 10 == 0) bench.session.tick();
      }
    };
    say();
    auto view = bench.open<widgets::MessagesView>();
    auto& table = child<QTableView>(*view, "messagesTable");
    const auto isListed = [&] {
      return QTest::qWaitFor([&] {
        bench.tick(*view);
        return table.model()->rowCount() == said;
      });
    };
    QVERIFY(isListed());
    // Nobody ticks it, as while it is closed.
    say();
    QVERIFY(bench.session.store().find("red1/log")->messages.size() < 300);
    QVERIFY(isListed());
    for (int row = 0; row < said; ++row) QCOMPARE(cell(table, row, 4), QStringLiteral("text %1").arg(row));
    // In a pause and behind another tab.
    say();
    view->tickHidden();
    QVERIFY(isListed());
  }

  void selectedRowsAreCopied() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    someMessages(bench);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "messagesTable");
    table.selectRow(1);
    click(child<QToolButton>(*view, "messagesCopy"));
    QCOMPARE(QApplication::clipboard()->text(),
             QStringLiteral("1.100\twarning\tred1\tmotion/walk\tpaw slips"));
  }

  void followsTheNewestUntilSomebodyScrollsUp() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    auto& table = child<QTableView>(*view, "messagesTable");
    for (int i = 0; i < 200; ++i) bench.push("red1/log", log(Log::INFO, "a", "line"), 1 + i * 0.01);
    bench.tick(*view);
    auto& bar = *table.verticalScrollBar();
    QCOMPARE(bar.value(), bar.maximum());
    bar.triggerAction(QAbstractSlider::SliderPageStepSub);
    QVERIFY(!child<QToolButton>(*view, "messagesFollow").isChecked());
    const int where = bar.value();
    bench.push("red1/log", log(Log::INFO, "a", "line"), 9);
    bench.tick(*view);
    QCOMPARE(bar.value(), where);
    click(child<QToolButton>(*view, "messagesFollow"));
    QCOMPARE(bar.value(), bar.maximum());
  }

  void anInstantOfTheTimelineIsTheCurrentRow() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    someMessages(bench);
    bench.tick(*view);
    bench.session.timeline().show(robotlink::Instant(robotlink::fromSeconds(1.15)));
    bench.tick(*view);
    QCOMPARE(child<QTableView>(*view, "messagesTable").currentIndex().row(), 1);
  }

  void theTableIsBoundedAndABatchIsOneInsertion() {
    widgets::LogModel model(1000);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    for (int i = 0; i < 30; ++i) model.append(std::vector<widgets::LogEntry>(50));
    QCOMPARE(inserted.count(), 30);
    QVERIFY(model.rowCount() <= 1000 && model.rowCount() >= 950);
    model.append(std::vector<widgets::LogEntry>(5000));
    QCOMPARE(model.rowCount(), 1000);
  }

  void filtersAreKept() {
    Bench bench;
    auto view = bench.open<widgets::MessagesView>();
    child<QComboBox>(*view, "messagesLevel").setCurrentIndex(3);
    child<QLineEdit>(*view, "messagesFilter").setText(QStringLiteral("ball"));
    click(child<QToolButton>(*view, "messagesFollow"));
    auto again = bench.open<widgets::MessagesView>();
    again->restoreState(view->saveState());
    QCOMPARE(child<QComboBox>(*again, "messagesLevel").currentIndex(), 3);
    QCOMPARE(child<QLineEdit>(*again, "messagesFilter").text(), QStringLiteral("ball"));
    QVERIFY(!child<QToolButton>(*again, "messagesFollow").isChecked());
  }
};

const GuiTest<MessagesViewTest> kMessagesViewTest;

}  // namespace widgets::test

#include "MessagesViewTest.moc"
