// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionWriter.h"

#include <charconv>

#include "robotlink/base/Geometry.h"

namespace robotlink {
namespace {

/// The shortest text that is exact to a thousandth of a unit; servos are far less precise.
std::string shortText(double value) {
  const double rounded = std::round(value * 1e6) / 1e6;
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, rounded == 0 ? 0.0 : rounded).ptr;
  return {buffer, end};
}

/// Writes the statements of one file in its units.
class MotionText {
 public:
  explicit MotionText(const MotionFile& motion) : motion_(motion) {}

  std::string operator()(const MotionRemark&) const { return {}; }
  std::string operator()(const MotionLabel& label) const { return "label " + label.name; }
  std::string operator()(const MotionTransition& t) const {
    return "transition " + t.request + " " + t.motion + " " + t.label;
  }
  std::string operator()(const KeyFrame& frame) const {
    std::string text;
    for (const JointValue& value : frame.joints) text += writeValue(motion_, value) + " ";
    return text + std::to_string(frame.interpolation) + " " + writeDuration(motion_, frame.duration);
  }
  std::string operator()(const MotionHardness& hardness) const {
    std::string text = "hardness ";
    for (const auto& share : hardness.shares) text += (share ? shortText(*share * 100) : "*") + " ";
    return text + writeDuration(motion_, hardness.duration);
  }

 private:
  const MotionFile& motion_;
};

std::string header(const MotionFile& motion) {
  std::string text = "motion_id = " + motion.name + "\n";
  if (motion.hasJointHeader) {
    text += "joints =";
    for (const std::string& joint : motion.joints) text += " " + joint;
    text += "\n";
  }
  if (motion.angleUnit == MotionFile::AngleUnit::kMilliradians) text += "units = mrad\n";
  if (motion.timeUnit == MotionFile::TimeUnit::kTicks) text += "time = ticks\n";
  if (motion.begin == MotionFile::Begin::kWalk) text += "begin = walk\n";
  if (motion.odometry != Pose2()) {
    const Pose2& odometry = motion.odometry;
    text += "odometry = " + shortText(odometry.x * 1000) + " " + shortText(odometry.y * 1000) + " " +
            shortText(degrees(odometry.heading)) + "\n";
  }
  return text;
}

}  // namespace

std::string writeValue(const MotionFile& motion, const JointValue& value) {
  if (value.kind == JointValue::Kind::kKeep) return "*";
  if (value.kind == JointValue::Kind::kRelease) return "-";
  const bool inDegrees = motion.angleUnit == MotionFile::AngleUnit::kDegrees;
  return shortText(inDegrees ? degrees(value.angle) : value.angle * 1000);
}

std::string writeDuration(const MotionFile& motion, Duration duration) {
  const bool inTicks = motion.timeUnit == MotionFile::TimeUnit::kTicks;
  return std::to_string(duration / (inTicks ? kMotionTick : std::chrono::milliseconds(1)));
}

std::string writeStatement(const MotionFile& motion, const MotionStatement& statement) {
  return std::visit(MotionText(motion), statement);
}

std::string writeMotion(const MotionFile& motion) {
  std::string text = header(motion);
  for (const MotionLine& line : motion.lines) {
    std::string row = writeStatement(motion, line.statement);
    if (!line.comment.empty()) row += (row.empty() ? "" : " ") + line.comment;
    text += row + "\n";
  }
  return text;
}

}  // namespace robotlink
