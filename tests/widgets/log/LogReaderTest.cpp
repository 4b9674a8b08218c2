// SPDX-License-Identifier: GPL-3.0-or-later
// Real files, read in threads as views read them, and what the time line does with them: cut, exported,
// repaired.
#include <QAction>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <fstream>

#include "foxglove/Robot.pb.h"
#include "logplayer/base/LogWriter.h"
#include "logplayer/file/LogFile.h"
#include "tests/app/ShortLog.h"
#include "tests/game/Data.h"
#include "tests/game/Log.h"
#include "tests/widgets/LogBench.h"
#include "widgets/log/LogBars.h"
#include "widgets/log/LogJobs.h"
#include "widgets/log/LogReader.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets::test {
namespace {

constexpr int kWaitMs = 20000;

std::filesystem::path home() {
  return qgetenv("XDG_CONFIG_HOME").toStdString();
}

/// 300 frames from 10 to 40 s, each with a text; every hundredth is a warning.
std::filesystem::path writeLog(const char* name) {
  const auto file = home() / name;
  std::filesystem::remove(file);
  auto writer = logplayer::LogWriter::create(file, {});
  if (!writer) qFatal("%s", writer.error().describe().c_str());
  for (int i = 0; i < 300; ++i) {
    auto text = std::make_shared<foxglove::Log>();
    text->set_level(i % 100 == 99 ? foxglove::Log::WARNING : foxglove::Log::INFO);
    text->set_message("text " + std::to_string(i));
    auto info = std::make_shared<robotcontrol::FrameInfo>();
    info->set_number(static_cast<std::uint64_t>(i) + 1);
    info->set_process("cognition");
    const auto time = at(10 + i * 0.1);
    const auto number = static_cast<std::uint64_t>(i) + 1;
    if (!(*writer)->write({{"nao/log", time, text, "cognition", number},
                           {"nao/frames/cognition", time, info, "cognition", number}})) {
      qFatal("the log could not be written");
    }
  }
  if (!(*writer)->container().close()) qFatal("the log could not be closed");
  return file;
}

std::uint64_t countOf(const std::filesystem::path& file, const char* stream) {
  auto log = logplayer::LogFile::open(file, {});
  if (!log) return 0;
  for (const auto& known : (*log)->streams()) {
    if (known.path == stream) return known.count;
  }
  return 0;
}

/// A bench whose logs are read from their files.
class ReadBench : public LogBench {
 public:
  ReadBench() { context.logs = std::make_shared<widgets::OpenLogs>(session, widgets::readLogFile); }
  void waitUntilRead(TimeLineView& view) {
    QTRY_VERIFY_WITH_TIMEOUT(
        (tick(view), logs().logs().front()->overview->stage == LogOverview::Stage::kDone), kWaitMs);
  }
  /// Types a name into the dialog that is open, and waits until the job that this starts has ended.
  void answer(TimeLineView& view, const char* dialogName, const std::filesystem::path& file) {
    auto& dialog = child<QFileDialog>(view, dialogName);
    auto& name = child<QLineEdit>(dialog, "fileNameEdit");
    name.setText(QString::fromStdString(file.string()));
    QTest::keyClick(&name, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT((tick(view), !child<QProgressBar>(view, "logJobProgress").isVisible()), kWaitMs);
  }
};

}  // namespace

class LogReaderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void readsAWholeLogStepByStep_data() {
    QTest::addColumn<QString>("source");
    for (const std::string& source : game::kSources)
      QTest::newRow(source.c_str()) << QString::fromStdString(source);
  }
  void readsAWholeLogStepByStep() {
    QFETCH(QString, source);
    const auto file = game::dataOf(source.toStdString()) / "logs/bhuman2009.log";
    if (!std::filesystem::exists(file)) QSKIP("the real log is not here: ../shared/data/logs/bhuman2009.log");
    const std::uint64_t count = source == QStringLiteral("real") ? 160 : game::View::kCount;
    LogReader reader(file);
    QTRY_VERIFY_WITH_TIMEOUT(reader.overview()->stage == LogOverview::Stage::kDone, kWaitMs);
    const auto overview = reader.overview();
    QVERIFY(overview->converted);
    QCOMPARE(overview->imageStreams(), std::vector<std::string>{"nao/camera/image"});
    const auto* images = overview->find("nao/camera/image");
    QCOMPARE(images->count, count);
    QCOMPARE(images->density.count(), count);
    QVERIFY(images->bytes > 10'000 * count);
    reader.wantThumbnails("nao/camera/image", {overview->end, overview->begin, images->first}, 60);
    std::vector<widgets::LogThumbnail> thumbnails;
    QTRY_VERIFY_WITH_TIMEOUT(
        (std::ranges::move(reader.takeThumbnails(), std::back_inserter(thumbnails)), thumbnails.size() == 3),
        kWaitMs);
    QCOMPARE(thumbnails[0].time, overview->end);  // in the order in which they were wanted
    QCOMPARE(thumbnails[0].image.size(), QSize(80, 60));
    QCOMPARE(thumbnails[2].image.size(), QSize(80, 60));
    QVERIFY(reader.takeBookmarks().has_value());
  }

  void aFileThatIsNoneSaysSo() {
    const auto file = home() / "none.mcap";
    { std::ofstream(file) << "this is no log"; }
    LogReader reader(file);
    QTRY_VERIFY_WITH_TIMEOUT(!reader.overview()->failure.isEmpty(), kWaitMs);
    QVERIFY(reader.overview()->failure.contains(QStringLiteral("none.mcap")));
  }

  void aReaderCanBeLeftAtAnyTime() {
    const auto file = writeLog("left.mcap");
    for (int i = 0; i < 20; ++i) {
      LogReader reader(file);
      if (i % 2 == 0)
        QTRY_VERIFY_WITH_TIMEOUT(reader.overview()->stage != LogOverview::Stage::kOpening, kWaitMs);
    }
  }

  void aRangeIsCutIntoANewLogWhichCanBeOpened() {
    const auto file = writeLog("game.mcap");
    ReadBench bench;
    std::string opened;
    bench.commands.add({"log.open",
                        "",
                        {{"file", robotlink::CommandTable::Type::kText, ""}},
                        [&](const auto& values) -> robotlink::Result<void> {
                          opened = std::get<std::string>(values[0]);
                          return {};
                        }});
    bench.openLog(file.string());
    bench.setRange(15, 20);
    auto view = bench.openView<TimeLineView>();
    bench.waitUntilRead(*view);
    QCOMPARE(bench.logs().logs().front()->overview->said.size(), std::size_t{3});
    const auto cut = home() / "cut.mcap";
    click(child<QToolButton>(*view, "rangeCut"));
    bench.answer(*view, "cutDialog", cut);
    QVERIFY2(child<QLabel>(*view, "logJobText").text().contains(QStringLiteral("cut.mcap: ")),
             qPrintable(child<QLabel>(*view, "logJobText").text()));
    QCOMPARE(countOf(cut, "nao/log"), 51U);
    click(child<QToolButton>(*view, "logJobOpen"));
    QCOMPARE(opened, cut.string());
    QVERIFY(!child<QWidget>(*view, "logJobBar").isVisible());
  }

  void someStreamsAreWrittenIntoANewLog() {
    const auto file = writeLog("game.mcap");
    ReadBench bench;
    bench.openLog(file.string());
    auto view = bench.openView<TimeLineView>();
    bench.waitUntilRead(*view);
    view->findChild<QAction*>(QStringLiteral("exportStreams"))->trigger();
    auto& dialog = child<QDialog>(*view, "cutStreamsDialog");
    auto& patterns = child<QLineEdit>(dialog, "cutPatterns");
    auto& list = child<QListWidget>(dialog, "cutStreamList");
    auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    const auto* text = list.findItems(QStringLiteral("nao/log"), Qt::MatchExactly).value(0);
    QVERIFY(text != nullptr && text->checkState() == Qt::Checked);
    patterns.setText(QStringLiteral("-*"));
    QVERIFY2(!ok->isEnabled(), "nothing would be written");
    patterns.setText(QStringLiteral("*,-*/log"));
    QCOMPARE(text->checkState(), Qt::Unchecked);
    const auto tick = [&list](Qt::CheckState state) {
      list.findItems(QStringLiteral("nao/log"), Qt::MatchExactly).value(0)->setCheckState(state);
    };
    tick(Qt::Checked);
    QCOMPARE(patterns.text(), QString());
    // What was typed stays, as where the streams of recordings are chosen.
    patterns.setText(QStringLiteral("nao/frames/*"));
    tick(Qt::Checked);
    QCOMPARE(patterns.text(), QStringLiteral("nao/frames/*,nao/log"));
    tick(Qt::Unchecked);
    QCOMPARE(patterns.text(), QStringLiteral("nao/frames/*"));
    click(*ok);
    const auto some = home() / "some.mcap";
    bench.answer(*view, "cutDialog", some);
    QCOMPARE(countOf(some, "nao/frames/cognition"), 300U);
    QCOMPARE(countOf(some, "nao/log"), 0U);
  }

  void textsAndTablesAreExported() {
    const auto file = writeLog("game.mcap");
    ReadBench bench;
    bench.openLog(file.string());
    bench.setRange(15, 20);
    auto view = bench.openView<TimeLineView>();
    bench.waitUntilRead(*view);
    view->findChild<QAction*>(QStringLiteral("exportTexts"))->trigger();
    bench.answer(*view, "exportTextsDialog", home() / "game.txt");
    QFile texts(QString::fromStdString((home() / "game.txt").string()));
    QVERIFY(texts.open(QIODevice::ReadOnly));
    QCOMPARE(texts.readAll().count('\n'), 51);
    bench.logs().replay().setSteppedStream("nao/frames/cognition");
    view->findChild<QAction*>(QStringLiteral("exportTable"))->trigger();
    bench.answer(*view, "exportTableDialog", home() / "game.csv");
    QVERIFY(std::filesystem::file_size(home() / "game.csv") > 500);
    QVERIFY(child<QLabel>(*view, "logJobText").text().contains(QStringLiteral("game.csv")));
  }

  void imagesAreExportedIntoAFolder() {
    const auto file = home() / "images.mcap";
    QCOMPARE(app::test::ShortLog::write(file), std::string());
    ReadBench bench;
    bench.openLog(file.string());
    bench.setRange(14, 15);  // the second half of it
    auto view = bench.openView<TimeLineView>();
    bench.waitUntilRead(*view);
    QTRY_VERIFY_WITH_TIMEOUT((bench.tick(*view), bench.logs().current()->imageStream == "red1/camera/image"),
                             kWaitMs);
    const auto folder = home() / "pictures";
    std::filesystem::create_directories(folder);
    view->findChild<QAction*>(QStringLiteral("exportImages"))->trigger();
    bench.answer(*view, "exportImagesDialog", folder);
    const QStringList pictures = QDir(QString::fromStdString(folder.string()))
                                     .entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Name);
    QCOMPARE(pictures.size(), 13);  // every second frame from the 25th on
    QCOMPARE(QImage(QDir(QString::fromStdString(folder.string())).filePath(pictures.front())).size(),
             QSize(176, 144));
  }

  void aDamagedLogIsRepairedIntoANewOne() {
    const auto whole = writeLog("whole.mcap");
    const auto file = home() / "damaged.mcap";
    std::filesystem::copy_file(whole, file, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 100);  // its end is gone
    ReadBench bench;
    bench.openLog(file.string());
    auto view = bench.openView<TimeLineView>();
    bench.waitUntilRead(*view);
    bench.tick(*view);
    QVERIFY(child<QWidget>(*view, "logDamageBar").isVisible());
    const auto repaired = home() / "repaired.mcap";
    std::filesystem::remove(repaired);
    click(child<QToolButton>(*view, "logRepair"));
    bench.answer(*view, "repairDialog", repaired);
    QVERIFY2(child<QToolButton>(*view, "logJobOpen").isVisible(),
             qPrintable(child<QLabel>(*view, "logJobText").text()));
    QVERIFY(countOf(repaired, "nao/log") > 0);
  }

  void anOldFileStaysUntilARepairIsComplete() {
    const auto to = home() / "kept.mcap";
    std::ofstream(to) << "an older log";
    const auto repair = widgets::repairLog((home() / "no-such.mcap").string(), to);
    QVERIFY(!repair([](double) { return true; }).done);
    std::ifstream kept(to);
    QCOMPARE(QString::fromStdString({std::istreambuf_iterator<char>(kept), {}}),
             QStringLiteral("an older log"));
  }

  void logsThatAreJoinedNameTheRobotsThatGotAnotherName() {
    const auto one = writeLog("one.mcap"), two = writeLog("two.mcap");
    const auto outcome = widgets::cutLogs({{one.string(), {}}, {two.string(), {}}}, {},
                                          home() / "both.mcap")([](double) { return true; });
    QVERIFY(outcome.done);
    QVERIFY2(outcome.text.contains(QStringLiteral("two.mcap: nao is called nao-2")),
             qPrintable(outcome.text));
  }

  void aJobIsCanceled() {
    widgets::LogJobBar bar;
    bar.show();
    bar.start(QStringLiteral("Long work"), [](const widgets::LogJob::Progress& progress) {
      while (progress(0.5)) std::this_thread::yield();
      return widgets::LogJob::Outcome{};
    });
    bar.tick();
    QVERIFY(child<QProgressBar>(bar, "logJobProgress").isVisible());
    click(child<QToolButton>(bar, "logJobCancel"));
    QTRY_VERIFY_WITH_TIMEOUT((bar.tick(), !bar.busy()), kWaitMs);
    QVERIFY(child<QLabel>(bar, "logJobText").text().contains(QStringLiteral("canceled")));
    click(child<QToolButton>(bar, "logJobDismiss"));
    QVERIFY(!bar.isVisible());
  }
};

const GuiTest<LogReaderTest> kLogReaderTest;

}  // namespace widgets::test

#include "LogReaderTest.moc"
