// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/ViewExport.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include "robotcontrol/Requests.pb.h"
#include "tests/TestFolder.h"
#include "tests/widgets/FieldBench.h"
#include "tests/widgets/LogBench.h"
#include "widgets/export/ExportBar.h"
#include "widgets/export/ExportDialog.h"
#include "widgets/image/ImageCanvas.h"
#include "widgets/image/ImageStreamView.h"
#include "widgets/log/OpenLogs.h"

namespace widgets::test {
namespace {

using robotlink::Instant;
constexpr robotlink::YCbCr kBright{200, 128, 128}, kDim{60, 128, 128};

Instant exportTime(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

/// A robot whose camera was dim from 1 s on and bright from 2 s on, an image view, and an export of it.
struct Filmed {
  FieldBench world;
  TestFolder folder;
  ImageStreamView view{world.context};
  ViewExport exporting{world.context};
  ExportBar bar{exporting, nullptr};

  Filmed() {
    for (int frame = 0; frame <= 50; ++frame) {
      world.pushImage("red1/camera/image", {32, 24}, frame < 25 ? kDim : kBright);
      world.advance(40);
    }
    view.resize(400, 300);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the view is not shown");
    view.tick();
  }
  ExportPlan plan(ExportPlan::Kind kind, const char* name) const {
    ExportPlan plan;
    plan.kind = kind;
    plan.target = folder.path() / name;
    plan.name = "image";
    plan.from = exportTime(1.5);
    plan.to = exportTime(2.5);
    plan.rate = 10;
    plan.size = {160, 120};
    return plan;
  }
  std::string start(const ExportPlan& plan) {
    const auto done = exporting.start(QStringLiteral("image"), view, plan);
    return done ? "" : done.error().text;
  }
  /// Ticks until it has ended; returns how.
  ViewExport::Outcome finish() {
    std::optional<ViewExport::Outcome> outcome;
    const auto ended = [&] {
      world.session.tick();
      exporting.tick();
      outcome = exporting.takeOutcome();
      return outcome.has_value();
    };
    if (!QTest::qWaitFor(ended, 20'000)) qFatal("the export never ended");
    return *outcome;
  }
  QImage image(int number) const {
    const auto file = folder.path() / "images" /
                      QStringLiteral("image-%1.png").arg(number, 5, 10, QLatin1Char('0')).toStdString();
    return QImage(QString::fromStdString(file.string()));
  }
};

int brightnessOf(const QImage& image) {
  return qGray(image.pixel(image.width() / 2, image.height() / 2));
}

}  // namespace

class ViewExportTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void imagesShowTheViewAtEachInstant() {
    Filmed f;
    QCOMPARE(f.start(f.plan(ExportPlan::Kind::kImages, "images")), std::string());
    QVERIFY(f.exporting.isBusy());
    QVERIFY(*f.exporting.working());
    const auto outcome = f.finish();
    QVERIFY2(outcome.isDone, qPrintable(outcome.text));
    QVERIFY2(outcome.text.contains(QStringLiteral("11 pictures")), qPrintable(outcome.text));
    QCOMPARE(QDir(QString::fromStdString((f.folder.path() / "images").string())).count(), 11U + 2U);
    QCOMPARE(f.image(1).size(), QSize(160, 120));
    QVERIFY(brightnessOf(f.image(5)) < 100);
    QVERIFY(brightnessOf(f.image(6)) > 150);
    QVERIFY(brightnessOf(f.image(11)) > 150);
    QVERIFY2(f.world.session.timeline().live(), "what was shown before is shown again");
    QVERIFY(!*f.exporting.working());
  }

  void aVideoIsWrittenInItsSize() {
    Filmed f;
    for (const char* name : {"made.avi", "made.mp4"}) {
      QCOMPARE(f.start(f.plan(ExportPlan::Kind::kVideo, name)), std::string());
      const auto outcome = f.finish();
      QVERIFY2(outcome.isDone, qPrintable(outcome.text));
      QVERIFY(std::filesystem::file_size(f.folder.path() / name) > 500);
    }
  }

  void thePictureIsOfTheViewAsItIsZoomed() {
    Filmed f;
    auto& canvas = child<ImageCanvas>(f.view, "imageCanvas");
    f.world.pushImage("red1/camera/image", {32, 24}, kDim, {4, 4}, kBright);
    f.world.advance(40);
    f.view.tick();
    canvas.setViewport({false, 20, {4.5, 4.5}});
    auto plan = f.plan(ExportPlan::Kind::kImages, "images");
    plan.from = plan.to = f.world.session.timeline().newest();
    QCOMPARE(f.start(plan), std::string());
    QVERIFY(f.finish().isDone);
    QVERIFY2(brightnessOf(f.image(1)) > 150, "the pixel in the middle is as large as in the view");
    QVERIFY(qGray(f.image(1).pixel(10, 10)) < 100);
  }

  void theBarShowsProgressAndCancels() {
    Filmed f;
    f.bar.resize(700, 30);
    f.bar.tick();
    QVERIFY(!f.bar.isVisible());
    auto plan = f.plan(ExportPlan::Kind::kVideo, "made.avi");
    plan.rate = 200;
    QCOMPARE(f.start(plan), std::string());
    f.exporting.tick();
    f.bar.tick();
    QVERIFY(f.bar.isVisible());
    QVERIFY(child<QLabel>(f.bar, "exportText").text().contains(QStringLiteral("of 201 pictures")));
    QTest::mouseClick(&child<QToolButton>(f.bar, "exportCancel"), Qt::LeftButton);
    f.bar.tick();
    QVERIFY(!f.exporting.isBusy());
    QVERIFY(child<QLabel>(f.bar, "exportText").text().startsWith(QStringLiteral("Canceled")));
    QVERIFY(std::filesystem::is_empty(f.folder.path()));
    QVERIFY2(f.world.session.timeline().live(), "views follow the robot again");
    QVERIFY2(!f.exporting.working(), "a script must not go on as if it was written");
    QTest::mouseClick(&child<QToolButton>(f.bar, "exportDismiss"), Qt::LeftButton);
    QVERIFY(!f.bar.isVisible());
  }

  void aFullDiskEndsItWithNothingLeft() {
    Filmed f;
    int looks = 0;
    f.exporting.setFreeSpace(
        [&looks](const auto&) -> std::uintmax_t { return ++looks < 2 ? 1U << 30U : 0U; });
    auto plan = f.plan(ExportPlan::Kind::kVideo, "made.avi");
    plan.rate = 50;
    QCOMPARE(f.start(plan), std::string());
    const auto outcome = f.finish();
    QVERIFY(!outcome.isDone);
    QVERIFY2(outcome.text.contains(QStringLiteral("the disk is full")), qPrintable(outcome.text));
    QVERIFY(outcome.target.isEmpty());
    QVERIFY(std::filesystem::is_empty(f.folder.path()));
  }

  void whatCannotWorkIsSaidBefore() {
    Filmed f;
    auto plan = f.plan(ExportPlan::Kind::kVideo, "made.mkv");
    QVERIFY(f.start(plan).find("ends in .mp4 (H.264) or .avi") != std::string::npos);
    plan = f.plan(ExportPlan::Kind::kVideo, "none/made.avi");
    QVERIFY(f.start(plan).find("there is no folder") != std::string::npos);
    plan = f.plan(ExportPlan::Kind::kVideo, "made.avi");
    plan.rate = 0;
    QVERIFY(f.start(plan).find("rate") != std::string::npos);
    plan.rate = 25;
    plan.size = {4, 4};
    QVERIFY(f.start(plan).find("size") != std::string::npos);
    plan = f.plan(ExportPlan::Kind::kImages, "images");
    f.folder.write("images/image-00007.png", "old");
    QVERIFY(f.start(plan).find("earlier export") != std::string::npos);
    plan.to = exportTime(1);
    QVERIFY(f.start(plan).find("end must not be before") != std::string::npos);
  }

  void anotherExportHasToWait() {
    Filmed f;
    QCOMPARE(f.start(f.plan(ExportPlan::Kind::kImages, "images")), std::string());
    QVERIFY(f.start(f.plan(ExportPlan::Kind::kVideo, "made.avi")).find("under way") != std::string::npos);
    f.exporting.cancel();
  }

  void timesAreReadAsTheTimelineShowsThem() {
    Filmed f;
    auto& replay = openLogs(f.world.context).replay();
    auto& session = f.world.session;
    QCOMPARE(*instantOf("2.5", session, replay), exportTime(2.5));
    QCOMPARE(*instantOf("-1", session, replay), session.timeline().newest() - std::chrono::seconds(1));
    QCOMPARE(*instantOf("start", session, replay), exportTime(1));
    QCOMPARE(*instantOf("end", session, replay), session.timeline().newest());
    replay.setRange(exportTime(2), exportTime(1.4));
    QCOMPARE(*instantOf("start", session, replay), exportTime(1.4));
    QCOMPARE(*instantOf("end", session, replay), exportTime(2));
    QVERIFY(instantOf("90", session, replay).error().text.find("is not there: it is 1.000 to") !=
            std::string::npos);
    QVERIFY(!instantOf("soon", session, replay));
    QCOMPARE(*sizeOf("640x480", {}), QSize(640, 480));
    QCOMPARE(*sizeOf("", QSize(3, 4)), QSize(3, 4));
    QVERIFY(!sizeOf("640", {}));
  }

  void aLogIsSteppedFromInstantToInstant() {
    Filmed f;
    f.world.requests.clear();
    auto status = std::make_shared<robotcontrol::ReplayStatus>();
    status->add_logs()->set_path("a.mcap");
    status->set_begin(exportTime(1).time_since_epoch().count());
    status->set_end(exportTime(3).time_since_epoch().count());
    status->set_time(exportTime(2.9).time_since_epoch().count());
    f.world.push("replay", status);
    f.world.advance();
    openLogs(f.world.context).tick();
    QVERIFY(openLogs(f.world.context).replay().open());
    QCOMPARE(f.start(f.plan(ExportPlan::Kind::kImages, "images")), std::string());
    const auto outcome = f.finish();
    QVERIFY2(outcome.isDone, qPrintable(outcome.text));
    std::vector<double> times;
    for (const auto& request : f.world.requests) {
      if (request.control_replay().action() == robotcontrol::ControlReplay::ADVANCE_TO_TIME)
        times.push_back(static_cast<double>(request.control_replay().time()) / 1e9);
    }
    QCOMPARE(times.size(), std::size_t{11});
    QCOMPARE(times.front(), 1.5);
    QCOMPARE(times.back(), 2.5);
    QCOMPARE(f.world.requests.back().control_replay().action(), robotcontrol::ControlReplay::JUMP_TO_TIME);
    QCOMPARE(f.world.requests.back().control_replay().time(), exportTime(2.9).time_since_epoch().count());
  }

  void theDialogProposesTheRangeAndWhatWasChosenBefore() {
    Filmed f;
    auto& replay = openLogs(f.world.context).replay();
    replay.setRange(exportTime(1.5), exportTime(2));
    const QJsonObject before{{QStringLiteral("kind"), 2}, {QStringLiteral("rate"), 5}};
    ExportDialog dialog({{QStringLiteral("image#1"), QStringLiteral("Image"), {320, 200}},
                         {QStringLiteral("field#2"), QStringLiteral("Field"), {640, 400}}},
                        QStringLiteral("field#2"), f.world.session, replay, before, nullptr);
    dialog.show();
    QCOMPARE(child<QComboBox>(dialog, "exportView").currentText(), QStringLiteral("Field"));
    QCOMPARE(child<QDoubleSpinBox>(dialog, "exportFrom").value(), 1.5);
    QCOMPARE(child<QDoubleSpinBox>(dialog, "exportUntil").value(), 2.0);
    QCOMPARE(child<QSpinBox>(dialog, "exportWidth").value(), 640);
    QVERIFY(child<QLabel>(dialog, "exportSummary").text().startsWith(QStringLiteral("3 pictures of 0.50 s")));
    child<QComboBox>(dialog, "exportKind").setCurrentIndex(1);
    QVERIFY(child<QLineEdit>(dialog, "exportTarget").text().endsWith(QStringLiteral("field-2.avi")));
    QSignalSpy wanted(&dialog, &ExportDialog::exportWanted);
    QTest::mouseClick(&child<QPushButton>(dialog, "exportOk"), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    const auto answer = dialog.answer();
    QVERIFY(answer.isVideo);
    QCOMPARE(answer.view, std::string("field#2"));
    QCOMPARE(answer.from, std::string("1.500"));
    QCOMPARE(answer.size, std::string("640x400"));
    dialog.setProblem(QStringLiteral("The disk is full."));
    keepPicture(dialog, "export-dialog");
    child<QDoubleSpinBox>(dialog, "exportUntil").setValue(1);
    QVERIFY(!child<QPushButton>(dialog, "exportOk").isEnabled());
  }
};

const GuiTest<ViewExportTest> kViewExportTest;

}  // namespace widgets::test

#include "ViewExportTest.moc"
