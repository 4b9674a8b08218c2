// SPDX-License-Identifier: GPL-3.0-or-later
// The window, and a robot on a machine with a network of its own, behind 1 Mbit/s and 200 ms of round trip,
// in real time. What happens at the robot is seen by an onlooker there, whose line is as good as can be.
// Skipped where the system does not let tests make networks.
#include <QElapsedTimer>
#include <random>

#include "app/core/remote/LinkAccess.h"
#include "colortool/table/ColorTableFile.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/foxglove/session/remote/SessionClient.h"
#include "tests/app/far/FarHall.h"
#include "tests/app/far/NarrowLine.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {
namespace {

using robotcontrol::SimulationStatus;
using robotlink::websocket::SessionClient;

constexpr char kFarImages[] = "red1/camera/image";

/// Somebody at the robot, who knows what happens there at once.
class Onlooker {
 public:
  Onlooker(const NarrowLine& line, const std::string& token) {
    auto connection = linkOptions(line.direct(), token, [](const auto&, const auto&) { return true; });
    if (!connection) qFatal("%s", connection.error().text.c_str());
    SessionClient::Options options;
    options.connection = std::move(*connection);
    const auto stay = line.atComputer();
    client_ = std::make_unique<SessionClient>(session_, std::move(options));
  }
  template <typename T>
  const T* newest(const std::string& stream) {
    client_->tick();
    session_.tick();
    return session_.store().latestAs<T>(stream, robotlink::Instant::max());
  }
  bool isStopped() {
    const auto* status = newest<SimulationStatus>("simulation");
    return status != nullptr && status->stopped_robots_size() == 1;
  }
  /// The source of the color table that the robot uses; empty: its own.
  std::string table() {
    const auto* table = newest<robotcontrol::ColorTable>("red1/tables/colors");
    return table == nullptr ? std::string() : table->source();
  }
  /// The robot's time.
  robotlink::Instant now() {
    newest<SimulationStatus>("simulation");
    return session_.store().newest();
  }

 private:
  robotlink::Session session_;
  std::unique_ptr<SessionClient> client_;
};

/// A color table that takes most of a second on this line, since there is nothing to compress in it.
bool saveNoise(const std::filesystem::path& file) {
  colortool::ColorTableFile table;
  std::mt19937 random;  // NOLINT(cert-msc51-cpp): the same table each time
  for (std::uint8_t& cell : table.cells) cell = static_cast<std::uint8_t>(random() % 8);
  return table.save(file).has_value();
}

}  // namespace

class FarNarrowGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void keysAndStopAreInTimeAndImagesAreYoung() {
    auto networks = NetworkLine::make();
    if (!networks) QSKIP(networks.error().text.c_str());
    NarrowLine line(std::move(*networks));
    FarHall hall(line, home_);
    QCOMPARE(hall.wrong, QString());
    FarDesk& desk = *hall.desk;
    Onlooker there(line, hall.robot.token());
    QTRY_VERIFY_WITH_TIMEOUT(there.newest<SimulationStatus>("simulation") != nullptr, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest<foxglove::RawImage>(kFarImages) != nullptr, kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.state().contains(QStringLiteral("images as JPEG")), kWaitMs);
    expectYoungImages(desk, there);
    for (const char* key : {"models/ball", "models/pose", "joints/states"}) expectKeyInTime(desk, key);
    for (int i = 0; i < 3; ++i) expectStopDuringATable(desk, there, line, i);
    widgets::test::keepPicture(desk.window, "far-narrow");
  }

 private:
  static void expectYoungImages(FarDesk& desk, Onlooker& there) {
    const auto age = [&] {
      return there.now() -
             desk.workbench.session().store().latest(kFarImages, robotlink::Instant::max())->time;
    };
    // What was raw has to be through.
    QTRY_VERIFY_WITH_TIMEOUT(age() < std::chrono::milliseconds(800), kWaitMs);
    robotlink::Duration oldest{0};
    const auto end = there.now() + std::chrono::seconds(8);
    QTRY_VERIFY_WITH_TIMEOUT((oldest = std::max(oldest, age()), there.now() > end), kWaitMs);
    qInfo("the oldest image: %.0f ms", robotlink::seconds(oldest) * 1e3);
    QVERIFY(oldest < std::chrono::seconds(1));
  }
  static void expectKeyInTime(FarDesk& desk, const std::string& package) {
    const std::string stream = "red1/" + package;
    QElapsedTimer watch;
    watch.start();
    desk.run("robot.key package/" + package + " always");
    const auto before = desk.count(stream);
    QTRY_VERIFY_WITH_TIMEOUT(desk.count(stream) > before, kWaitMs);
    qInfo("%s comes after %lld ms", package.c_str(), watch.elapsed());
    QVERIFY(watch.elapsed() < 1000);
    desk.run("robot.key package/" + package + " off");
  }
  void expectStopDuringATable(FarDesk& desk, Onlooker& there, const NarrowLine& line, int round) {
    const auto file = home_ / ("noise" + std::to_string(round) + ".c64");
    QVERIFY(saveNoise(file));
    const std::string before = there.table();
    const std::size_t carried = line.carried();
    desk.run("robot.color-table " + file.string());
    QTRY_VERIFY_WITH_TIMEOUT(line.carried() > carried + 20'000, kWaitMs);
    auto& stop = desk.find<QToolButton>("stopButton");
    QElapsedTimer watch;
    watch.start();
    QTest::mouseClick(&stop, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(there.isStopped(), kWaitMs);
    const qint64 taken = watch.elapsed();
    QCOMPARE(there.table(), before);
    qInfo("STOP acts after %lld ms", taken);
    QVERIFY(taken < 300);
    QTRY_VERIFY_WITH_TIMEOUT(there.table() != before, kWaitMs);
    // The desk knows it later than the robot.
    auto& engaged = desk.find<QAction>("robot.stop");
    QTRY_VERIFY_WITH_TIMEOUT(engaged.isChecked(), kWaitMs);
    QTest::mouseClick(&stop, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!there.isStopped() && !engaged.isChecked(), kWaitMs);
  }
};

const widgets::test::GuiTest<FarNarrowGuiTest> kFarNarrowGuiTest;

}  // namespace app::test

#include "FarNarrowGuiTest.moc"
