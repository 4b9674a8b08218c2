// SPDX-License-Identifier: GPL-3.0-or-later
// A controller of scenes: drives a guided model (<robotcontrol:guided kind="omni">) around a list of points.
#include <cmath>
#include <stdexcept>

#include "robotlink/base/Plugin.h"
#include "simcore/control/ControllerSetup.h"

namespace {

using simcore::ControllerParameter;
using simcore::DrawnShape;

class Patrol final : public simcore::Controller {
 public:
  explicit Patrol(simcore::ControllerSetup& setup)
      : model_(setup.model()),
        motion_(setup.port("motion")),
        speed_(setup.number("speed")),
        points_(setup.numbers("points")),
        goal_(setup.addValues("goal", "count")),
        distance_(setup.addValues("distance", "distance", {}, "m")),
        route_(setup.addDrawing("route")) {
    if (model_.empty()) throw std::runtime_error("it controls a model: put it into one");
    if (points_.size() < 4 || points_.size() % 2 != 0)
      throw std::runtime_error("points are pairs of x and y");
    DrawnShape line;
    for (std::size_t i = 0; i + 1 < points_.size(); i += 2)
      line.points.emplace_back(points_[i], points_[i + 1], 0.02);
    line.points.push_back(line.points.front());
    route_.shapes.push_back(line);
  }

  void step(simcore::ControlledWorld& world) override {
    for (const simcore::ViewEvent& event : world.events())
      if (event.kind == simcore::ViewEvent::Kind::kKeyPressed && event.key == "Space") stands_ = !stands_;
    const auto pose = world.modelPose(model_);
    const auto at = pose->translation();
    const double dx = points_[2 * next_] - at.x(), dy = points_[2 * next_ + 1] - at.y();
    distance_.values[0] = std::hypot(dx, dy);
    if (distance_.values[0] < 0.1) next_ = (next_ + 1) % (points_.size() / 2);
    goal_.values[0] = static_cast<double>(next_);
    // The model is commanded in its own frame.
    const robotlink::Vector3 way = pose->linear().transpose() * robotlink::Vector3(dx, dy, 0);
    const double factor = stands_ ? 0 : speed_ / std::max(0.1, distance_.values[0]);
    world.command(motion_, {factor * way.x(), factor * way.y(), 0});
  }

  std::string state() const override { return std::to_string(next_); }
  void restore(std::string_view state) override {
    const std::size_t next = std::stoul(std::string(state));
    if (next < points_.size() / 2) next_ = next;
  }

 private:
  const std::string model_, motion_;
  const double speed_;
  const std::vector<double> points_;
  simcore::ControllerOutput &goal_, &distance_, &route_;
  std::size_t next_ = 0;
  bool stands_ = false;
};

}  // namespace

ROBOTCONTROL_PLUGIN("patrol", "1.0", "A controller of scenes that drives a model around.") {
  simcore::ControllerRegistration(
      {"patrol",
       "Drives a guided model around points, again and again; Space stops it and lets it go on.",
       {{"motion", ControllerParameter::Type::kActuator, "the model's port of motion", "motion"},
        {"points", ControllerParameter::Type::kNumbers, "x and y of each point, m", "", true, -1000, 1000},
        {"speed", ControllerParameter::Type::kNumber, "m/s", "0.5", false, 0, 10}},
       [](simcore::ControllerSetup& setup) { return std::make_unique<Patrol>(setup); }});
}
