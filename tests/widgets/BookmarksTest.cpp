// SPDX-License-Identifier: GPL-3.0-or-later
// Bookmarks as a person makes, edits, moves and removes them, on the time line and in their list, down to the
// file.
#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>

#include "foxglove/Image.pb.h"
#include "logplayer/base/LogWriter.h"
#include "robotlink/process/Link.h"
#include "tests/widgets/FieldBench.h"
#include "tests/widgets/LogBench.h"
#include "widgets/log/BookmarksView.h"
#include "widgets/timeline/TimeLineCanvas.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets::test {
namespace {

constexpr int kTicksUntilSaved = 61;

/// A bench with a real file, so that bookmarks have a place to be saved in.
class BookmarkBench : public LogBench {
 public:
  BookmarkBench() : file(std::filesystem::path(qgetenv("XDG_CONFIG_HOME").toStdString()) / "bookmarks.mcap") {
    std::filesystem::remove_all(file);
    std::filesystem::remove_all(file.string() + ".bookmarks.json");
    auto writer = logplayer::LogWriter::create(file, {});
    if (!writer) qFatal("%s", writer.error().describe().c_str());
    auto image = std::make_shared<foxglove::CompressedImage>();
    if (!(*writer)->write({{"nao/camera/image", at(10), image, "cognition", 1}}) ||
        !(*writer)->container().close())
      qFatal("no log");
    openLog(file.string());
    auto bookmarks = logplayer::Bookmarks::open(file);
    if (!bookmarks) qFatal("%s", bookmarks.error().describe().c_str());
    readings.at(file.string())->bookmarks.emplace(std::move(bookmarks));
    publish();
  }
  const std::vector<logplayer::Bookmark>& bookmarks() { return log().bookmarks->all(); }
  widgets::OpenLogs::Log& log() { return *logs().logs().front(); }
  std::vector<logplayer::Bookmark> saved() const {
    auto read = logplayer::Bookmarks::open(file);
    return read ? read->all() : std::vector<logplayer::Bookmark>{};
  }
  void passTime() {
    for (int i = 0; i < kTicksUntilSaved; ++i) logs().tick();
  }

  const std::filesystem::path file;
};

TimeLineCanvas& canvasOf(TimeLineView& view) {
  return child<TimeLineCanvas>(view, "timeLineCanvas");
}

/// The middle of a bookmark's flag.
QPoint flag(TimeLineView& view, const logplayer::Bookmark& bookmark) {
  auto& canvas = canvasOf(view);
  const auto lane = canvas.layout().lanes.front();
  return widgets::bookmarkRect(canvas.bands()[0], bookmark, canvas.look(), lane.rect,
                               QFontMetricsF(canvas.font()))
      .center()
      .toPoint();
}

void typeName(TimeLineView& view, const QString& text) {
  auto& edit = child<QLineEdit>(view, "bookmarkEdit");
  edit.selectAll();
  QTest::keyClicks(&edit, text);
  QTest::keyClick(&edit, Qt::Key_Return);
}

}  // namespace

class BookmarksTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theKeyBMarksTheMomentAndTheNameIsTypedInPlace() {
    BookmarkBench bench;
    bench.showTime(17);
    auto view = bench.openView<TimeLineView>();
    QTest::keyClick(&canvasOf(*view), Qt::Key_B, Qt::ControlModifier);
    typeName(*view, QStringLiteral("b: missed [here]"));  // all of these are keys of the player
    QCOMPARE(bench.bookmarks().size(), std::size_t{1});
    QCOMPARE(bench.bookmarks()[0].from, at(17));
    QCOMPARE(bench.bookmarks()[0].text, std::string("b: missed [here]"));
  }

  void whatIsMarkedBeforeTheBookmarksAreReadIsNotLost() {
    BookmarkBench bench;
    bench.openLog("/logs/slow.mcap", 100);
    bench.showTime(120);
    auto& slow = *bench.logs().find("/logs/slow.mcap");
    QVERIFY(bench.logs().addBookmarkAt(at(120), QStringLiteral("early bird")));
    QVERIFY(!slow.bookmarks);
    bench.readings.at(slow.path)->bookmarks.emplace(logplayer::Bookmarks::open(bench.file));
    bench.publish();
    QCOMPARE(slow.bookmarks->all().size(), std::size_t{1});
    QCOMPARE(slow.bookmarks->all()[0].text, std::string("early bird"));
    QCOMPARE(slow.bookmarks->all()[0].from, at(20));
  }

  void escapeKeepsTheOldName() {
    BookmarkBench bench;
    auto view = bench.openView<TimeLineView>();
    click(child<QToolButton>(*view, "timeLineBookmark"));
    const std::string name = bench.bookmarks()[0].text;
    auto& edit = child<QLineEdit>(*view, "bookmarkEdit");
    QTest::keyClicks(&edit, QStringLiteral("other"));
    QTest::keyClick(&edit, Qt::Key_Escape);
    QCOMPARE(bench.bookmarks()[0].text, name);
  }

  void aBookmarkIsMovedRenamedRemovedAndAllOfItUndone() {
    BookmarkBench bench;
    bench.logs().addBookmark(bench.log(), at(15), at(15), QStringLiteral("first"));
    auto view = bench.openView<TimeLineView>();
    auto& canvas = canvasOf(*view);
    const QPoint start = flag(*view, bench.bookmarks()[0]);
    drag(*canvas.viewport(), Qt::LeftButton, start, start + QPoint(120, 0));
    const double moved = robotlink::seconds(bench.bookmarks()[0].from);
    QVERIFY(moved > 16);
    bench.tick(*view);
    QTest::keyClick(&canvas, Qt::Key_F2);
    typeName(*view, QStringLiteral("second"));
    QCOMPARE(bench.bookmarks()[0].text, std::string("second"));
    bench.tick(*view);
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Delete);
    QVERIFY(bench.bookmarks().empty());
    bench.tick(*view);
    click(child<QToolButton>(*view, "timeLineUndo"));
    QCOMPARE(bench.bookmarks()[0].text, std::string("second"));
    QTest::keyClick(&canvas, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.bookmarks()[0].text, std::string("first"));
    QCOMPARE(robotlink::seconds(bench.bookmarks()[0].from), moved);
    bench.tick(*view);
    QTest::keyClick(&canvas, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.bookmarks()[0].from, at(15));
    bench.tick(*view);
    click(child<QToolButton>(*view, "timeLineRedo"));
    QCOMPARE(robotlink::seconds(bench.bookmarks()[0].from), moved);
  }

  void aClickOnABookmarkGoesThereAndADoubleClickBesideMakesOne() {
    BookmarkBench bench;
    bench.logs().addBookmark(bench.log(), at(15), at(15), QStringLiteral("first"));
    auto view = bench.openView<TimeLineView>();
    auto& viewport = *canvasOf(*view).viewport();
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, flag(*view, bench.bookmarks()[0]));
    QCOMPARE(bench.asked().time(), at(15).time_since_epoch().count());
    const int y = flag(*view, bench.bookmarks()[0]).y();
    const int x = static_cast<int>(canvasOf(*view).look().scale.x(at(35)));
    QTest::mouseDClick(&viewport, Qt::LeftButton, {}, {x, y});
    QCOMPARE(bench.bookmarks().size(), std::size_t{2});
    QVERIFY(std::abs(robotlink::seconds(bench.bookmarks()[1].from) - 35) < 0.1);
  }

  void changesAreSavedAfterAWhileAndWhenTheLogIsClosed() {
    BookmarkBench bench;
    bench.logs().addBookmark(bench.log(), at(15), at(15), QStringLiteral("first"));
    bench.logs().tick();
    QVERIFY(bench.saved().empty());
    bench.passTime();
    QCOMPARE(bench.saved().size(), std::size_t{1});
    QCOMPARE(bench.saved()[0].text, std::string("first"));
    bench.logs().addBookmark(bench.log(), at(25), at(26), QStringLiteral("second"));
    bench.status.clear_logs();
    bench.publish();
    QVERIFY(bench.logs().logs().empty());
    QCOMPARE(bench.saved().size(), std::size_t{2});
    QCOMPARE(bench.saved()[1].to, at(26));
  }

  void whatCannotBeSavedIsReportedOnce() {
    QStringList failures;
    BookmarkBench bench;
    connect(&bench.logs(), &widgets::OpenLogs::failed, this, [&](const QString& text) { failures << text; });
    bench.logs().addBookmark(bench.log(), at(15), at(15), QStringLiteral("first"));
    std::filesystem::remove(bench.file);
    std::filesystem::create_directories(bench.file);  // neither a log nor a place for one
    std::filesystem::create_directories(bench.file.string() + ".bookmarks.json/in the way");
    bench.passTime();
    bench.passTime();
    QCOMPARE(failures.size(), 1);
    std::filesystem::remove_all(bench.file);
    std::filesystem::remove_all(bench.file.string() + ".bookmarks.json");
  }

  void theListJumpsEditsAndRemoves() {
    BookmarkBench bench;
    bench.logs().addBookmark(bench.log(), at(35), at(35), QStringLiteral("late"));
    bench.logs().addBookmark(bench.log(), at(15), at(16.5), QStringLiteral("early"));
    auto view = bench.openView<BookmarksView>();
    auto& table = child<QTableView>(*view, "bookmarksTable");
    QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(table.model()->index(0, BookmarkModel::kText).data().toString(), QStringLiteral("early"));
    QCOMPARE(table.model()->index(0, BookmarkModel::kTime).data().toString(), QStringLiteral("5.000"));
    QCOMPARE(table.model()->index(0, BookmarkModel::kLength).data().toString(), QStringLiteral("1.500"));
    table.setCurrentIndex(table.model()->index(1, BookmarkModel::kTime));
    QTest::keyClick(&table, Qt::Key_Return);
    QCOMPARE(bench.asked().time(), at(35).time_since_epoch().count());
    bench.answer(true);
    bench.tick(*view);
    const QPoint text = table.visualRect(table.model()->index(0, BookmarkModel::kText)).center();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, text);
    QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, text);
    auto* edit = table.viewport()->findChild<QLineEdit*>();
    QVERIFY(edit != nullptr);
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("earlier"));
    QTest::keyClick(edit, Qt::Key_Return);
    QTRY_COMPARE(bench.bookmarks()[0].text, std::string("earlier"));
    bench.tick(*view);
    table.setFocus();
    table.setCurrentIndex(table.model()->index(0, BookmarkModel::kTime));
    bench.tick(*view);
    click(child<QToolButton>(*view, "bookmarkRemove"));
    QCOMPARE(bench.bookmarks().size(), std::size_t{1});
    click(child<QToolButton>(*view, "bookmarkUndo"));
    QCOMPARE(bench.bookmarks().size(), std::size_t{2});
    bench.showTime(20);
    bench.tick(*view);
    click(child<QToolButton>(*view, "bookmarkAdd"));
    QCOMPARE(bench.bookmarks()[1].from, at(20));
    QTest::keyClicks(&child<QLineEdit>(*view, "bookmarksSearch"), QStringLiteral("late"));
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 1);
  }

  void looksWell() {
    BookmarkBench bench;
    bench.logs().addBookmark(bench.log(), at(15), at(15), QStringLiteral("the ball is seen first"));
    bench.logs().addBookmark(bench.log(), at(20), at(27), QStringLiteral("missed while it rolls"));
    auto view = bench.openView<TimeLineView>();
    canvasOf(*view).chooseBookmark(0, bench.bookmarks()[1].id);
    keepPicture(*view, "time-line-bookmarks");
  }
};

const GuiTest<BookmarksTest> kBookmarksTest;

}  // namespace widgets::test

#include "BookmarksTest.moc"
