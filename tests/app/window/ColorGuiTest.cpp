// SPDX-License-Identifier: GPL-3.0-or-later
// Making a color table as a person does: strokes with the mouse in a log and on the simulated robot,
// a better segmentation, undo, redo, and a robot that finds what it did not know.
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <fstream>

#include "foxglove/Image.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/game/Data.h"
#include "tests/game/View.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/image/ColorCanvas.h"
#include "widgets/image/ImagePixels.h"

namespace app::test {
namespace {

using widgets::ColorBench;
using widgets::ColorCanvas;

/// A person at the color image view.
class Painter {
 public:
  explicit Painter(Desk& desk)
      : view_(desk.find<QWidget>("colorImageView")),
        left_(desk.find<ColorCanvas>("colorLeft")),
        right_(desk.find<ColorCanvas>("colorRight")),
        bench_(*desk.window.context().colors) {}

  ColorBench& bench() { return bench_; }
  const QImage& image() const { return left_.layers().picture; }
  const QImage& segmented() const { return right_.layers().picture; }
  void settle() { QTRY_VERIFY_WITH_TIMEOUT(bench_.upToDate(), kWaitMs); }

  /// A key of a digit, and a drag over a few pixels.
  void stroke(Qt::Key classKey, QPoint from, QPoint to) {
    left_.setFocus();
    QTest::keyClick(&left_, classKey);
    QTest::mousePress(&left_, Qt::LeftButton, {}, at(from));
    for (const QPoint& point : {(from + to) / 2, to}) {
      QMouseEvent move(QEvent::MouseMove, at(point), left_.mapToGlobal(at(point)), Qt::NoButton,
                       Qt::LeftButton, {});
      QApplication::sendEvent(&left_, &move);
    }
    QTest::mouseRelease(&left_, Qt::LeftButton, {}, at(to));
    settle();
  }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    left_.setFocus();
    QTest::keyClick(&left_, key, modifiers);
  }
  void click(const char* button) {
    QTest::mouseClick(view_.findChild<QToolButton*>(QLatin1String(button)), Qt::LeftButton);
  }
  QColor colorOf(const char* name) {
    const auto& classes = bench_.samples().classes;
    const robotlink::Rgb color = classes.shownColor(classes.index(name));
    return {color.r, color.g, color.b};
  }
  QPoint at(QPoint pixel) const { return left_.toWidget(QPointF(pixel) + QPointF(0.5, 0.5)).toPoint(); }

 private:
  QWidget& view_;
  ColorCanvas &left_, &right_;
  ColorBench& bench_;
};

/// Which share of the pixels with a label is shown in a color; `none` without any. Labels and image may
/// differ in size.
double share(const QImage& segmented, const QImage& labels, int label, const QColor& color, double none) {
  int all = 0, right = 0;
  for (int y = 0; y < segmented.height(); ++y) {
    for (int x = 0; x < segmented.width(); ++x) {
      const int known = labels.constScanLine(y * labels.height() /
                                             segmented.height())[x * labels.width() / segmented.width()];
      if (known != label) continue;
      ++all;
      right += segmented.pixelColor(x, y) == color ? 1 : 0;
    }
  }
  return all == 0 ? none : static_cast<double>(right) / all;
}

/// Which colors of an image are not segmented as its labels say; empty if all are.
QString wrongColors(Painter& painter, const QImage& labels) {
  QStringList wrong;
  const struct {
    int label;
    const char* name;
    double least;
  } expected[] = {{1, "orange", 0.85}, {5, "green", 0.95}, {4, "white", 0.75}};
  for (const auto& [label, name, least] : expected) {
    const double found = share(painter.segmented(), labels, label, painter.colorOf(name), 1);
    if (found < least) wrong << QStringLiteral("%1: %2").arg(QLatin1String(name)).arg(found);
  }
  const double falseBall = share(painter.segmented(), labels, 0, painter.colorOf("orange"), 0);
  if (falseBall > 0.01) wrong << QStringLiteral("false orange: %1").arg(falseBall);
  return wrong.join(QStringLiteral(", "));
}

/// Pixels of the violet ball.
std::vector<QPoint> violet(const QImage& image) {
  std::vector<QPoint> pixels;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor color = image.pixelColor(x, y);
      if (color.red() > color.green() + 35 && color.blue() > color.green() + 45) pixels.emplace_back(x, y);
    }
  }
  return pixels;
}

QPoint middle(const std::vector<QPoint>& pixels) {
  QPoint sum;
  for (const QPoint& pixel : pixels) sum += pixel;
  return pixels.empty() ? sum : sum / static_cast<int>(pixels.size());
}

/// A drag with the key of a class.
struct Drag {
  Qt::Key key;
  QPoint from, to;
};

/// Three in the first image of a log for each: ball, field, goal, lines, and what is none of them. The keys
/// are those of the classes of 2009, which fit the field of the log.
std::vector<Drag> dragsFor(const std::string& source) {
  if (source == "real") {
    return {{Qt::Key_1, {166, 142}, {172, 146}}, {Qt::Key_1, {165, 150}, {173, 152}},
            {Qt::Key_1, {170, 138}, {172, 139}}, {Qt::Key_5, {60, 100}, {120, 102}},
            {Qt::Key_5, {150, 205}, {210, 207}}, {Qt::Key_5, {280, 100}, {310, 110}},
            {Qt::Key_3, {201, 20}, {201, 60}},   {Qt::Key_3, {230, 4}, {300, 5}},
            {Qt::Key_3, {201, 10}, {201, 30}},   {Qt::Key_4, {100, 151}, {140, 155}},
            {Qt::Key_4, {40, 145}, {60, 147}},   {Qt::Key_4, {200, 162}, {240, 166}},
            {Qt::Key_0, {120, 20}, {160, 30}},   {Qt::Key_0, {30, 20}, {40, 60}},
            {Qt::Key_0, {220, 40}, {225, 55}}};
  }
  std::vector<Drag> drags;
  using game::View;
  for (const auto& [key, label] : {std::pair{Qt::Key_1, View::kOrange},
                                   {Qt::Key_5, View::kGreen},
                                   {Qt::Key_3, View::kBlue},
                                   {Qt::Key_4, View::kWhite},
                                   {Qt::Key_0, std::uint8_t{0}}}) {
    for (const auto& place : game::placesInside(View::at(0).labels, label, 3, 3))
      drags.push_back({key, {place.x - 1, place.y}, {place.x + 1, place.y}});
  }
  return drags;
}

}  // namespace

class ColorGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aFewStrokesInALogSegmentItsOtherImages_data() {
    QTest::addColumn<QString>("source");
    for (const std::string& source : game::kSources)
      QTest::newRow(source.c_str()) << QString::fromStdString(source);
  }
  void aFewStrokesInALogSegmentItsOtherImages() {
    QFETCH(QString, source);
    const bool real = source == QStringLiteral("real");
    const std::filesystem::path data = game::dataOf(source.toStdString());
    if (!std::filesystem::exists(data)) QSKIP("there is no ../shared/data with the real log");
    Desk desk(home_);
    desk.window.showPerspective(QStringLiteral("Colour"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(desk.workbench.commands().runLine("log.open " + (data / "logs/bhuman2009.log").string()));
    Painter painter(desk);
    QTRY_VERIFY_WITH_TIMEOUT(
        painter.bench().frame() && painter.bench().frame()->stream() == "nao/camera/image", kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(painter.image().width() == 320, kWaitMs);

    const std::vector<Drag> drags = dragsFor(source.toStdString());
    for (int i = 0; i < 3; ++i) painter.key(Qt::Key_BracketLeft);  // as thin as the lines
    for (const Drag& drag : drags) painter.stroke(drag.key, drag.from, drag.to);
    QCOMPARE(painter.bench().samples().strokes.size(), drags.size());
    // The program that runs on the log uses it from now on.
    painter.click("colorSend");
    auto& sent = desk.find<QLabel>("colorSent");
    QTRY_VERIFY2_WITH_TIMEOUT(sent.text().startsWith(QStringLiteral("✓ nao uses it")),
                              qPrintable(sent.text()), kWaitMs);

    for (const auto& [image, steps] :
         {std::pair{real ? "032" : "005", real ? 32 : 5}, {real ? "066" : "011", real ? 34 : 6}}) {
      const ColorBench& bench = painter.bench();
      const auto before = bench.frame();
      QVERIFY(
          desk.workbench.commands().runLine("log.step-message nao/camera/image " + std::to_string(steps)));
      QTRY_VERIFY_WITH_TIMEOUT(bench.frame() && bench.frame() != before, kWaitMs);
      painter.settle();
      const QImage labels(
          QString::fromStdString((data / "colour/bhuman2009/labels" / image).string() + ".png"));
      QCOMPARE(labels.format(), QImage::Format_Grayscale8);
      // A log that jumps may show another image on its way.
      QTRY_COMPARE_WITH_TIMEOUT((painter.settle(), wrongColors(painter, labels)), QString(), kWaitMs);
      widgets::test::keepPicture(desk.window, image);
    }
  }

  void undoAndRedoAreSeenInTheSegmentedImage() {
    Desk desk(home_);
    desk.window.showPerspective(QStringLiteral("Colour"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    Painter painter(desk);
    desk.click("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT(!painter.image().isNull(), kWaitMs);
    painter.key(Qt::Key_H);
    painter.settle();
    const QPoint grass(painter.image().width() / 2, painter.image().height() - 12);
    painter.stroke(Qt::Key_5, grass, grass + QPoint(20, 0));
    QCOMPARE(painter.segmented().pixelColor(grass), painter.colorOf("green"));
    painter.key(Qt::Key_Z, Qt::ControlModifier);
    painter.settle();
    QCOMPARE(painter.segmented().pixelColor(grass), QColor(Qt::black));
    painter.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    painter.settle();
    QCOMPARE(painter.segmented().pixelColor(grass), painter.colorOf("green"));
  }

  void theSimulatedRobotFindsABallOfAColorThatItDidNotKnow() {
    Desk desk(home_);
    desk.window.showPerspective(QStringLiteral("Colour"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(desk.workbench.commands().runLine("simulation.open " + violetScene()));
    QTRY_VERIFY_WITH_TIMEOUT((desk.window.tick(), !desk.workbench.loading()), kWaitMs);
    Painter painter(desk);
    // A start that is pressed before the new scene has come is that of the old one.
    QTRY_VERIFY_WITH_TIMEOUT((desk.window.tick(), desk.loaded()) && desk.status()->time() == 0, kWaitMs);
    // Stepped, so that the robot, which looks for a ball of another color, is the same on every machine.
    if (desk.status()->running()) desk.click("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT((desk.window.tick(), !desk.status()->running()), kWaitMs);
    const auto ballIsInTheImage = [&] { return violet(painter.image()).size() > 60; };
    QVERIFY(stepUntil(desk, ballIsInTheImage));
    painter.key(Qt::Key_H);  // keep this image
    wantBallPercepts(desk);
    QVERIFY(stepUntil(desk, [&] { return ballPercept(desk) != nullptr; }));
    QVERIFY2(!ballPercept(desk)->seen(), "to the table of the field's colors nothing is violet");

    const std::vector<QPoint> ball = violet(painter.image());
    const QPoint center = middle(ball);
    painter.stroke(Qt::Key_1, center - QPoint(2, 0), center + QPoint(2, 0));
    painter.stroke(Qt::Key_1, center + QPoint(0, 2), center + QPoint(1, 3));
    const int below = painter.image().height() - 8;
    painter.stroke(Qt::Key_5, {10, below}, {40, below});
    painter.stroke(Qt::Key_5, {painter.image().width() - 40, below}, {painter.image().width() - 10, below});
    painter.stroke(Qt::Key_0, {10, 10}, {painter.image().width() - 10, 10});  // what is beyond the walls
    painter.stroke(Qt::Key_0, {20, 30}, {50, 40});
    QCOMPARE(painter.segmented().pixelColor(center), painter.colorOf("orange"));
    QCOMPARE(painter.segmented().pixelColor(30, 20), QColor(Qt::black));

    painter.click("colorSend");
    auto& sent = desk.find<QLabel>("colorSent");
    QTRY_VERIFY2_WITH_TIMEOUT(sent.text().startsWith(QStringLiteral("✓ red1 uses it")),
                              qPrintable(sent.text()), kWaitMs);
    painter.click("colorFreeze");
    QVERIFY(stepUntil(desk, [&] { return seesBall(desk); }));
    widgets::test::keepPicture(desk.window, "violet-ball");
  }

 private:
  /// The shipped field with a ball that the field's description has no color for.
  std::string violetScene() {
    const auto read = [](const char* file) {
      QFile from(QStringLiteral(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/") + QLatin1String(file));
      if (!from.open(QIODevice::ReadOnly)) qFatal("cannot read %s", file);
      return from.readAll();
    };
    QByteArray model = read("models/ball/model.sdf");
    model = model.mid(model.indexOf("<model "), model.indexOf("</model>") + 8 - model.indexOf("<model "));
    model.replace("<robotcontrol:color>orange</robotcontrol:color>",
                  "<material><diffuse>0.62 0.12 0.85 1</diffuse></material>");
    model.replace("<model name=\"ball\">", "<model name=\"ball\"><pose>0 0 0.0421 0 0 0</pose>");
    QByteArray scene = read("field2002.sdf");
    const int at = scene.indexOf("<uri>model://ball</uri>");
    const int begin = scene.lastIndexOf("<include>", at), end = scene.indexOf("</include>", at) + 10;
    scene.replace(begin, end - begin, model);
    std::filesystem::create_directories(home_);
    const auto file = home_ / "violet.sdf";
    std::ofstream(file) << scene.toStdString();
    return file.string();
  }
  /// Steps a paused simulation by 80 ms at a time until a condition holds; returns false if it does not
  /// within 20 s of the robot's time.
  bool stepUntil(Desk& desk, const std::function<bool()>& condition) {
    constexpr int kSteps = 10, kTimes = 250;
    for (int i = 0; i < kTimes; ++i) {
      if (condition()) return true;
      const double before = desk.status()->time();
      for (int step = 0; step < kSteps; ++step) {
        if (!desk.workbench.commands().runLine("simulation.step")) return false;
      }
      const double after = before + kSteps * 0.008 - 1e-6;
      if (!comes([&] { return desk.window.tick(), desk.status()->time() >= after; })) return false;
    }
    return condition();
  }
  void wantBallPercepts(Desk& desk) {
    robotcontrol::Request request;
    request.set_robot("red1");
    request.mutable_set_key()->set_name("package/percepts/ball");
    request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    desk.workbench.session().request(request);
  }
  const robotcontrol::BallPercept* ballPercept(Desk& desk) {
    auto& session = desk.workbench.session();
    return session.store().latestAs<robotcontrol::BallPercept>("red1/percepts/ball",
                                                               session.timeline().newest());
  }

  /// Whether the newest percept says that the ball is where the image that it is of shows it.
  bool seesBall(Desk& desk) {
    const robotcontrol::BallPercept* percept = ballPercept(desk);
    if (percept == nullptr || !percept->seen()) return false;
    const auto* image = desk.workbench.session().store().latestAs<foxglove::RawImage>(
        "red1/camera/image", robotlink::instant(percept->timestamp()));
    if (image == nullptr) return false;
    const std::vector<QPoint> ball = violet(widgets::toQImage(robotlink::imageView(*image)));
    const QPoint center = middle(ball);
    const auto& seen = percept->center_in_image();
    return ball.size() > 60 && std::hypot(seen.x() - center.x(), seen.y() - center.y()) < 8;
  }
};

const widgets::test::GuiTest<ColorGuiTest> kColorGuiTest;

}  // namespace app::test

#include "ColorGuiTest.moc"
