// SPDX-License-Identifier: GPL-3.0-or-later
// The controller "ball_replacer": puts a model back that has left an area or fallen off it, as a referee
// does.
#include <sstream>
#include <stdexcept>

#include "simcore/control/ControllerSetup.h"

namespace simcore {
namespace {

class BallReplacer final : public Controller {
 public:
  explicit BallReplacer(ControllerSetup& setup)
      : ball_(setup.text("model")),
        area_(setup.numbers("area")),
        place_(setup.numbers("place")),
        height_(setup.number("height")),
        patience_(setup.number("patience")),
        key_(setup.text("key")),
        count_(setup.addValues("count", "count")),
        outside_(setup.addValues("outside", "duration", {}, "s", 0, patience_)) {
    if (area_.size() != 4 || area_[0] >= area_[2] || area_[1] >= area_[3])
      throw std::runtime_error("the area consists of smallest x and y, and largest x and y");
    if (place_.size() != 2) throw std::runtime_error("the place consists of x and y");
  }

  void step(ControlledWorld& world) override {
    const auto pose = world.modelPose(ball_);
    if (!pose) throw std::runtime_error("there is no model '" + ball_ + "'");
    const auto& at = pose->translation();
    const bool isInside =
        at.x() >= area_[0] && at.y() >= area_[1] && at.x() <= area_[2] && at.y() <= area_[3] && at.z() >= -1;
    if (isInside) leftAt_ = world.time();
    outside_.values[0] = world.time() - leftAt_;
    bool wanted = outside_.values[0] > patience_;
    for (const ViewEvent& event : world.events())
      wanted |= event.kind == ViewEvent::Kind::kKeyPressed && event.key == key_;
    // If something is in the way, the next step tries again.
    if (!wanted || !world.place(ball_, {place_[0], place_[1], 0}, height_)) return;
    leftAt_ = world.time();
    outside_.values[0] = 0;
    ++replaced_;
    count_.values[0] = static_cast<double>(replaced_);
  }

  std::string state() const override {
    std::ostringstream stream;
    stream.precision(17);
    stream << leftAt_ << ' ' << replaced_;
    return stream.str();
  }

  void restore(std::string_view state) override {
    std::istringstream stream{std::string(state)};
    stream >> leftAt_ >> replaced_;
    count_.values[0] = static_cast<double>(replaced_);
  }

 private:
  const std::string ball_;
  const std::vector<double> area_, place_;
  const double height_, patience_;
  const std::string key_;
  /// s
  double leftAt_ = 0;
  std::uint64_t replaced_ = 0;
  ControllerOutput &count_, &outside_;
};

using ReplacerParameter = ControllerParameter;

const ControllerRegistration kBallReplacer{ControllerKind{
    "ball_replacer",
    "Puts a model, such as the ball, back in its place when it has been outside an area for a while.",
    {{"model", ReplacerParameter::Type::kModel, "the model that is put back", "", true},
     {"area", ReplacerParameter::Type::kNumbers, "smallest x and y, largest x and y, m", "", true, -1e4, 1e4},
     {"place", ReplacerParameter::Type::kNumbers, "where it is put: x and y, m", "0 0", false, -1e4, 1e4},
     {"height", ReplacerParameter::Type::kNumber, "height of the model's frame there, m", "0.1", false, -1e3,
      1e3},
     {"patience", ReplacerParameter::Type::kNumber, "how long it may be outside, s", "1", false, 0, 3600},
     {"key", ReplacerParameter::Type::kText, "a key in the Scene view that puts it back at once", "P"}},
    [](ControllerSetup& setup) { return std::make_unique<BallReplacer>(setup); }}};

}  // namespace
}  // namespace simcore
