// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorFramesView.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include "logplayer/base/LogWriter.h"
#include "logplayer/file/LogFile.h"
#include "robotcontrol/Debugging.pb.h"
#include "tests/TestFolder.h"
#include "tests/game/Data.h"
#include "tests/game/View.h"
#include "tests/widgets/CameraBench.h"
#include "tests/widgets/LogBench.h"
#include "widgets/color/LogImages.h"
#include "widgets/color/quality/ColorQualityView.h"
#include "widgets/log/LogReader.h"

namespace widgets::test {
namespace {

using FrameModel = SuspiciousFrameModel;

constexpr int kWidth = 320, kHeight = 240;
constexpr char kStream[] = "red1/camera/image";
constexpr int kSearchMs = 20000;

/// Four quarters, and specks of orange, 4 pixels each, on the wall.
std::shared_ptr<const foxglove::RawImage> imageWithSpecks(int specks) {
  auto image = std::make_shared<foxglove::RawImage>(*CameraBench::image(kWidth, kHeight));
  std::string& data = *image->mutable_data();
  for (int i = 0; i < specks; ++i) {
    const int x = kWidth / 2 + 8 + 6 * (i % 20), y = kHeight / 2 + 8 + 6 * (i / 20);
    for (int row = y; row < y + 2; ++row) {
      char* pair = data.data() + 2 * (row * kWidth + x);
      pair[0] = pair[2] = static_cast<char>(140);
      pair[1] = 60;
      pair[3] = static_cast<char>(200);
    }
  }
  return image;
}

/// Frames 100 ms apart from 10 s on, each with that many specks.
void writeLog(const std::filesystem::path& file, const std::vector<int>& specks) {
  auto writer = logplayer::LogWriter::create(file, {});
  if (!writer) qFatal("%s", writer.error().describe().c_str());
  std::uint64_t number = 0;
  for (const int count : specks) {
    const auto time = at(10 + 0.1 * static_cast<double>(number++));
    auto info = std::make_shared<robotcontrol::FrameInfo>();
    info->set_number(number);
    info->set_process("platform");
    if (!(*writer)->write({{kStream, time, imageWithSpecks(count), "platform", number},
                           {"red1/frames/platform", time, info, "platform", number}}))
      qFatal("the log could not be written");
  }
  if (!(*writer)->container().close()) qFatal("the log could not be closed");
}

/// The view on a robot whose table knows orange, green and the wall.
struct ShownFrames : LogBench {
  ColorBench& bench;
  std::unique_ptr<ColorFramesView> view;
  QTableView* table = nullptr;
  std::unique_ptr<QAbstractItemModelTester> tester;

  ShownFrames() : bench(colorBench(context)) {
    context.logs = std::make_shared<OpenLogs>(session, readLogFile);
    show(imageWithSpecks(0), 0.5);
    stroke("orange", 40, 60);
    stroke("green", 240, 60);
    stroke(nullptr, 162, 238);
    view = std::make_unique<ColorFramesView>(context);
    table = &test::child<QTableView>(*view, "colorFramesTable");
    tester = std::make_unique<QAbstractItemModelTester>(
        table->model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    view->resize(720, 420);
    view->show();
    if (!QTest::qWaitForWindowExposed(view.get())) qFatal("the view is not shown");
    turn();
  }
  void show(std::shared_ptr<const foxglove::RawImage> image, double time) {
    session.push({kStream, at(time), image});
    session.tick();
    bench.setFrame(std::make_shared<ColorFrame>(std::move(image), kStream, "", at(time)));
  }
  void stroke(const char* name, double x, double y) {
    bench.setCurrentClass(name == nullptr ? 0 : bench.samples().classes.index(name));
    const colortool::ImagePoint at[] = {{x, y}};
    bench.addStroke(colortool::brushArea(kWidth, kHeight, at, 3), "brush");
    QTRY_VERIFY(bench.upToDate());
  }
  void turn() {
    session.tick();
    context.logs->tick();
    view->tick();
  }
  void openLog(const std::filesystem::path& file, double offset = 0) {
    LogBench::openLog(file.string(), offset);
    QTRY_VERIFY_WITH_TIMEOUT((turn(), logs().logs().front()->overview->stage == LogOverview::Stage::kDone),
                             kSearchMs);
  }
  void press(const char* button) {
    QTest::mouseClick(&test::child<QToolButton>(*view, button), Qt::LeftButton);
    turn();
  }
  ColorFrameFinder& finder() { return colorFrameFinder(context); }
  void waitForTheEnd() { QTRY_VERIFY_WITH_TIMEOUT((turn(), !finder().busy()), kSearchMs); }
  void search() {
    press("colorFramesSearch");
    waitForTheEnd();
  }
  QString text(int row, int column) const { return table->model()->index(row, column).data().toString(); }
  void clickRow(int row) {
    table->scrollTo(table->model()->index(row, FrameModel::kScore));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                      table->visualRect(table->model()->index(row, FrameModel::kScore)).center());
  }
  int rows() const { return table->model()->rowCount(); }
  template <typename W>
  W* part(const char* name) const {
    return &test::child<W>(*view, name);
  }
};

}  // namespace

class ColorFramesViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void someImagesSpreadOverALogAreRead() {
    const TestFolder folder;
    writeLog(folder / "game.mcap", std::vector<int>(60, 0));
    LogImages reading({folder / "game.mcap", kStream, std::chrono::seconds(100)}, "red1-2/camera/image");
    std::optional<std::vector<ColorFramePtr>> images;
    QTRY_VERIFY_WITH_TIMEOUT((images = images ? std::move(images) : reading.take()).has_value(), kSearchMs);
    QCOMPARE(images->size(), LogImages::kCount);
    QCOMPARE(images->front()->stream(), std::string("red1-2/camera/image"));
    QCOMPARE(images->front()->time(), at(110.2));
    QCOMPARE(images->back()->time(), at(115.7));
    QCOMPARE(images->front()->width(), kWidth);
  }

  void ofALogThatCannotBeReadThereAreNoImages() {
    const TestFolder folder;
    LogImages reading({folder / "missing.mcap", kStream}, kStream);
    std::optional<std::vector<ColorFramePtr>> images;
    QTRY_VERIFY_WITH_TIMEOUT((images = images ? std::move(images) : reading.take()).has_value(), kSearchMs);
    QVERIFY(images->empty());
  }

  void theQualityTriesTheTableOnTheLogOfTheImage() {
    const TestFolder folder;
    writeLog(folder / "game.mcap", std::vector<int>(30, 0));
    ShownFrames s;
    s.openLog(folder / "game.mcap");
    ColorQualityView quality(s.context);
    quality.show();
    const auto& note = test::child<QLabel>(quality, "strokesNote");
    QTRY_VERIFY_WITH_TIMEOUT(
        (quality.tick(), note.text().contains(QStringLiteral("In 12 images spread over the log"))),
        kSearchMs);
  }

  void theImagesOfALogAreListedWorstFirst() {
    const TestFolder folder;
    writeLog(folder / "game.mcap", {0, 3, 0, 40, 1, 0, 12});
    ShownFrames s;
    s.openLog(folder / "game.mcap");
    s.search();
    QCOMPARE(s.rows(), 4);
    const char* const times[] = {"0.300 s", "0.600 s", "0.100 s", "0.400 s"};
    const int pixels[] = {160, 48, 12, 4};
    for (int row = 0; row < 4; ++row) {
      QCOMPARE(s.text(row, FrameModel::kTime), QLatin1String(times[row]));
      QCOMPARE(s.text(row, FrameModel::kSpecks).toInt(), pixels[row]);
      QCOMPARE(s.text(row, FrameModel::kClasses), QStringLiteral("orange %1").arg(pixels[row]));
      QVERIFY(
          !s.table->model()->index(row, FrameModel::kTime).data(Qt::DecorationRole).value<QImage>().isNull());
    }
    QCOMPARE(s.part<QLabel>("colorFramesState")->text(),
             QStringLiteral("game.mcap, red1/camera/image: 7 images, suspicious: 4"));
    QVERIFY(!s.part<QProgressBar>("colorFramesProgress")->isVisible());
  }

  void aClickAndEnterJumpThere() {
    const TestFolder folder;
    writeLog(folder / "game.mcap", {0, 3, 0, 40, 1});
    ShownFrames s;
    s.openLog(folder / "game.mcap", 100);
    s.search();
    s.clickRow(0);
    QCOMPARE(s.asked().time(), at(110.3).time_since_epoch().count());
    s.answer(true);
    s.turn();
    s.table->setFocus();
    QTest::keyClick(s.table, Qt::Key_Down);
    QTest::keyClick(s.table, Qt::Key_Return);
    QCOMPARE(s.asked().time(), at(110.1).time_since_epoch().count());
  }

  void whatARobotSentIsSearchedWithoutALog() {
    ShownFrames s;
    for (const int specks : {0, 5, 20}) s.show(imageWithSpecks(specks), 1 + 0.1 * specks);
    QVERIFY(!s.part<QToolButton>("colorFramesLive")->isVisible());
    s.search();
    QCOMPARE(s.rows(), 2);
    QCOMPARE(s.text(0, FrameModel::kTime), QStringLiteral("3.000 s"));
    s.clickRow(1);
    QVERIFY(!s.session.timeline().live());
    QCOMPARE(s.session.timeline().shown(), at(1.5));
    QVERIFY(s.requests.empty());
    s.press("colorFramesLive");
    QVERIFY(s.session.timeline().live());
    QVERIFY(!s.part<QToolButton>("colorFramesLive")->isVisible());
  }

  void aSearchIsCanceled() {
    ShownFrames s;
    const auto image = imageWithSpecks(100);
    for (int i = 0; i < 2500; ++i) s.session.push({kStream, at(1 + 0.01 * i), image});
    s.session.tick();
    s.press("colorFramesSearch");
    QTRY_VERIFY((s.turn(), s.rows() > 0));  // they come while it goes
    QVERIFY(s.part<QProgressBar>("colorFramesProgress")->isVisible());
    s.press("colorFramesCancel");
    s.waitForTheEnd();
    const auto& progress = s.finder().progress();
    QVERIFY(progress.canceled);
    QVERIFY2(progress.seen < progress.total, qPrintable(QString::number(progress.seen)));
    QVERIFY(s.part<QLabel>("colorFramesState")->text().endsWith(QStringLiteral("canceled")));
    QVERIFY(!s.part<QToolButton>("colorFramesCancel")->isEnabled());
    // A search may go on when its window closes.
    s.press("colorFramesSearch");
  }

  void anotherTableMakesTheListStale() {
    ShownFrames s;
    s.show(imageWithSpecks(5), 1);
    auto* stale = s.part<QLabel>("colorFramesStale");
    s.search();
    QCOMPARE(s.rows(), 1);
    QVERIFY(!stale->isVisible());
    s.bench.undoStack().undo();
    s.bench.undoStack().undo();
    QTRY_VERIFY((s.turn(), s.bench.upToDate()));
    QVERIFY(stale->isVisible());
    s.bench.undoStack().redo();
    s.bench.undoStack().redo();
    QTRY_VERIFY(s.bench.upToDate());
    s.turn();
    QVERIFY2(!stale->isVisible(), "it is the same table again");
    // A stroke on a speck: they are green from now on.
    s.stroke("green", 240, 20);
    s.stroke(nullptr, 60, 60);
    s.stroke(nullptr, 20, 20);
    s.turn();
    QVERIFY(stale->isVisible());
    s.press("colorFramesSearch");
    s.waitForTheEnd();
    QVERIFY(!stale->isVisible());
  }

  void theClassesThatAreLookedAtCanBeChosen() {
    ShownFrames s;
    s.show(imageWithSpecks(5), 1);
    auto* menu = s.part<QMenu>("colorFramesClassMenu");
    Q_EMIT menu->aboutToShow();
    QStringList looked;
    QAction* orange = nullptr;
    for (QAction* action : menu->actions()) {
      if (action->isChecked()) looked << action->text();
      if (action->text() == QStringLiteral("orange")) orange = action;
    }
    QVERIFY(looked.contains(QStringLiteral("orange")) && !looked.contains(QStringLiteral("green")));
    orange->trigger();
    s.search();
    QCOMPARE(s.rows(), 0);
    const QJsonObject state = s.view->saveState();
    s.finder().setChoices({});
    s.search();
    QCOMPARE(s.rows(), 1);
    s.view->restoreState(state);
    QVERIFY(!s.finder().looksAt(s.bench.samples().classes.index("orange")));
  }

  void whatCannotBeSearchedIsSaid() {
    const TestFolder folder;
    ShownFrames s;
    auto* problem = s.part<QLabel>("colorFramesProblem");
    s.bench.setFrame(nullptr);
    s.press("colorFramesSearch");
    QVERIFY2(problem->isVisible() && problem->text().contains(QStringLiteral("no images to search")),
             qPrintable(problem->text()));
    writeLog(folder / "game.mcap", {3});
    s.openLog(folder / "game.mcap");
    s.search();
    QVERIFY(!problem->isVisible());
    QCOMPARE(s.rows(), 1);
    std::filesystem::remove(folder / "game.mcap");
    s.search();
    QVERIFY2(problem->isVisible() && problem->text().contains(QStringLiteral("game.mcap")),
             qPrintable(problem->text()));
  }

  void onlyTheWorstAreKept() {
    FrameModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    std::vector<SuspiciousFrame> frames;
    for (int i = 0; i < 700; ++i) {
      SuspiciousFrame frame;
      frame.found.score = (i * 271) % 700;
      frames.push_back(std::move(frame));
      if (frames.size() == 70) model.add(std::exchange(frames, {}));
    }
    QCOMPARE(model.rowCount(), static_cast<int>(FrameSearch::kMaxKept));
    for (int row = 0; row < model.rowCount(); ++row) QVERIFY(model.row(row).found.score >= 200);
  }

  void aWholeLogIsSearched_data() {
    QTest::addColumn<QString>("source");
    for (const std::string& source : game::kSources)
      QTest::newRow(source.c_str()) << QString::fromStdString(source);
  }
  void aWholeLogIsSearched() {
    QFETCH(QString, source);
    const bool real = source == QStringLiteral("real");
    const auto file = game::dataOf(source.toStdString()) / "logs/bhuman2009.log";
    if (!std::filesystem::exists(file)) QSKIP("the real log is not here: ../shared/data/logs/bhuman2009.log");
    ShownFrames s;
    auto log = logplayer::LogFile::open(file, {});
    QVERIFY(log);
    logplayer::LogFile::Cursor cursor(*log, {"nao/camera/image"});
    const auto first = cursor.next();
    auto image = std::dynamic_pointer_cast<const foxglove::RawImage>(first->value);
    QVERIFY(image);
    s.bench.setFrame(std::make_shared<ColorFrame>(image, "nao/camera/image", "", first->time));
    s.bench.setDocument({});
    if (real) {
      for (const auto& [name, x, y] : {std::tuple{"orange", 168.0, 144.0},
                                       {"orange", 169.0, 151.0},
                                       {"green", 90.0, 101.0},
                                       {"green", 180.0, 206.0},
                                       {"blue", 201.0, 40.0},
                                       {"white", 120.0, 153.0},
                                       {"white", 220.0, 164.0}})
        s.stroke(name, x, y);
      s.stroke(nullptr, 140, 25);
    } else {
      // The field is taken for orange, and the ball is not known.
      for (const auto& [name, label] :
           {std::pair{"orange", game::View::kGreen}, {"blue", game::View::kBlue}}) {
        for (const auto& place : game::placesInside(game::View::at(0).labels, label, 4, 2))
          s.stroke(name, place.x, place.y);
      }
    }
    s.openLog(file);
    s.search();
    const std::uint64_t count = real ? 160 : game::View::kCount;
    QCOMPARE(s.finder().progress().seen, count);
    QVERIFY2(s.rows() > static_cast<int>(count / 8), qPrintable(QString::number(s.rows())));
    for (int row = 1; row < s.rows(); ++row)
      QVERIFY(s.text(row, FrameModel::kScore).toInt() <= s.text(row - 1, FrameModel::kScore).toInt());
    s.clickRow(0);
    if (real) keepPicture(*s.view, "color-frames-view");
  }
};

const GuiTest<ColorFramesViewTest> kColorFramesViewTest;

}  // namespace widgets::test

#include "ColorFramesViewTest.moc"
