// SPDX-License-Identifier: GPL-3.0-or-later
// The controller "elevator": moves a cabin between floors, called by sensors, clicks and keys.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "simcore/control/ControllerCheck.h"
#include "simcore/control/ControllerSetup.h"

namespace simcore {
namespace {

/// The cabin is at a floor if it is nearer than this, m.
constexpr double kAtFloor = 0.02;
/// A sensor of contact calls from this value on.
constexpr double kCalled = 0.5;
/// The picture of the panel: a square for each floor, with a frame.
constexpr int kSquare = 12, kFrame = 2;
constexpr std::size_t kMaxFloors = 20;

class Elevator final : public Controller {
 public:
  explicit Elevator(ControllerSetup& setup)
      : model_(setup.model()),
        request_(setup.port("request")),
        position_(setup.port("position")),
        sensors_(setup.portsOf("sensors")),
        buttons_(wordsOf(setup.text("buttons"))),
        floors_(setup.numbers("floors")),
        near_(setup.number("near")),
        wait_(setup.number("wait")),
        called_(floors_.size(), false),
        floor_(setup.addValues("floor", "floor", {}, {}, 0, static_cast<double>(floors_.size()) - 1)),
        calls_(setup.addValues("calls", "calls", {static_cast<int>(floors_.size())}, {}, 0, 1)),
        panel_(setup.addImage("panel", kSquare, kSquare * static_cast<int>(floors_.size()))),
        sign_(setup.addDrawing("sign")) {
    if (floors_.empty() || floors_.size() > kMaxFloors) throw std::runtime_error("it has 1 to 20 floors");
    if (sensors_.size() > floors_.size() || buttons_.size() > floors_.size())
      throw std::runtime_error("there are more sensors or buttons than floors");
    for (const std::string& path : sensors_) {
      const Port* port = setup.world().port(path);
      isContact_.push_back(port != nullptr && port->info.type == "contact");
    }
  }

  void step(ControlledWorld& world) override {
    listen(world);
    const double place = world.number(position_);
    const bool isThere = std::abs(place - floors_[target_]) < kAtFloor;
    if (isThere && called_[target_]) {
      called_[target_] = false;
      leavesAt_ = world.time() + wait_;
    }
    if (isThere && world.time() >= leavesAt_) chooseTarget();
    world.command(request_, {floors_[target_]});
    show(world, place);
  }

  std::string state() const override {
    std::ostringstream stream;
    stream.precision(17);
    stream << target_ << ' ' << leavesAt_ << ' ' << up_;
    for (const bool called : called_) stream << ' ' << called;
    return stream.str();
  }

  void restore(std::string_view state) override {
    std::istringstream stream{std::string(state)};
    std::size_t target = 0;
    double leavesAt = 0;
    bool up = true;
    if (!(stream >> target >> leavesAt >> up) || target >= floors_.size()) return;
    target_ = target;
    leavesAt_ = leavesAt;
    up_ = up;
    for (std::size_t i = 0; i < called_.size(); ++i) {
      bool called = false;
      if (stream >> called) called_[i] = called;
    }
  }

 private:
  /// Collects calls from sensors, clicks on buttons, and the keys 1, 2, ...
  void listen(ControlledWorld& world) {
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      const double reading = world.number(sensors_[i]);
      if (isContact_[i] ? reading >= kCalled : reading < near_) called_[i] = true;
    }
    for (const ViewEvent& event : world.events()) {
      if (event.kind == ViewEvent::Kind::kKeyPressed && event.key.size() == 1) {
        const std::size_t number = static_cast<std::size_t>(event.key[0] - '1');
        if (number < called_.size()) called_[number] = true;
      }
      if (event.kind != ViewEvent::Kind::kMousePressed || event.model != model_) continue;
      for (std::size_t i = 0; i < buttons_.size(); ++i)
        if (event.object.ends_with("/" + buttons_[i])) called_[i] = true;
    }
  }

  /// Continues in its direction while there are calls ahead, then turns around.
  void chooseTarget() {
    for (int turn = 0; turn < 2; ++turn, up_ = !up_) {
      const auto next = nextCall();
      if (!next) continue;
      target_ = *next;
      return;
    }
  }

  std::optional<std::size_t> nextCall() const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < floors_.size(); ++i) {
      const double way = (floors_[i] - floors_[target_]) * (up_ ? 1 : -1);
      if (!called_[i] || way < 0) continue;
      if (!best || way < (floors_[*best] - floors_[target_]) * (up_ ? 1 : -1)) best = i;
    }
    return best;
  }

  void show(const ControlledWorld& world, double place) {
    const auto nearest =
        std::ranges::min_element(floors_, {}, [&](double floor) { return std::abs(floor - place); });
    const auto now = static_cast<std::size_t>(nearest - floors_.begin());
    floor_.values[0] = static_cast<double>(now);
    for (std::size_t i = 0; i < called_.size(); ++i) calls_.values[i] = called_[i] ? 1 : 0;
    paintPanel(now);
    sign_.shapes.clear();
    const auto pose = world.modelPose(model_);
    if (!pose) return;
    DrawnShape text;
    text.kind = DrawnShape::Kind::kText;
    text.points = {*pose * robotlink::Vector3(0, 0, place + 0.5)};
    text.size = {0.15, 0.15, 0.15};
    text.text = std::to_string(now + 1) + (target_ == now ? "" : target_ > now ? " up" : " down");
    sign_.shapes.push_back(std::move(text));
  }

  /// The highest floor is the uppermost square: green where the cabin is, yellow where it is called.
  void paintPanel(std::size_t now) {
    for (std::size_t i = 0; i < floors_.size(); ++i) {
      robotlink::Rgb color{60, 60, 60};
      if (called_[i]) color = {230, 200, 40};
      if (i == now) color = {60, 190, 80};
      const int top = kSquare * static_cast<int>(floors_.size() - 1 - i);
      for (int y = kFrame; y < kSquare - kFrame; ++y) {
        for (int x = kFrame; x < kSquare - kFrame; ++x) {
          const auto at = 3 * (static_cast<std::size_t>(top + y) * kSquare + static_cast<std::size_t>(x));
          panel_.image.data[at] = color.r;
          panel_.image.data[at + 1] = color.g;
          panel_.image.data[at + 2] = color.b;
        }
      }
    }
  }

  const std::string model_, request_, position_;
  const std::vector<std::string> sensors_, buttons_;
  /// Keyed by sensor: whether it reads 0 or 1 instead of a distance.
  std::vector<bool> isContact_;
  /// Positions of the joint, m, from the lowest on.
  const std::vector<double> floors_;
  const double near_, wait_;
  // Keyed by floor.
  std::vector<bool> called_;
  std::size_t target_ = 0;
  double leavesAt_ = 0;
  bool up_ = true;
  ControllerOutput &floor_, &calls_, &panel_, &sign_;
};

using ElevatorParameter = ControllerParameter;

const ControllerRegistration kElevator{ControllerKind{
    "elevator",
    "Moves a cabin between floors, to which sensors, "
    "clicks on buttons or the keys 1, 2, ... call it.",
    {{"request", ElevatorParameter::Type::kActuator, "the servo of the cabin's joint", "", true},
     {"position", ElevatorParameter::Type::kSensor, "the position of that joint", "", true},
     {"floors", ElevatorParameter::Type::kNumbers, "positions of the joint, starting with the lowest, m", "",
      true, -1000, 1000},
     {"sensors", ElevatorParameter::Type::kSensors,
      "a sensor for each floor that calls the cabin: a touch or distance sensor"},
     {"near", ElevatorParameter::Type::kNumber,
      "distance sensors call the cabin if they read less than this, m", "1", false, 0, 1000},
     {"buttons", ElevatorParameter::Type::kText,
      "the name of a visual of the model for each floor: a click on it calls the cabin"},
     {"wait", ElevatorParameter::Type::kNumber, "how long it stays at a floor, s", "2", false, 0, 3600}},
    [](ControllerSetup& setup) { return std::make_unique<Elevator>(setup); }}};

}  // namespace
}  // namespace simcore
