// SPDX-License-Identifier: GPL-3.0-or-later
// A solution of the task "ball-model": the mean of the last percepts, with a parameter, a drawing and a plot.
#include <algorithm>
#include <deque>

#include "MeanBallParameters.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/base/Plugin.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace {

const robotlink::RobotDrawingKey kMeanKey{"ball-model/mean-ball",
                                          "The mean of the last percepts (drawn around the robot)"};
const robotlink::PlotKey kCountKey{"ball-model/mean-count", "How many percepts are averaged"};

class MeanBall final : public robotlink::Solution {
 public:
  explicit MeanBall(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        parameters_(context.parameters<example::MeanBallParameters>()),
        percept_(context.input(robotlink::kBallPercept)),
        model_(context.output(robotlink::kBallModel)) {}

  void execute() override {
    if (!percept_ || !percept_.isNew()) return;
    if (percept_->seen()) places_.push_back(robotlink::vector2(percept_->position_in_robot()));
    const auto count = static_cast<std::size_t>(std::max(parameters_.percepts(), 1));
    while (places_.size() > count) places_.pop_front();
    auto model = std::make_shared<robotcontrol::BallModel>();
    *model->mutable_timestamp() = percept_->timestamp();
    model->set_known(!places_.empty());
    if (!places_.empty()) {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (const Eigen::Vector2d& place : places_) sum += place;
      const Eigen::Vector2d mean = sum / static_cast<double>(places_.size());
      robotlink::assign(*model->mutable_position_in_robot(), mean);
      if (debug_.on(kMeanKey)) debug_.robotDrawing(kMeanKey).circle(mean, 0.05, robotlink::colors::kOrange);
    }
    if (debug_.on(kCountKey)) debug_.plot(kCountKey, static_cast<double>(places_.size()));
    model_.send(std::move(model));
  }

 private:
  robotlink::DebugContext& debug_;
  /// Follows the changes that users make.
  const example::MeanBallParameters& parameters_;
  robotlink::Input<robotcontrol::BallPercept> percept_;
  robotlink::Output<robotcontrol::BallModel> model_;
  std::deque<Eigen::Vector2d> places_;
};

}  // namespace

ROBOTCONTROL_PLUGIN("mean-ball", "1.0", "Adds the solution 'mean' of the task ball-model.") {
  robotlink::SolutionRegistration(
      robotlink::SolutionBuilder<MeanBall>("ball-model", "mean", "Averages the places of the last percepts.")
          .needs(robotlink::kBallPercept)
          .yields(robotlink::kBallModel)
          .keys({&kMeanKey, &kCountKey})
          .parameters<example::MeanBallParameters>());
}
