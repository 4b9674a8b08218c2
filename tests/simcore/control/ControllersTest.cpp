// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/control/Controllers.h"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "simcore/control/ControllerSetup.h"
#include "simcore/world/ViewEvent.h"
#include "tests/simcore/SensorScenes.h"

namespace simcore {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Turns the wheel of the cart to an angle that grows with time, and shows what it reads and gets.
class Turner final : public Controller {
 public:
  explicit Turner(ControllerSetup& setup)
      : request_(setup.port("request")),
        speed_(setup.number("speed")),
        failsAt_(setup.number("fails_at")),
        angle_(setup.addValues("angle", "angle", {}, "rad")),
        keys_(setup.addValues("keys", "count", {2})),
        picture_(setup.addImage("picture", 4, 2, robotlink::PixelFormat::kMono8)),
        mark_(setup.addDrawing("mark")) {}

  void step(ControlledWorld& world) override {
    if (failsAt_ >= 0 && world.time() >= failsAt_) throw std::runtime_error("the wheel is stuck");
    world.command(request_, {speed_ * world.time()});
    angle_.values[0] = world.number("cart/axle/position");
    for (const ViewEvent& event : world.events()) {
      ++keys_.values[event.isOfMouse() ? 1 : 0];
      hit_ = event.object;
    }
    picture_.image.data[0] = static_cast<std::uint8_t>(world.step() % 256);
    mark_.shapes = {{DrawnShape::Kind::kText, {world.modelPose("cart")->translation()}}};
    mark_.shapes[0].text = hit_;
  }
  std::string state() const override { return std::to_string(keys_.values[0]); }
  void restore(std::string_view state) override { keys_.values[0] = std::stod(std::string(state)); }

 private:
  const std::string request_;
  const double speed_, failsAt_;
  ControllerOutput &angle_, &keys_, &picture_, &mark_;
  std::string hit_;
};

/// Makes its output too short after a second.
class Breaker final : public Controller {
 public:
  explicit Breaker(ControllerSetup& setup) : numbers_(setup.addValues("numbers", "count", {3})) {}
  void step(ControlledWorld& world) override {
    if (world.step() == 10) numbers_.values.resize(1);
  }

 private:
  ControllerOutput& numbers_;
};

/// Shows the first pixel of what a camera sees.
class Watcher final : public Controller {
 public:
  explicit Watcher(ControllerSetup& setup) : first_(setup.addValues("first", "color", {3})) {}
  void step(ControlledWorld& world) override {
    EXPECT_FALSE(world.image("cart/axle/position")) << "no camera";
    const auto image = world.image("cart/eye/image");
    if (!image) throw std::runtime_error(image.error().text);
    const std::uint8_t* const pixel = (*image)->data.data();
    first_.values = {double(pixel[0]), double(pixel[1]), double(pixel[3])};
  }

 private:
  ControllerOutput& first_;
};

using Type = ControllerParameter::Type;
const ControllerRegistration kTurner{
    ControllerKind{"test_turner",
                   "Turns a wheel.",
                   {{"request", Type::kActuator, "a servo", "", true},
                    {"speed", Type::kNumber, "rad/s", "1", false, -5, 5},
                    {"fails_at", Type::kNumber, "s", "-1"},
                    {"eyes", Type::kSensors, "some sensors"},
                    {"goal", Type::kModel, "a model"}},
                   [](ControllerSetup& setup) { return std::make_unique<Turner>(setup); }}};
const ControllerRegistration kBreaker{ControllerKind{
    "test_breaker", "", {}, [](ControllerSetup& setup) { return std::make_unique<Breaker>(setup); }}};

const ControllerRegistration kWatcher{ControllerKind{
    "test_watcher", "", {}, [](ControllerSetup& setup) { return std::make_unique<Watcher>(setup); }}};

const std::string kWheel = R"(<link name="wheel"><pose>0 0 0.2 0 0 0</pose>
    <inertial><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia></inertial></link>
  <joint name="axle" type="revolute"><parent>base</parent><child>wheel</child><axis><xyz>0 0 1</xyz>
    <limit><lower>-3</lower><upper>3</upper><effort>5</effort><velocity>10</velocity></limit></axis>
    <robotcontrol:servo/></joint>)";

std::string turner(const std::string& parameters = "", const std::string& as = "") {
  return "<robotcontrol:controller name='test_turner'" + as +
         "><robotcontrol:parameter name='request'>axle/request</robotcontrol:parameter>" + parameters +
         "</robotcontrol:controller>";
}

std::string parameter(const std::string& name, const std::string& value) {
  return "<robotcontrol:parameter name='" + name + "'>" + value + "</robotcontrol:parameter>";
}

ViewEvent keyPress(const std::string& key) {
  ViewEvent event;
  event.view = "scene";
  event.key = key;
  return event;
}

ViewEvent clickFrom(const robotlink::Vector3& origin, const robotlink::Vector3& direction) {
  ViewEvent event;
  event.kind = ViewEvent::Kind::kMousePressed;
  event.view = "scene";
  event.button = 1;
  event.origin = origin;
  event.direction = direction;
  return event;
}

void runSteps(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.step();
}

std::vector<double> valuesAt(const Simulation& simulation, const std::string& path) {
  return simulation.read(path).value_or(std::vector<double>{});
}

std::string errorsOfWorld(const std::string& contents) {
  const SceneFolder folder;
  return folder.errorsOf(worldAround(contents));
}

std::string cartOf(const std::string& inModel) {
  return "<model name='cart'><link name='base'><inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy>"
         "<izz>1</izz></inertia></inertial></link>\n" +
         kWheel + "\n" + inModel + "</model>";
}

TEST(ControllersTest, aControllerReadsSensorsAndSetsActuators) {
  const auto simulation = cartWith("", kWheel + turner(parameter("speed", "0.5")));
  ASSERT_TRUE(simulation);
  runSteps(*simulation, 250);
  EXPECT_NEAR(valuesAt(*simulation, "cart/axle/position").front(), 0.5, 0.05);
  EXPECT_NEAR(valuesAt(*simulation, "cart/test_turner/angle").front(), 0.5, 0.05);
}

TEST(ControllersTest, itsOutputsLookLikeSensors) {
  const auto simulation = cartWith("", kWheel + turner());
  ASSERT_TRUE(simulation);
  runSteps(*simulation, 3);
  const Port* angle = simulation->port("cart/test_turner/angle");
  ASSERT_NE(angle, nullptr);
  EXPECT_EQ(angle->info.unit, "rad");
  EXPECT_EQ(angle->info.robot, "cart");
  EXPECT_FALSE(angle->isActuator());
  EXPECT_THAT(simulation->port("cart/test_turner/picture")->info.shape, ElementsAre(2, 4, 1));
  EXPECT_THAT(valuesAt(*simulation, "cart/test_turner/picture"), ElementsAre(2, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_FALSE(simulation->read("cart/test_turner/mark"));
  ASSERT_EQ(simulation->outputs().size(), 4U);
  EXPECT_EQ(simulation->outputs()[3]->shapes.size(), 1U);
}

TEST(ControllersTest, eventsEnterAtTheNextStepWithWhatTheyHit) {
  const auto simulation = cartWith("", kWheel + turner(), solidAt("wall", "2 0 0.5 0 0 0", "0.1 1 1"));
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->addEvent(keyPress("A")));
  ASSERT_TRUE(simulation->addEvent(clickFrom({1, 0, 0.5}, {3, 0, 0})));
  EXPECT_TRUE(simulation->events().empty()) << "not before the step";
  simulation->step();
  ASSERT_EQ(simulation->events().size(), 2U);
  const ViewEvent& click = simulation->events()[1];
  EXPECT_EQ(click.object, "wall/l/v");
  EXPECT_EQ(click.model, "wall");
  EXPECT_NEAR(click.point.x(), 1.95, 1e-6);
  EXPECT_THAT(valuesAt(*simulation, "cart/test_turner/keys"), ElementsAre(1, 1));
  simulation->step();
  EXPECT_TRUE(simulation->events().empty());
  EXPECT_THAT(valuesAt(*simulation, "cart/test_turner/keys"), ElementsAre(1, 1));
}

TEST(ControllersTest, aClickAtAMovingModelHitsItWhereItIs) {
  const auto simulation = cartWith("", kWheel + turner());
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->placeModel("cart", {1, 2, 0}));
  ASSERT_TRUE(simulation->addEvent(clickFrom({1, 2, 3}, {0, 0, -1})));
  simulation->step();
  ASSERT_EQ(simulation->events().size(), 1U);
  EXPECT_EQ(simulation->events()[0].model, "cart");
  EXPECT_NEAR(simulation->events()[0].point.z(), 0.1, 0.01);
}

TEST(ControllersTest, eventsThatMakeNoSenseAreRefused) {
  const auto simulation = cartWith("", kWheel + turner());
  ASSERT_TRUE(simulation);
  EXPECT_FALSE(simulation->addEvent(keyPress("")));
  EXPECT_FALSE(simulation->addEvent(clickFrom({0, 0, 0}, {0, 0, 0})));
  EXPECT_FALSE(simulation->addEvent(clickFrom({std::nan(""), 0, 0}, {0, 0, 1})));
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(simulation->addEvent(keyPress("A")));
  EXPECT_FALSE(simulation->addEvent(keyPress("A"))) << "memory stays bounded";
}

TEST(ControllersTest, aControllerThatThrowsIsSwitchedOffAndTheSimulationGoesOn) {
  const auto simulation =
      cartWith("", kWheel + turner(parameter("fails_at", "0.1")) + turner("", " as='other'"));
  ASSERT_TRUE(simulation);
  runSteps(*simulation, 100);
  ASSERT_EQ(simulation->controllers().size(), 2U);
  const ControllerStatus& status = simulation->controllers()[0];
  EXPECT_EQ(status.path, "cart/test_turner");
  EXPECT_EQ(status.trouble, "the wheel is stuck");
  EXPECT_EQ(status.troubleStep, 25U);
  EXPECT_TRUE(simulation->controllers()[1].isOn());
  EXPECT_NEAR(valuesAt(*simulation, "cart/other/angle").front(), 0.4, 0.05);
}

TEST(ControllersTest, aControllerWhoseOutputsAreWrongIsSwitchedOff) {
  const auto simulation = cartWith("", kWheel + "<robotcontrol:controller name='test_breaker'/>");
  ASSERT_TRUE(simulation);
  runSteps(*simulation, 20);
  EXPECT_THAT(simulation->controllers()[0].trouble,
              AllOf(HasSubstr("cart/test_breaker/numbers"), HasSubstr("1 values instead of 3")));
  EXPECT_THAT(valuesAt(*simulation, "cart/test_breaker/numbers"), ElementsAre(0, 0, 0));
}

TEST(ControllersTest, theSameEventsGiveTheSameBytesAndOthersOtherBytes) {
  const auto play = [](int pressAt, int resets) {
    const auto simulation = cartWith("", kWheel + turner());
    for (int reset = 0; reset <= resets; ++reset) {
      simulation->reset(7);
      for (int i = 0; i < 60; ++i) {
        if (i == pressAt) static_cast<void>(simulation->addEvent(keyPress("A")));
        simulation->step();
      }
    }
    return simulation->digest();
  };
  EXPECT_EQ(play(20, 0), play(20, 0));
  EXPECT_EQ(play(20, 0), play(20, 2)) << "a reset is as good as a new simulation";
  EXPECT_NE(play(20, 0), play(21, 0));
  EXPECT_NE(play(20, 0), play(-1, 0));
}

TEST(ControllersTest, commandsAfterTheControllersOverrideTheirs) {
  const auto simulation = cartWith("", kWheel + turner(parameter("speed", "2")));
  ASSERT_TRUE(simulation);
  for (int i = 0; i < 250; ++i) {
    simulation->control();
    ASSERT_TRUE(simulation->write("cart/axle/request", std::vector<double>{-0.7}));
    simulation->step();
  }
  EXPECT_NEAR(valuesAt(*simulation, "cart/axle/position").front(), -0.7, 0.02);
}

TEST(ControllersTest, whatAControllerRemembersSurvivesAnEditedScene) {
  const SceneFolder folder;
  const std::string text = worldAround(cartOf(turner()));
  const auto first = Scene::load(folder.write("a.sdf", text));
  const auto second = Scene::load(folder.write("b.sdf", text));
  ASSERT_TRUE(first && second);
  const auto simulation = std::move(Simulation::create(*first, {}).value());
  ASSERT_TRUE(simulation->addEvent(keyPress("A")));
  runSteps(*simulation, 2);
  ASSERT_TRUE(simulation->continueIn(*second));
  EXPECT_EQ(valuesAt(*simulation, "cart/test_turner/keys").front(), 1);
  runSteps(*simulation, 2);
  EXPECT_TRUE(simulation->controllers()[0].isOn());
}

TEST(ControllersTest, aSnapshotHasWhatControllersShowAndWhoIsOff) {
  const auto make = [] {
    return cartWith("", kWheel + turner(parameter("fails_at", "0.1")) + turner("", " as='other'"));
  };
  const auto simulation = make(), other = make();
  ASSERT_TRUE(simulation && other);
  ASSERT_TRUE(simulation->addEvent(clickFrom({1, 0, 3}, {0, 0, -1})));
  runSteps(*simulation, 40);
  const Snapshot snapshot = simulation->snapshot();
  const std::uint64_t digest = simulation->digest();
  ASSERT_TRUE(other->restore(snapshot));
  EXPECT_EQ(other->digest(), digest) << "that has outputs and troubles";
  EXPECT_EQ(other->snapshot().state, snapshot.state);
  EXPECT_EQ(valuesAt(*other, "cart/other/angle"), valuesAt(*simulation, "cart/other/angle"));
  EXPECT_EQ(valuesAt(*other, "cart/other/picture"), valuesAt(*simulation, "cart/other/picture"));
  ASSERT_EQ(other->outputs()[7]->shapes.size(), 1U);
  EXPECT_EQ(other->outputs()[7]->shapes[0].points, simulation->outputs()[7]->shapes[0].points);
  EXPECT_EQ(other->controllers()[0].trouble, "the wheel is stuck");
  EXPECT_EQ(other->controllers()[0].troubleStep, 25U);
  runSteps(*simulation, 20);
  ASSERT_TRUE(simulation->restore(snapshot));
  EXPECT_EQ(simulation->digest(), digest);
}

TEST(ControllersTest, aControllerSeesTheImageOfACamera) {
  const std::string eye =
      "<sensor name='eye' type='camera'><camera><image><width>16</width><height>8</height></image></camera>"
      "<pose>0.3 0 0.3 0 0 0</pose></sensor>";
  const std::string wall = "<material><diffuse>1 0 0 1</diffuse></material>";
  const auto simulation = cartWith(eye, kWheel + "<robotcontrol:controller name='test_watcher'/>",
                                   solidAt("wall", "3 0 1 0 0 0", "0.1 9 9", wall));
  ASSERT_TRUE(simulation);
  runSteps(*simulation, 2);
  ASSERT_TRUE(simulation->controllers()[0].isOn()) << simulation->controllers()[0].trouble;
  const auto seen = valuesAt(*simulation, "cart/test_watcher/first");
  EXPECT_LT(seen[1], 128) << "red has less blue";
  EXPECT_GT(seen[2], 160) << "and more red than gray";
  // Whoever else makes the images makes those of controllers, too.
  robotlink::Image gray(16, 8, robotlink::PixelFormat::kYuyv);
  std::ranges::fill(gray.data, std::uint8_t{128});
  simulation->setCameraImages([&](std::size_t) { return &gray; });
  runSteps(*simulation, 1);
  EXPECT_THAT(valuesAt(*simulation, "cart/test_watcher/first"), ElementsAre(128, 128, 128));
}

TEST(ControllersTest, anUnknownControllerIsNamedWithThoseThatAreKnown) {
  const std::string errors = errorsOfWorld("<robotcontrol:controller name='wizard'/>");
  EXPECT_THAT(errors, AllOf(HasSubstr("world.sdf:"), HasSubstr("there is no controller 'wizard'"),
                            HasSubstr("ball_replacer, elevator")));
  EXPECT_THAT(errorsOfWorld("<robotcontrol:controller name='elevatr'/>"),
              HasSubstr("did you mean 'elevator'?"));
}

TEST(ControllersTest, wrongParametersAreReportedWithTheirLines) {
  const std::string errors = errorsOfWorld(
      cartOf("<robotcontrol:controller name='test_turner'>\n" + parameter("request", "axle/reqest") + "\n" +
             parameter("speeed", "1") + "\n" + parameter("goal", "ball") + "\n" +
             parameter("eyes", "axle/position nothing") + "</robotcontrol:controller>"));
  EXPECT_THAT(errors, HasSubstr("did you mean 'speed'?"));
  const std::string other =
      errorsOfWorld(cartOf("<robotcontrol:controller name='test_turner'>\n" +
                           parameter("request", "axle/reqest") + "\n" + parameter("goal", "ball") + "\n" +
                           parameter("eyes", "axle/position nothing") + "</robotcontrol:controller>"));
  EXPECT_THAT(other, AllOf(HasSubstr("there is no actuator 'axle/reqest'"),
                           HasSubstr("there is no model 'ball'"), HasSubstr("there is no sensor 'nothing'")));
  EXPECT_THAT(errorsOfWorld(cartOf(turner(parameter("speed", "fast")))),
              HasSubstr("must be one finite number, not 'fast'"));
  EXPECT_THAT(errorsOfWorld(cartOf(turner(parameter("speed", "9")))), HasSubstr("between -5 and 5, not 9"));
  EXPECT_THAT(errorsOfWorld(cartOf(turner(parameter("speed", "1") + parameter("speed", "2")))),
              HasSubstr("given twice"));
  EXPECT_THAT(errorsOfWorld(cartOf("<robotcontrol:controller name='test_turner'/>")),
              HasSubstr("needs the parameter 'request'"));
  EXPECT_THAT(errorsOfWorld(cartOf(turner() + turner())), HasSubstr("there is another controller"));
}

TEST(ControllersTest, registrationsThatAreIncompleteAreRefused) {
  EXPECT_NE(controllerKind("elevator"), nullptr);
  EXPECT_EQ(controllerKind("no such"), nullptr);
  EXPECT_TRUE(std::ranges::is_sorted(controllerKinds(), {}, &ControllerKind::name));
}

}  // namespace
}  // namespace simcore
