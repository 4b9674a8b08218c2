// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/PoseCapture.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/motions/MotionBench.h"

namespace widgets {
namespace {

using JointAngles = std::map<std::string, double>;

/// The angles of a robot at the instant of the timeline, rad.
JointAngles jointAnglesOf(robotlink::Session& session, const std::string& robot,
                          const robotlink::RobotDescription& description, PoseSource source) {
  JointAngles angles;
  const auto time = session.timeline().shown();
  if (source == PoseSource::kMeasured) {
    const auto* states =
        session.store().latestAs<foxglove::JointStates>(robot + '/' + robotlink::kJointStates.name, time);
    if (states == nullptr) return angles;
    for (const auto& joint : states->joints()) {
      if (joint.has_position() && std::isfinite(joint.position())) angles[joint.name()] = joint.position();
    }
    return angles;
  }
  const auto* request =
      session.store().latestAs<robotcontrol::JointRequest>(robot + '/' + robotlink::kJointRequest.name, time);
  if (request == nullptr) return angles;
  const auto count = std::min(static_cast<std::size_t>(request->positions_size()), description.joints.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = request->positions(static_cast<int>(i));
    if (std::isfinite(angle)) angles[description.joints[i].name] = angle;
  }
  return angles;
}

/// A tenth of a degree is finer than any servo, and can be read.
double roundedAngle(double angle) {
  return robotlink::radians(std::round(robotlink::degrees(angle) * 10) / 10);
}

}  // namespace

robotlink::Result<QString> capturePose(ViewContext& context, PoseSource source,
                                       robotlink::Duration duration) {
  MotionBench& bench = motionBench(context);
  bench.tick();
  const auto description = bench.description();
  if (bench.robot().empty() || description == nullptr || description->joints.empty())
    return robotlink::failure("joints.none", bench.robot().empty() ? "there is no robot; open a scene first"
                                                                   : bench.robot() + " has no joints");
  const JointAngles angles = jointAnglesOf(context.session, bench.robot(), *description, source);
  if (angles.empty())
    return robotlink::failure("joints.unknown",
                              bench.robot() + " has not published its angles yet; its package " +
                                  (source == PoseSource::kMeasured ? "joints/states" : "joints/request") +
                                  " must be on, as it is while the view Joints is open");
  if (!(duration >= std::chrono::milliseconds(1) && duration <= std::chrono::seconds(1000)))
    return robotlink::failure("joints.duration", "a key frame takes from 1 ms to 1000 s");
  if (bench.isEmpty()) bench.setDocument(robotlink::newMotion("taught", bench.document().joints()), {}, true);
  robotlink::KeyFrame frame{{}, 1, duration};
  std::size_t known = 0;
  for (const std::string& joint : bench.columns()) {
    const auto found = angles.find(joint);
    known += found == angles.end() ? 0 : 1;
    frame.joints.push_back(found == angles.end() ? robotlink::JointValue{}
                                                 : robotlink::JointValue{robotlink::JointValue::Kind::kAngle,
                                                                         roundedAngle(found->second)});
  }
  if (known == 0)
    return robotlink::failure("joints.columns",
                              "the motion in the editor has no column for any joint of " + bench.robot());
  bench.addFrame(QCoreApplication::translate("PoseCapture", "Capture pose"), frame);
  return QCoreApplication::translate("PoseCapture", "Key frame %1 of %2 added")
      .arg(bench.frame() + 1)
      .arg(QString::fromStdString(bench.motion().name));
}

}  // namespace widgets
