// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/ActuatorPanel.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

#include "robotcontrol/World.pb.h"
#include "tests/widgets/Bench.h"
#include "widgets/objects/SceneTreeModel.h"

namespace widgets::test {
namespace {

/// A panel for actuators of the robot red1 and of a door, which is none.
struct ActuatorBench : Bench {
  ActuatorBench() : Bench({.robots = {"red1"}, .answers = false}) {}

  robotcontrol::WorldPort& add(const std::string& path, const char* type, std::vector<int> shape = {},
                               const char* robot = "red1") {
    auto& object = *objects.add_objects();
    object.set_path(path);
    auto& port = *object.mutable_port();
    port.set_path(path);
    port.set_robot(robot);
    port.set_type(type);
    port.set_is_actuator(true);
    for (const int size : shape) port.add_shape(size);
    return port;
  }
  /// Shows all of them.
  void show() {
    model.setObjects(std::make_shared<const robotcontrol::WorldObjects>(objects));
    std::vector<std::string> paths;
    for (const auto& object : objects.objects()) paths.push_back(object.path());
    panel.show(paths);
    window.resize(500, 400);
    panel.resize(500, 400);
    window.show();
    if (!QTest::qWaitForWindowActive(&window)) qFatal("the window never became active");
    window.setFocusPolicy(Qt::StrongFocus);
    window.setFocus();
  }
  /// What is measured and held, as values by ports.
  void read(const std::map<std::string, double>& measured, const std::map<std::string, double>& held = {}) {
    auto readings = std::make_shared<robotcontrol::PortReadings>();
    const auto set = [](robotcontrol::PortReading& reading, const auto& pair) {
      reading.set_port(pair.first);
      reading.add_values(pair.second);
    };
    for (const auto& pair : measured) set(*readings->add_readings(), pair);
    for (const auto& pair : held) set(*readings->add_held(), pair);
    model.setReadings(readings);
    panel.refresh();
  }
  QSlider& slider(const char* name) { return child<QSlider>(panel, name); }
  QDoubleSpinBox& field(const char* name) { return child<QDoubleSpinBox>(panel, name); }
  void type(QDoubleSpinBox& into, const char* text) {
    into.setFocus();
    into.selectAll();
    QTest::keyClicks(&into, QLatin1String(text));
    QTest::keyClick(&into, Qt::Key_Return);
  }
  std::vector<double> lastValues() const {
    const auto& values = requests.back().set_actuator().values();
    return {values.begin(), values.end()};
  }

  robotcontrol::WorldObjects objects;
  SceneTreeModel model;
  QWidget window;
  ActuatorPanel& panel = *new ActuatorPanel(session, model, &window);
};

}  // namespace

class ActuatorPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void sliderAndFieldShowTheSameAndEachHoldsTheActuator() {
    ActuatorBench bench;
    auto& port = bench.add("red1/pan/request", "angle");
    port.set_minimum(-2);
    port.set_maximum(2);
    port.set_unit("rad");
    bench.show();
    auto& slider = bench.slider("actuator-red1/pan/request-0");
    auto& field = bench.field("actuatorValue-red1/pan/request-0");
    QCOMPARE(field.suffix(), QStringLiteral(" rad"));
    bench.type(field, "1");
    QCOMPARE(slider.value(), 750);
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests.back().robot(), std::string("red1"));
    QCOMPARE(bench.requests.back().set_actuator().port(), std::string("red1/pan/request"));
    QCOMPARE(bench.lastValues(), std::vector<double>{1});
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_Home);
    QCOMPARE(field.value(), -2.0);
    QCOMPARE(bench.requests.size(), std::size_t{2});
    QCOMPARE(bench.lastValues(), std::vector<double>{-2});
  }

  void allValuesOfAnActuatorAreHeldTogether() {
    ActuatorBench bench;
    auto& wheels = bench.add("red1/wheels", "wheel_speeds", {2});
    wheels.set_minimum(-10);
    wheels.set_maximum(10);
    bench.show();
    QCOMPARE(bench.slider("actuator-red1/wheels-0").accessibleName(), QStringLiteral("red1/wheels [left]"));
    QCOMPARE(bench.slider("actuator-red1/wheels-1").accessibleName(), QStringLiteral("red1/wheels [right]"));
    bench.type(bench.field("actuatorValue-red1/wheels-1"), "5");
    QCOMPARE(bench.lastValues(), (std::vector<double>{0, 5}));
    bench.type(bench.field("actuatorValue-red1/wheels-0"), "-5");
    QCOMPARE(bench.lastValues(), (std::vector<double>{-5, 5}));
  }

  void valuesAreNamedByTheirMeaningOrCounted() {
    ActuatorBench bench;
    bench.add("red1/walk", "motion", {3});
    bench.add("red1/other", "color", {2});
    bench.show();
    const auto name = [&](const char* slider) { return bench.slider(slider).accessibleName(); };
    QCOMPARE(name("actuator-red1/walk-0"), QStringLiteral("red1/walk [ahead]"));
    QCOMPARE(name("actuator-red1/walk-2"), QStringLiteral("red1/walk [turn]"));
    QCOMPARE(name("actuator-red1/other-1"), QStringLiteral("red1/other [1]"));
  }

  void eachValueHasItsOwnRangeAndUnit() {
    ActuatorBench bench;
    bench.add("car/drive", "motion", {2}, "car").set_unit("m/s, rad");
    auto& object = *bench.objects.mutable_objects()->rbegin();
    for (const auto& [name, sign] : {std::pair("minimum", -1), std::pair("maximum", 1)}) {
      auto& limits = *object.add_properties();
      limits.set_name(name);
      limits.add_values(3 * sign);
      limits.add_values(0.7 * sign);
    }
    bench.add("drone/motion", "motion", {6}, "drone").set_unit("m/s, rad/s");
    bench.show();
    const auto& speed = bench.field("actuatorValue-car/drive-0");
    const auto& steering = bench.field("actuatorValue-car/drive-1");
    QCOMPARE(speed.suffix(), QStringLiteral(" m/s"));
    QCOMPARE(speed.maximum(), 3.0);
    QCOMPARE(steering.suffix(), QStringLiteral(" rad"));
    QCOMPARE(steering.minimum(), -0.7);
    QCOMPARE(bench.slider("actuator-car/drive-1").accessibleName(), QStringLiteral("car/drive [steering]"));
    QCOMPARE(bench.field("actuatorValue-drone/motion-2").suffix(), QStringLiteral(" m/s"));
    QCOMPARE(bench.field("actuatorValue-drone/motion-3").suffix(), QStringLiteral(" rad/s"));
  }

  void anActuatorThatMetAnObstacleIsMarked() {
    ActuatorBench bench;
    bench.add("red1/pan/request", "angle");
    bench.show();
    bench.push("objects", bench.objects, 1);
    bench.session.tick();
    bench.panel.refresh();
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests.back().read_ports().ports(0), std::string("red1/pan/request"));
    const auto& blocked = child<QLabel>(bench.panel, "actuatorBlocked-red1/pan/request");
    QVERIFY(!blocked.isVisible());
    for (const double isFree : {0.0, 1.0}) {
      auto readings = std::make_shared<robotcontrol::PortReadings>();
      auto& state = *readings->add_readings();
      state.set_port("red1/pan/request");
      state.add_values(1);
      state.add_values(isFree);
      bench.model.setReadings(readings);
      bench.panel.refresh();
      QCOMPARE(blocked.isVisible(), isFree == 0);
      QVERIFY2(!bench.field("actuatorValue-red1/pan/request-0").font().bold(), "it is not held");
    }
  }

  void anActuatorWithoutARangeHasAWideOne() {
    ActuatorBench bench;
    bench.add("red1/force", "force");
    bench.show();
    QCOMPARE(bench.field("actuatorValue-red1/force-0").minimum(), -1000.0);
    QCOMPARE(bench.field("actuatorValue-red1/force-0").maximum(), 1000.0);
    QCOMPARE(bench.slider("actuator-red1/force-0").value(), 500);
  }

  void thereIsABoundedNumberOfSliders() {
    ActuatorBench bench;
    bench.add("red1/many", "lamps", {100, 100});
    for (int i = 0; i < 60; ++i) bench.add("red1/m" + std::to_string(i), "angle");
    bench.show();
    const auto sliders = bench.panel.findChildren<QSlider*>(QRegularExpression(QStringLiteral("^actuator-")));
    QCOMPARE(sliders.size(), 16 + static_cast<int>(ActuatorPanel::kMax) - 1);
  }

  void whatIsNotHeldFollowsItsSensor() {
    ActuatorBench bench;
    for (const char* path : {"red1/pan/request", "red1/wheel/speed_request", "red1/arm/torque_request"}) {
      auto& port = bench.add(path, "angle");
      port.set_minimum(-1);
      port.set_maximum(1);
    }
    bench.show();
    bench.read({{"red1/pan/position", 0.5}, {"red1/wheel/speed", -7}, {"red1/arm/load", 0.25}});
    QCOMPARE(bench.field("actuatorValue-red1/pan/request-0").value(), 0.5);
    QCOMPARE(bench.slider("actuator-red1/pan/request-0").value(), 750);
    QCOMPARE(bench.field("actuatorValue-red1/wheel/speed_request-0").value(), -1.0);  // within its range
    QCOMPARE(bench.field("actuatorValue-red1/arm/torque_request-0").value(), 0.25);
    QVERIFY(bench.requests.empty());  // to show something holds nothing
  }

  void whatIsHeldIsBoldUntilItIsReleased() {
    ActuatorBench bench;
    bench.add("red1/pan/request", "angle", {2});
    bench.add("red1/tilt/request", "angle");
    bench.show();
    auto& pan = bench.field("actuatorValue-red1/pan/request-0");
    auto& tilt = bench.field("actuatorValue-red1/tilt/request-0");
    auto& release = child<QPushButton>(bench.panel, "actuatorsRelease");
    QVERIFY(!release.isEnabled());
    bench.read({{"red1/pan/position", 3}}, {{"red1/pan/request", 7}});
    QCOMPARE(pan.value(), 7.0);
    QVERIFY(pan.font().bold() && !tilt.font().bold());
    click(release);
    QCOMPARE(bench.requests.size(), std::size_t{2});  // one for each actuator, not for each value
    for (const auto& request : bench.requests) QVERIFY(request.set_actuator().released());
    bench.read({});
    QVERIFY(!pan.font().bold() && !release.isEnabled());
  }

  void aControlThatTheUserIsAtStaysAsItIs() {
    ActuatorBench bench;
    bench.add("red1/pan/request", "angle");
    bench.add("red1/tilt/request", "angle");
    bench.show();
    auto& pan = bench.field("actuatorValue-red1/pan/request-0");
    pan.setFocus();
    pan.selectAll();
    QTest::keyClicks(&pan, QStringLiteral("12"));
    bench.read({{"red1/pan/position", 3}, {"red1/tilt/position", 4}});
    QCOMPARE(pan.cleanText(), QStringLiteral("12"));
    QCOMPARE(bench.field("actuatorValue-red1/tilt/request-0").value(), 4.0);
    QVERIFY(bench.requests.empty());  // not before it is complete
  }

  void whatBelongsToNoRobotIsAskedOfTheSimulation() {
    ActuatorBench bench;
    bench.add("door/hinge", "angle", {}, "door");
    bench.show();
    bench.type(bench.field("actuatorValue-door/hinge-0"), "1");
    QCOMPARE(bench.requests.back().robot(), std::string());
  }

  void aRefusalIsShownUntilSomethingIsAccepted() {
    ActuatorBench bench;
    bench.add("red1/pan/request", "angle");
    bench.show();
    auto& outcome = child<QLabel>(bench.panel, "actuatorsOutcome");
    bench.type(bench.field("actuatorValue-red1/pan/request-0"), "1");
    bench.answer(false, "the simulation has ended");
    bench.session.tick();
    QCOMPARE(outcome.text(), QStringLiteral("the simulation has ended"));
    bench.type(bench.field("actuatorValue-red1/pan/request-0"), "2");
    bench.answer(true);
    bench.session.tick();
    QCOMPARE(outcome.text(), QString());
  }

  void itIsHiddenWhileThereIsNothingToSet() {
    ActuatorBench bench;
    bench.add("red1/pan/request", "angle");
    bench.show();
    QVERIFY(bench.panel.isVisible());
    bench.panel.show({"red1/unknown"});
    QVERIFY(!bench.panel.isVisible());
    bench.panel.show({"red1/pan/request"});
    QVERIFY(bench.panel.isVisible());
    bench.panel.show({});
    QVERIFY(!bench.panel.isVisible());
  }
};

const GuiTest<ActuatorPanelTest> kActuatorPanelTest;

}  // namespace widgets::test

#include "ActuatorPanelTest.moc"
