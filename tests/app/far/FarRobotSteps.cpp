// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/far/FarRobotSteps.h"

#include <QLabel>
#include <algorithm>

#include "colortool/table/ColorTableFile.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "tests/app/far/FarHall.h"
#include "tests/logplayer/RecordedMessages.h"
#include "widgets/console/CommandLog.h"
#include "widgets/field/FieldCanvas.h"
#include "widgets/image/ImageCanvas.h"

namespace app::test {
namespace {

using foxglove::RawImage;
using robotcontrol::DriveState;
using robotcontrol::SimulationStatus;

constexpr char kClassImages[] = "red1/images/segmentation/classes";
constexpr char kEdges[] = "red1/drawings/image/ball-percept/edge";
constexpr char kCamera[] = "red1/camera/image";
/// Simulated time of a step, s.
constexpr double kStep = 0.008;

/// Whether an image has different pixels (2) or not (1); 0 without an image. It is asked again and again, so
/// it stops at the first difference.
std::size_t colorsOf(const RawImage* image) {
  if (image == nullptr || image->data().size() < 3) return 0;
  const std::string& pixels = image->data();
  return std::equal(pixels.begin() + 3, pixels.end(), pixels.begin()) ? 1 : 2;
}

/// Steps a paused simulation one by one, so that everything that it publishes is seen.
bool step(FarDesk& desk, int steps) {
  for (int i = 1; i <= steps; ++i) {
    desk.run("simulation.step");
    const bool done = comes([&] {
      const auto* status = desk.newest<SimulationStatus>("simulation");
      return status != nullptr && status->time() > (i - 0.5) * kStep;
    });
    if (!done) return false;
  }
  return true;
}

/// What is known of a robot and its world, and how views show it.
struct Seen {
  /// The newest message of each stream that the robot's program computed or the world published.
  std::map<std::string, std::string> messages;
  QImage image, field;

  explicit Seen(FarDesk& desk)
      : image(desk.find<widgets::ImageCanvas>("imageCanvas").rendered()),
        field(desk.find<widgets::FieldCanvas>("fieldCanvas").rendered()) {
    for (const char* prefix :
         {"red1/camera/", "red1/drawings/", "red1/images/", "red1/models/", "red1/percepts/", "transforms"}) {
      for (const auto* stream : desk.workbench.session().store().streams(prefix))
        if (!stream->messages.empty() && stream->messages.back().value)
          messages[stream->path] = stream->messages.back().value->SerializeAsString();
    }
  }
  /// What of this is missing in the other one, or differs there.
  QString differences(const Seen& other) const {
    QStringList names;
    for (const auto& [path, bytes] : messages)
      if (const auto found = other.messages.find(path);
          found == other.messages.end() || found->second != bytes)
        names << QString::fromStdString(path);
    if (image != other.image) names << QStringLiteral("picture of the image");
    if (field != other.field) names << QStringLiteral("picture of the field");
    return names.join(QStringLiteral(", "));
  }
};

/// Switches on what is compared, and shows it at the same size everywhere.
bool showAll(FarDesk& desk) {
  if (!comes([&] { return desk.newest<robotcontrol::KeyTable>("red1/tables/keys") != nullptr; }))
    return false;
  for (const char* key : {"segmentation/classes", "segmentation/regions", "ball-percept/disc",
                          "landmark-percepts/boxes", "self-localisation/pose"})
    desk.run("robot.key " + std::string(key) + " always");
  desk.show("image");
  desk.show("field");
  desk.find<widgets::ImageCanvas>("imageCanvas").setFixedSize(480, 300);
  desk.find<widgets::FieldCanvas>("fieldCanvas").setFixedSize(480, 340);
  return true;
}

/// Describes the robot's program for the message of a failure: where it runs, refused requests, the state of
/// the line, and all that the robot has printed.
QString programOf(FarHall& hall) {
  FarDesk& desk = *hall.desk;
  const auto* status = desk.newest<robotcontrol::HostingStatus>("red1/hosting");
  QStringList lines{status == nullptr ? QStringLiteral("no status of the program")
                                      : QString::fromStdString(status->ShortDebugString())};
  for (const auto& entry : widgets::commandLog(desk.window.context()).entries()) lines << entry.text;
  lines << desk.state() << QString::fromStdString(hall.robot.notes());
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

void FarRobotSteps::keysAndSolutionsAreSwitched() {
  const auto line = makeLine();
  if (!line) return;
  FarHall hall(*line, home_);
  QCOMPARE(hall.wrong, QString());
  FarDesk& desk = *hall.desk;
  QCOMPARE(desk.robot(), QStringLiteral("red1"));
  QTRY_VERIFY_WITH_TIMEOUT(desk.newest<RawImage>(kCamera) != nullptr, kWaitMs);
  QCOMPARE(desk.count(kClassImages), 0U);
  QVERIFY(desk.choose("ball-percept", "circle-fit"));  // this solution draws edges
  QVERIFY(desk.switchKey(QStringLiteral("segmentation"), QStringLiteral("classes")));
  QVERIFY(desk.switchKey(QStringLiteral("ball-percept"), QStringLiteral("edge")));
  QTRY_VERIFY_WITH_TIMEOUT(desk.count(kClassImages) > 2 && desk.count(kEdges) > 2, kWaitMs);
  QVERIFY(colorsOf(desk.newest<RawImage>(kClassImages)) > 1);
  desk.show("image");
  QTRY_VERIFY_WITH_TIMEOUT(!desk.find<widgets::ImageCanvas>("imageCanvas").picture().pixels.isNull(),
                           kWaitMs);
  widgets::test::keepPicture(desk.window, "far-robot");
  // Off again, nothing more comes, while images go on.
  QVERIFY(desk.switchKey(QStringLiteral("segmentation"), QStringLiteral("classes")));
  const auto hasEnded = [&] {
    const auto classes = desk.count(kClassImages), images = desk.count(kCamera);
    return comes([&] { return desk.count(kCamera) > images + 10; }) && desk.count(kClassImages) == classes;
  };
  bool ended = false;
  for (int looks = 0; looks < 10 && !ended; ++looks) ended = hasEnded();
  QVERIFY2(ended, "what was on its way has come long ago");
}

void FarRobotSteps::itIsDrivenStandsWhenItIsReleasedAndObeysStop() {
  const auto line = makeLine();
  if (!line) return;
  FarHall hall(*line, home_);
  QCOMPARE(hall.wrong, QString());
  FarDesk& desk = *hall.desk;
  QVERIFY(desk.takeOver());
  QTRY_VERIFY_WITH_TIMEOUT(desk.stands(), kWaitMs);
  auto& steering = desk.find<QToolButton>("statusSteering");
  QTRY_VERIFY_WITH_TIMEOUT(steering.text().startsWith(QStringLiteral("You steer red1")), kWaitMs);
  desk.hold(Qt::Key_W);
  QTRY_VERIFY_WITH_TIMEOUT(desk.walks(), kWaitMs);
  QVERIFY(steering.text().startsWith(QStringLiteral("You steer red1")));
  widgets::test::keepPicture(desk.window, "far-robot-driven");
  desk.release(Qt::Key_W);
  QTRY_VERIFY_WITH_TIMEOUT(desk.stands(), kWaitMs);
  desk.hold(Qt::Key_S);
  QTRY_VERIFY_WITH_TIMEOUT(desk.walks(), kWaitMs);
  QTest::mouseClick(&desk.find<QToolButton>("stopButton"), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(desk.stands(), kWaitMs);  // though the key is still held
  QCOMPARE(desk.newest<SimulationStatus>("simulation")->stopped_robots_size(), 1);
  desk.release(Qt::Key_S);
}

void FarRobotSteps::itPlaysWithAColorTableThatIsSentToIt() {
  const auto line = makeLine();
  if (!line) return;
  FarHall hall(*line, home_);
  QCOMPARE(hall.wrong, QString());
  FarDesk& desk = *hall.desk;
  desk.run("robot.key segmentation/classes always");
  desk.run("robot.key package/percepts/regions always");
  QTRY_VERIFY_WITH_TIMEOUT(colorsOf(desk.newest<RawImage>(kClassImages)) > 1, kWaitMs);
  // Everything is orange.
  colortool::ColorTableFile table;
  std::fill(table.cells.begin(), table.cells.end(), std::uint8_t{1});
  const auto file = home_ / "orange.c64";
  QVERIFY(table.save(file).has_value());
  desk.run("robot.color-table " + file.string());
  QTRY_COMPARE_WITH_TIMEOUT(colorsOf(desk.newest<RawImage>(kClassImages)), std::size_t{1}, kWaitMs);
  const auto onlyOrange = [&] {
    const auto* found = desk.newest<robotcontrol::ColorRegions>("red1/percepts/regions");
    if (found == nullptr || found->regions_size() == 0) return false;
    return std::ranges::all_of(found->regions(), [&](const auto& region) {
      return found->class_names(static_cast<int>(region.color_class())) == "orange";
    });
  };
  QTRY_VERIFY_WITH_TIMEOUT(onlyOrange(), kWaitMs);
  desk.run("robot.no-color-table");
  QTRY_VERIFY_WITH_TIMEOUT(colorsOf(desk.newest<RawImage>(kClassImages)) > 1 && !onlyOrange(), kWaitMs);
}

void FarRobotSteps::itsProgramMovesToAProcessOfItsOwnAndIsStartedAgain() {
  const auto line = makeLine();
  if (!line) return;
  FarHall hall(*line, home_);
  QCOMPARE(hall.wrong, QString());
  FarDesk& desk = *hall.desk;
  const auto hosting = [&] { return desk.newest<robotcontrol::HostingStatus>("red1/hosting"); };
  QVERIFY2(comes([&] { return hosting() != nullptr; }), qPrintable(programOf(hall)));
  desk.show("processes");
  QVERIFY2(comes([&] { return desk.find<QToolButton>("hostingOwn").isVisible(); }),
           qPrintable(programOf(hall)));
  QVERIFY2(!hosting()->own_process(), qPrintable(programOf(hall)));
  click(desk.find<QToolButton>("hostingOwn"));
  QVERIFY2(comes([&] { return hosting() != nullptr && hosting()->own_process() && hosting()->pid() != 0; }),
           qPrintable(programOf(hall)));
  const auto before = hosting()->pid();
  click(desk.find<QToolButton>("hostingStartAgain"));
  QVERIFY2(comes([&] { return hosting() != nullptr && hosting()->pid() != 0 && hosting()->pid() != before; }),
           qPrintable(programOf(hall)));
  QVERIFY2(hosting()->state() == robotcontrol::HostingStatus::RUNNING, qPrintable(programOf(hall)));
}

void FarRobotSteps::theLineIsLostWhileItIsDrivenAndFoundByItself() {
  const auto line = makeLine();
  if (!line) return;
  FarHall hall(*line, home_);
  QCOMPARE(hall.wrong, QString());
  FarDesk& desk = *hall.desk;
  QVERIFY(desk.switchKey(QStringLiteral("segmentation"), QStringLiteral("classes")));
  QTRY_VERIFY_WITH_TIMEOUT(desk.count(kClassImages) > 0, kWaitMs);
  QVERIFY(desk.takeOver());
  desk.hold(Qt::Key_W);
  QTRY_VERIFY_WITH_TIMEOUT(desk.walks(), kWaitMs);
  line->unplug(true);
  QTRY_VERIFY_WITH_TIMEOUT(!desk.line().isConnected, kWaitMs);
  QTRY_VERIFY_WITH_TIMEOUT(desk.robot().startsWith(QStringLiteral("red1 (")), kWaitMs);
  QVERIFY(desk.find<QToolButton>("motionTakeOver").isChecked());  // the history stays
  QTRY_VERIFY_WITH_TIMEOUT(!desk.find<QToolButton>("statusSteering").isVisible(), kWaitMs);
  QVERIFY(desk.find<QLabel>("motionState").text().contains(QStringLiteral("is lost")));
  QTRY_COMPARE_WITH_TIMEOUT(desk.find<QLabel>("statusState").text(), QStringLiteral("not connected"),
                            kWaitMs);
  widgets::test::keepPicture(desk.window, "far-robot-lost");
  desk.release(Qt::Key_W);
  const std::uint64_t before = desk.count(kClassImages);
  QElapsedTimer watch;
  watch.start();
  line->unplug(false);
  QTRY_VERIFY_WITH_TIMEOUT(desk.line().isConnected, kWaitMs);
  QTRY_VERIFY_WITH_TIMEOUT(desk.count(kClassImages) > before, kWaitMs);
  qInfo("found again after %lld ms", watch.elapsed());
  QCOMPARE(desk.robot(), QStringLiteral("red1"));
  QTRY_COMPARE_WITH_TIMEOUT(desk.find<QLabel>("statusState").text(), QStringLiteral("running"), kWaitMs);
  for (const auto& gap : desk.line().gaps) QVERIFY(gap.to.has_value());
  QTRY_VERIFY_WITH_TIMEOUT(desk.stands(), kWaitMs);
  // And it can be driven on.
  desk.hold(Qt::Key_W);
  QTRY_VERIFY_WITH_TIMEOUT(desk.walks(), kWaitMs);
  desk.release(Qt::Key_W);
}

void FarRobotSteps::whatComesOverTheLineIsRecorded() {
  const auto line = makeLine();
  if (!line) return;
  const TestFolder folder;
  FarHall hall(*line, home_);
  QCOMPARE(hall.wrong, QString());
  FarDesk& desk = *hall.desk;
  desk.run("recording.folder " + folder.path().string());
  QTRY_VERIFY_WITH_TIMEOUT(desk.newest<robotcontrol::KeyTable>("red1/tables/keys") != nullptr, kWaitMs);
  auto& button = desk.find<QToolButton>("recordButton");
  QTest::mouseClick(&button, Qt::LeftButton, {}, {10, button.height() / 2});
  const auto begun = desk.count("red1/joints/states");
  QTRY_VERIFY_WITH_TIMEOUT(desk.count("red1/joints/states") > begun + 20, kWaitMs);
  // The line is lost meanwhile, and found again: the recording goes on.
  line->unplug(true);
  QTRY_VERIFY_WITH_TIMEOUT(!desk.line().isConnected, kWaitMs);
  line->unplug(false);
  const auto before = desk.count("red1/joints/states");
  QTRY_VERIFY_WITH_TIMEOUT(desk.count("red1/joints/states") > before + 20, kWaitMs);
  desk.run("recording.stop");
  // What the user has switched on goes on; what was only recorded does not.
  const auto images = desk.count(kCamera);
  QTRY_VERIFY_WITH_TIMEOUT(desk.count(kCamera) > images + 10, kWaitMs);
  const auto recorded = desk.count("red1/joints/states");
  QTRY_VERIFY_WITH_TIMEOUT(desk.count(kCamera) > images + 20, kWaitMs);
  QCOMPARE(desk.count("red1/joints/states"), recorded);
  desk.workbench.recording().recorder().finish();
  QCOMPARE(folder.files().size(), std::size_t{1});
  const auto file = folder / folder.files().front();
  const auto log = logplayer::tests::readLog(file);
  QVERIFY2(log.complete, log.error.c_str());
  for (const char* path : {kCamera, "red1/joints/states", "red1/tables/keys", "red1/program", "transforms"})
    QVERIFY2(log.count(path) > 0, path);
  QVERIFY(log.count(kCamera) > 2);
  // It opens like every log, and the program runs on it.
  desk.run("remote.disconnect " + hall.robot.url());
  auto opening = app::openingOf({{file.string()}, {}});
  QVERIFY(opening.has_value());
  desk.workbench.open(std::move(*opening));
  QTRY_VERIFY_WITH_TIMEOUT(desk.workbench.loaded() != nullptr && desk.workbench.loaded()->isLogged(),
                           kWaitMs);
  QTRY_VERIFY_WITH_TIMEOUT(desk.newest<RawImage>(kCamera) != nullptr, kWaitMs);
}

void FarRobotSteps::itsPicturesAreThoseOfAHostedRobot() {
  constexpr int kSteps = 30;
  const auto line = makeLine();
  if (!line) return;
  std::optional<Seen> hosted;
  {
    FarDesk desk(home_ / "hosted");
    RunOptions options = defaultSimulation();
    options.world.seed = FarHall::kSeed;
    desk.workbench.open(SimulationFeed::opening(options));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(showAll(desk) && step(desk, kSteps));
    desk.window.tick();
    hosted.emplace(desk);
  }
  QVERIFY(hosted->messages.contains(kCamera) && hosted->messages.contains(kClassImages));
  FarHall hall(*line, home_);
  QCOMPARE(hall.wrong, QString());
  FarDesk& desk = *hall.desk;
  QVERIFY(showAll(desk));
  desk.run("simulation.pause");
  QTRY_VERIFY_WITH_TIMEOUT(desk.newest<SimulationStatus>("simulation") != nullptr &&
                               !desk.newest<SimulationStatus>("simulation")->running(),
                           kWaitMs);
  desk.run("simulation.reset");
  // A reset forgets what came before.
  QTRY_VERIFY_WITH_TIMEOUT(desk.newest<SimulationStatus>("simulation") != nullptr &&
                               desk.newest<SimulationStatus>("simulation")->time() == 0.0,
                           kWaitMs);
  QVERIFY(step(desk, kSteps));
  QTRY_COMPARE_WITH_TIMEOUT(hosted->differences(Seen(desk)), QString(), kWaitMs);
  widgets::test::keepPicture(hosted->image, "far-image");
  widgets::test::keepPicture(hosted->field, "far-field");
}

void FarRobotSteps::aPioneerIsDrivenStoppedLostAndFound() {
  const auto line = makeLine();
  if (!line) return;
  const FarProgram wheels(line->wheels(), home_ / "wheels",
                          {"sim", ROBOTCONTROL_SOURCE_DIR "/resources/scenes/pioneer.sdf", "--arcos", "0",
                           "--bind", line->wheels().address});
  const std::string address = wheels.printed(" listens at ");
  QVERIFY(!address.empty());
  FarRobot robot(*line, home_ / "robot", {"run", "--platform", address});
  QVERIFY2(!robot.url().empty(), robot.notes().c_str());
  qputenv("XDG_STATE_HOME", QByteArray::fromStdString((home_ / "state").string()));
  FarDesk desk(home_ / "desk");
  QCOMPARE(desk.meet(robot), QString());
  QCOMPARE(desk.robot(), QStringLiteral("p3at1"));
  const auto state = [&] { return desk.newest<DriveState>("p3at1/drive/state"); };
  const auto speed = [&] { return state() == nullptr ? 0.0 : state()->velocity().x(); };
  const auto drives = [&](bool forward) { return forward ? speed() > 0.05 : speed() < -0.05; };
  const auto stands = [&] { return state() != nullptr && std::abs(speed()) < 0.01; };
  QVERIFY(desk.takeOver());
  QTRY_VERIFY_WITH_TIMEOUT(state() != nullptr, kWaitMs);
  QTRY_COMPARE_WITH_TIMEOUT(desk.find<QLabel>("statusSpeed").text(), QStringLiteral("real time"), kWaitMs);
  QTRY_COMPARE_WITH_TIMEOUT(desk.find<QLabel>("statusState").text(), QStringLiteral("running"), kWaitMs);
  click(desk.find<QToolButton>("motionMotors"));
  QTRY_VERIFY_WITH_TIMEOUT(state()->motors_on(), kWaitMs);
  const double begun = state()->odometry().x();
  desk.hold(Qt::Key_W);
  QTRY_VERIFY_WITH_TIMEOUT(drives(true) && state()->odometry().x() > begun + 0.05, kWaitMs);
  widgets::test::keepPicture(desk.window, "far-pioneer");
  desk.release(Qt::Key_W);
  QTRY_VERIFY_WITH_TIMEOUT(stands(), kWaitMs);
  desk.hold(Qt::Key_S);
  QTRY_VERIFY_WITH_TIMEOUT(drives(false), kWaitMs);
  auto& stop = desk.find<QToolButton>("stopButton");
  QTest::mouseClick(&stop, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(stands() && desk.find<QAction>("robot.stop").isChecked(), kWaitMs);
  QTest::mouseClick(&stop, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(drives(false), kWaitMs);
  line->unplug(true);
  QTRY_VERIFY_WITH_TIMEOUT(!desk.line().isConnected, kWaitMs);
  desk.release(Qt::Key_S);
  line->unplug(false);
  QTRY_VERIFY_WITH_TIMEOUT(desk.line().isConnected, kWaitMs);
  const auto before = desk.count("p3at1/drive/state");
  QTRY_VERIFY_WITH_TIMEOUT(desk.count("p3at1/drive/state") > before && stands(), kWaitMs);
  qunsetenv("XDG_STATE_HOME");
}

}  // namespace app::test
