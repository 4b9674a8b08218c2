// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/search/SearchView.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>
#include <cmath>

#include "foxglove/Robot.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/widgets/LogBench.h"
#include "tests/widgets/timeline/MadeUpArchive.h"
#include "widgets/Theme.h"
#include "widgets/log/TimeMarks.h"
#include "widgets/timeline/TimeLineCanvas.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets::test {
namespace {

/// A log from 10 to 40 s whose file exists: the ball goes from 0 to 3 m, and back at once, every 10 s; texts.
struct SearchedLog : LogBench {
  SearchedLog() {
    auto writer = logplayer::LogWriter::create(file, {});
    if (!writer) qFatal("the log cannot be written");
    for (int i = 0; i < 300; ++i) {
      auto ball = std::make_shared<robotcontrol::BallModel>();
      ball->mutable_position_in_robot()->set_x(0.03 * (i % 100));
      auto log = std::make_shared<foxglove::Log>();
      log->set_message("frame " + std::to_string(i));
      const auto time = at(10 + 0.1 * i);
      if (!(*writer)->write({{"nao/models/ball", time, ball}, {"nao/log", time, log}}))
        qFatal("the log cannot be written");
    }
    if (!(*writer)->container().close()) qFatal("the log cannot be written");
    shapeOverview = [](LogOverview& overview) {
      overview.streams.push_back({"nao/models/ball", "robotcontrol.BallModel", 300, 0, at(10), at(39.9)});
    };
    openLog(file.string());
    status.mutable_logs(0)->add_robots("nao");
    publish();
  }
  void type(SearchView& view, int kind, const char* wanted) {
    child<QComboBox>(view, "searchKind").setCurrentIndex(kind);
    auto& field = child<QLineEdit>(view, "searchWanted");
    field.clear();
    QTest::keyClicks(&field, QLatin1String(wanted));
    QTest::keyClick(&field, Qt::Key_Return);
  }
  void finish(SearchView& view) {
    if (!QTest::qWaitFor([&] {
          tick(view);
          return !view.isSearching();
        }))
      qFatal("the search does not end");
  }

  TestFolder folder;
  std::filesystem::path file = folder / "game.mcap";
};

/// A program that sees the ball from 20 to 25 s in any log.
class SeenBall final : public logplayer::Computation {
 public:
  std::vector<std::string> streams() const override { return {"nao/percepts/ball"}; }
  robotlink::Result<std::vector<std::string>> run(const std::set<std::string>&, const Visit& visit) override {
    for (int i = 0; i < 300; ++i) {
      auto ball = std::make_shared<robotcontrol::BallModel>();
      ball->set_known(i >= 100 && i < 150);
      const auto time = at(10 + 0.1 * i);
      if (const auto done = visit(time, {{"nao/percepts/ball", time, ball}}); !done)
        return tl::unexpected(done.error());
    }
    return std::vector<std::string>{};
  }
};

}  // namespace

class SearchViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aConditionIsFoundInTheWholeLogAndAClickJumpsThere() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    log.type(*view, 0, "models/ball.position_in_robot.x > 2");
    log.finish(*view);
    auto& table = child<QTableView>(*view, "searchTable");
    QCOMPARE(table.model()->rowCount(), 3);
    QCOMPARE(child<QLabel>(*view, "searchState").text(), QStringLiteral("3 hits"));
    QCOMPARE(table.model()->index(0, SearchModel::kRobot).data().toString(), QStringLiteral("nao"));
    QCOMPARE(table.model()->index(2, SearchModel::kLength).data().toString(), QStringLiteral("to the end"));
    log.session.setRobots({"another", "nao"});
    log.session.selectRobot("another");
    const QRect row = table.visualRect(table.model()->index(1, 0));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, row.center());
    QVERIFY2(log.session.selectedRobot() == "nao", "the other views show the robot of the hit");
    QCOMPARE(log.asked().action(), robotcontrol::ControlReplay::JUMP_TO_TIME);
    QCOMPARE(log.asked().time(), at(26.7).time_since_epoch().count());
    // From the shown time on.
    log.answer(true);
    log.tick(*view);
    log.showTime(20);
    log.tick(*view);
    click(child<QToolButton>(*view, "searchNext"));
    QCOMPARE(log.asked().time(), at(26.7).time_since_epoch().count());
    log.answer(true);
    log.tick(*view);
    click(child<QToolButton>(*view, "searchPrevious"));
    QCOMPARE(log.asked().time(), at(16.7).time_since_epoch().count());
    keepPicture(*view, "search");
    const auto csv = log.folder / "hits.csv";
    QVERIFY(view->saveTo(QString::fromStdString(csv.string())));
    const auto text = robotlink::readFile(csv);
    QVERIFY(text && std::count(text->begin(), text->end(), '\n') == 4);
  }

  void theOnlyHitIsTheNextAndThePreviousOneFromEverywhere() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    log.type(*view, 1, "frame 100$");
    log.finish(*view);
    QCOMPARE(view->hits().rowCount(), 1);
    for (const double shown : {15.0, 20.0, 25.0}) {
      for (const int direction : {1, -1}) {
        log.showTime(shown);
        log.tick(*view);
        QVERIFY(view->go(direction));
        QCOMPARE(log.asked().time(), at(20).time_since_epoch().count());
        log.answer(true);
        log.tick(*view);
      }
    }
    log.type(*view, 1, "frame 10[01]$");
    log.finish(*view);
    log.showTime(25);
    log.tick(*view);
    QVERIFY(!view->go(1));
  }

  void hitsMoveWithTheOffsetOfTheirLog() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    log.type(*view, 0, "models/ball.position_in_robot.x > 2");
    log.finish(*view);
    const SearchRow before = view->hits().row(1);
    const auto moved = robotlink::fromSeconds(5);
    log.status.mutable_logs(0)->set_offset(moved.count());
    log.publish();
    log.showTime(29);
    QVERIFY(view->go(1));
    QCOMPARE(log.asked().time(), (before.from + moved).time_since_epoch().count());
    log.tick(*view);
    QVERIFY(view->hits().row(1).from == before.from + moved);
    QVERIFY(view->hits().row(1).until == *before.until + moved);
    QVERIFY(TimeMarks::of(log.logs()).hits()[1].from == before.from + moved);
  }

  void aSearchEndsWhileItsViewIsHidden() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    view->hide();
    QVERIFY(view->search(QStringLiteral("models/ball.position_in_robot.x > 2"), false));
    QTRY_VERIFY(!view->isSearching());
    QCOMPARE(view->hits().rowCount(), 3);
  }

  void textsAreFoundByARegularExpression() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    log.type(*view, 1, "FRAME 1[0-9]$");
    log.finish(*view);
    QCOMPARE(view->hits().rowCount(), 10);
    QCOMPARE(view->hits().index(3, SearchModel::kText).data().toString(), QStringLiteral("frame 13"));
    log.type(*view, 1, "no \"such\" text");
    log.finish(*view);
    QCOMPARE(view->hits().rowCount(), 0);
    log.type(*view, 1, "(");
    log.finish(*view);
    QVERIFY(child<QLabel>(*view, "searchState").text().contains(QStringLiteral("regular expression")));
  }

  void whatIsWrongWithAConditionIsSaid() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    log.type(*view, 0, "models/bal.position_in_robot.x > 2");
    log.finish(*view);
    QVERIFY(child<QLabel>(*view, "searchState").text().contains(QStringLiteral("models/ball")));
    log.type(*view, 0, "");
    QVERIFY(!view->isSearching());
    QVERIFY(!child<QLabel>(*view, "searchState").text().isEmpty());
  }

  void whatTheLogLacksIsComputedWhichIsSaid() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    log.type(*view, 0, "percepts/ball.known");
    log.finish(*view);
    QCOMPARE(view->hits().rowCount(), 0);
    QVERIFY(child<QLabel>(*view, "searchState").text().contains(QStringLiteral("no stream percepts/ball")));
    log.logs().setComputation(
        [](const auto&) { return std::unique_ptr<logplayer::Computation>(std::make_unique<SeenBall>()); });
    log.type(*view, 0, "percepts/ball.known");
    log.finish(*view);
    QCOMPARE(child<QLabel>(*view, "searchState").text(),
             QStringLiteral("1 hit\nComputed by the program: nao/percepts/ball"));
    QVERIFY(view->hits().row(0).from == at(20));
    QCOMPARE(view->hits().index(0, SearchModel::kLength).data().toString(), QStringLiteral("5.000"));
    log.type(*view, 0, "models/ball.position_in_robot.x > 2");
    log.finish(*view);
    QCOMPARE(child<QLabel>(*view, "searchState").text(), QStringLiteral("3 hits"));
  }

  void hitsAreMarkedInTheTimelineAndClicksInItsRulerMeetThem() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    auto line = log.openView<TimeLineView>({1000, 300});
    auto& viewport = child<QWidget>(*line, "timeLineViewport");
    const QColor color = colorOf(Meaning::kGood, line->palette());
    const auto pixels = [&] {
      log.tick(*line);
      return countNear(viewport.grab().toImage(), color, 0);
    };
    const int none = pixels();
    log.type(*view, 0, "models/ball.position_in_robot.x > 2");
    log.finish(*view);
    QVERIFY(pixels() > none + 100);
    keepPicture(*line, "timeline-hits");
    const auto& look = line->findChild<TimeLineCanvas*>()->look();
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, QPoint(static_cast<int>(look.scale.x(at(26.7))) + 2, 4));
    QCOMPARE(log.asked().time(), at(26.7).time_since_epoch().count());
    // They go with the view.
    view.reset();
    QCOMPARE(pixels(), none);
  }

  void aSearchIsCanceledAndAnotherOneReplacesIt() {
    SearchedLog log;
    auto view = log.openView<SearchView>();
    log.type(*view, 0, "models/ball.position_in_robot.x > 2");
    click(child<QToolButton>(*view, "searchCancel"));
    QVERIFY(!view->isSearching());
    log.type(*view, 0, "models/ball.position_in_robot.x > 2");
    log.type(*view, 0, "models/ball.position_in_robot.x > 2.9");
    log.finish(*view);
    QCOMPARE(view->hits().rowCount(), 3);
    QVERIFY(view->hits().row(0).from > at(19));
  }

  void liveRobotsAreSearchedInMemoryAndOnDisk() {
    Bench bench;
    bench.session.history().setArchive(std::make_unique<MadeUpArchive>(true));
    bench.session.store().setBytes(20'000);
    for (int i = 0; i < 600; ++i) {
      robotcontrol::BallModel ball;
      ball.mutable_position_in_robot()->set_x(0.03 * (i % 100));
      bench.push("red1/models/ball", ball, 1 + 0.1 * i);
      foxglove::Log log;
      log.set_message("frame " + std::to_string(i));
      bench.push("red1/log", log, 1 + 0.1 * i);
      if (i % 10 == 0) bench.session.tick();
    }
    auto view = bench.open<SearchView>();
    QVERIFY(bench.session.store().find("red1/models/ball")->messages.size() < 300);
    const auto find = [&](const char* wanted, bool isTexts) {
      if (const auto begun = view->search(QLatin1String(wanted), isTexts); !begun)
        qFatal("%s", begun.error().text.c_str());
      if (!QTest::qWaitFor([&] {
            bench.tick(*view);
            return !view->isSearching();
          }))
        qFatal("the search does not end");
      return view->hits().rowCount();
    };
    QCOMPARE(find("models/ball.position_in_robot.x > 1.5", false), 6);
    for (int i = 0; i < 6; ++i) {
      const double begin = 1 + 0.1 * (51 + 100 * i);
      QVERIFY(std::abs(robotlink::seconds(view->hits().row(i).from.time_since_epoch()) - begin) < 0.01);
    }
    QCOMPARE(TimeMarks::of(openLogs(bench.context)).hits().size(), std::size_t{6});
    QCOMPARE(find("frame 5[0-9]$", true), 10);
    QCOMPARE(view->hits().row(3).text, QStringLiteral("frame 53"));
    // A click shows the instant, although the robot goes on.
    auto& table = child<QTableView>(*view, "searchTable");
    const auto cell = table.visualRect(table.model()->index(3, 0)).center();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, cell);
    QCOMPARE(bench.session.history().chosen(), view->hits().row(3).from);
    child<QComboBox>(*view, "searchKind").setCurrentIndex(0);
    child<QLineEdit>(*view, "searchWanted").setText(QStringLiteral("0 < models/bal.position_in_robot.x"));
    click(child<QToolButton>(*view, "searchStart"));
    QVERIFY(!view->isSearching());
    QCOMPARE(child<QLabel>(*view, "searchState").text(),
             QStringLiteral("At character 5: there is no stream models/bal; did you mean 'models/ball'?"));
    QVERIFY(view->search(QStringLiteral("frame"), true));
    bench.session.store().clear();
    bench.tick(*view);
    QCOMPARE(view->hits().rowCount(), 0);
  }

  void withoutALogItSaysWhatToOpen() {
    LogBench bench;
    auto view = bench.openView<SearchView>();
    QVERIFY(!child<QToolButton>(*view, "searchStart").isEnabled());
    QVERIFY(!view->search(QStringLiteral("a.b > 1"), false));
    auto again = bench.openView<SearchView>();
    child<QLineEdit>(*view, "searchWanted").setText(QStringLiteral("a.b > 1"));
    child<QComboBox>(*view, "searchKind").setCurrentIndex(1);
    again->restoreState(view->saveState());
    QCOMPARE(child<QLineEdit>(*again, "searchWanted").text(), QStringLiteral("a.b > 1"));
    QCOMPARE(child<QComboBox>(*again, "searchKind").currentIndex(), 1);
  }
};

const GuiTest<SearchViewTest> kSearchViewTest;

}  // namespace widgets::test

#include "SearchViewTest.moc"
