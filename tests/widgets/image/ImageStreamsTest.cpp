// SPDX-License-Identifier: GPL-3.0-or-later
// Which stream the view of images shows until the user chooses one.
#include <QComboBox>
#include <QListView>
#include <QSignalSpy>
#include <QTest>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/widgets/FieldBench.h"
#include "widgets/image/ImageCanvas.h"
#include "widgets/image/ImageHint.h"
#include "widgets/image/ImageStreamView.h"

namespace widgets::test {
namespace {

constexpr robotlink::YCbCr kDarkImage{60, 128, 128}, kBrightImage{200, 128, 128};

struct ShownStreams {
  FieldBench world;
  std::unique_ptr<ImageStreamView> view = world.open<ImageStreamView>();
  QComboBox* streams = &child<QComboBox>(*view, "imageStream");

  void push(const std::string& path, robotlink::YCbCr color) { world.pushImage(path, {80, 60}, color); }
  void step() {
    world.advance();
    view->tick();
  }
  const ImageCanvas& canvas() const { return child<ImageCanvas>(*view, "imageCanvas"); }
  bool shows(robotlink::YCbCr color) const {
    const QImage& pixels = canvas().picture().pixels;
    const robotlink::Rgb rgb = toRgb(color);
    return !pixels.isNull() && isNear(pixels.pixelColor(10, 10), QColor(rgb.r, rgb.g, rgb.b), 2);
  }
};

}  // namespace

class ImageStreamsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void imagesOfALogWithoutARobotAreShownAtOnce() {
    ShownStreams s;
    s.world.session.setRobots({});
    s.push("/cam", kDarkImage);
    s.push("/depth", kBrightImage);
    s.step();
    QVERIFY(s.shows(kDarkImage));
    QCOMPARE(s.streams->count(), 2);
    QCOMPARE(s.streams->currentText(), QStringLiteral("/cam"));
    s.streams->setFocus();
    QTest::keyClick(s.streams, Qt::Key_Down);
    s.step();
    QVERIFY(s.shows(kBrightImage));
    QCOMPARE(s.streams->currentText(), QStringLiteral("/depth"));
  }

  void itSaysThatTheSceneHasNoSuchImages() {
    ShownStreams s;
    s.world.session.setRobots({});
    robotcontrol::WorldObjects objects;
    objects.add_objects()->set_path("cam9");
    s.world.push("objects", objects, 1);
    s.world.push("other", foxglove::Log(), 1);
    s.step();
    QCOMPARE(
        imageHint(s.world.context, "cam/color/image"),
        QStringLiteral("There are no images of cam/color/image in this scene. Choose others at the top."));
  }

  void theTitleIsSaidAlsoToWhoListensLater() {
    ShownStreams s;
    s.push("red1/camera/image", kDarkImage);
    s.step();
    QSignalSpy titles(s.view.get(), &View::titleChanged);
    s.step();
    QVERIFY(!titles.isEmpty());
    QCOMPARE(titles.last().front().toString(), QStringLiteral("Image: red1/camera/image"));
  }

  void theStreamAndTheSecondImageAreChosenByTheirPaths() {
    constexpr robotlink::YCbCr kBlack{0, 128, 128};
    ShownStreams s;
    s.push("red1/camera/image", kDarkImage);
    s.push("red1/logged/camera/image", kBrightImage);
    s.step();
    QVERIFY(s.view->showStream("red1/logged/camera/image"));
    QVERIFY(s.shows(kBrightImage));
    QVERIFY(s.view->showStream("*/camera/image"));
    QVERIFY(s.shows(kDarkImage));
    const auto wrong = s.view->showStream("red1/camera/imago");
    QVERIFY(!wrong);
    QVERIFY(wrong.error().text.find("'red1/camera/image'") != std::string::npos);
    QVERIFY(s.view->compareWith("*/camera/image", "difference"));
    QVERIFY(s.shows(kBlack));
    QVERIFY(!s.view->compareWith("red9/camera/image", "blend"));
    s.view->endComparison();
    QVERIFY(s.shows(kDarkImage));
  }

  void theCameraIsShownInsteadOfOtherImagesAsSoonAsItHasAny() {
    ShownStreams s;
    s.push("red1/front/color", kDarkImage);
    s.step();
    QVERIFY(s.shows(kDarkImage));
    s.push("red1/camera/image", kBrightImage);
    s.step();
    QVERIFY(s.shows(kBrightImage));
  }

  void aChosenStreamStaysChosenAlthoughItDoesNotExist() {
    ShownStreams s;
    s.view->restoreState({{QStringLiteral("stream"), QStringLiteral("red1/images/lines")}});
    s.push("red1/front/color", kDarkImage);
    s.step();
    QVERIFY(s.canvas().picture().pixels.isNull());
    QCOMPARE(s.streams->currentText(), QStringLiteral("red1/images/lines"));
  }

  void aLogWithoutImagesSaysSo() {
    ShownStreams s;
    s.world.session.setRobots({});
    s.step();
    QVERIFY2(s.canvas().hint().startsWith(QStringLiteral("No robot.")), qPrintable(s.canvas().hint()));
    s.world.push("/rosout", foxglove::Log(), 1);
    s.step();
    QVERIFY2(s.canvas().hint().contains(QStringLiteral("no images up to this time")),
             qPrintable(s.canvas().hint()));
  }

  void aSceneWithoutRobotsSaysSo() {
    ShownStreams s;
    s.world.session.setRobots({});
    s.world.push("objects", robotcontrol::WorldObjects(), 1);
    s.step();
    QVERIFY2(s.canvas().hint().startsWith(QStringLiteral("There is no robot in this scene.")),
             qPrintable(s.canvas().hint()));
  }

  void afterAnotherSceneWasOpenedTheImagesOfItsRobotAreShown() {
    ShownStreams s;
    s.world.session.setRobots({"red1"});
    s.push("red1/front/color", kDarkImage);
    s.step();
    QVERIFY(s.view->showStream("red1/front/color"));
    s.world.session.setRobots({"burger1"});
    s.world.session.selectRobot("burger1");
    s.world.session.store().clear();
    s.step();
    QVERIFY2(s.canvas().hint().contains(QStringLiteral("burger1/camera/image")),
             qPrintable(s.canvas().hint()));
    s.push("burger1/front/color", kBrightImage);
    s.step();
    QVERIFY(s.shows(kBrightImage));
    // The choice is not forgotten.
    s.world.session.setRobots({"red1"});
    s.world.session.selectRobot("red1");
    s.world.session.store().clear();
    s.push("red1/front/color", kDarkImage);
    s.step();
    QVERIFY(s.shows(kDarkImage));
    QCOMPARE(s.streams->currentText(), QStringLiteral("red1/front/color"));
  }

  void aCameraOfTheSceneThatHasSentNothingYetStaysChosen() {
    ShownStreams s;
    robotcontrol::WorldObjects objects;
    objects.add_objects()->mutable_port()->set_image_stream("tower/eye");
    s.world.push("objects", objects, 1);
    s.push("red1/camera/image", kDarkImage);
    s.step();
    QVERIFY(s.view->showStream("tower/eye"));
    s.step();
    QVERIFY(s.canvas().picture().pixels.isNull());
    QVERIFY(s.canvas().hint().contains(QStringLiteral("tower/eye")));
  }

  void imagesOfARobotThatHasGoneAreNotShownInsteadOfNone() {
    ShownStreams s;
    s.world.session.setRobots({"burger1"});
    s.world.session.selectRobot("burger1");
    s.world.push("objects", robotcontrol::WorldObjects(), 1);
    s.push("red1/camera/image", kDarkImage);
    s.step();
    QVERIFY(!s.shows(kDarkImage));
    QVERIFY(!s.streams->currentText().startsWith(QStringLiteral("red1")));
  }

  void aRobotWithoutACameraIsSaidToHaveNone() {
    ShownStreams s;
    s.world.session.setRobots({"burger1"});
    auto kind = std::make_shared<robotlink::RobotDescription>();
    kind->offers = {"drive/state", "range/laser"};
    s.world.context.robots["burger1"] = kind;
    s.step();
    QVERIFY2(s.canvas().hint().startsWith(QStringLiteral("burger1 has no camera.")),
             qPrintable(s.canvas().hint()));
    robotcontrol::WorldObjects objects;
    auto& port = *objects.add_objects()->mutable_port();
    port.set_robot("burger1");
    port.set_image_stream("burger1/eye/image");
    s.world.push("objects", objects, 1);
    s.step();
    QVERIFY2(s.canvas().hint().startsWith(QStringLiteral("No image yet")), "the scene gives it one");
  }

  void namesOfDrawingsKeepTheirEnds() {
    ShownStreams s;
    s.world.pushFrame({imageDrawing("perception/lines/points-on-the-field", [](auto&) {})});
    s.step();
    const auto& list = child<QListView>(*s.view, "drawingsList");
    QCOMPARE(list.textElideMode(), Qt::ElideLeft);
    QVERIFY(list.model()
                ->index(0, 0)
                .data(Qt::ToolTipRole)
                .toString()
                .contains(QStringLiteral("perception/lines/points-on-the-field")));
  }

  void imagesOfAnotherRobotAreNotTakenForThoseOfTheSelectedOne() {
    ShownStreams s;
    s.world.session.setRobots({"red1", "blue1"});
    s.push("blue1/camera/image", kDarkImage);
    s.step();
    QVERIFY(s.canvas().picture().pixels.isNull());
  }
};

const GuiTest<ImageStreamsTest> kImageStreamsTest;

}  // namespace widgets::test

#include "ImageStreamsTest.moc"
