// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/motions/MotionText.h"

#include <charconv>

#include "robotlink/base/Geometry.h"

namespace robotlink {
namespace {

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
    for (const JointValue& value : frame.joints) text += column(value) + " ";
    return text + std::to_string(frame.interpolation) + " " + time(frame.duration);
  }
  std::string operator()(const MotionHardness& hardness) const {
    std::string text = "hardness ";
    for (const auto& share : hardness.shares) text += (share ? number(*share * 100) : "*") + " ";
    return text + time(hardness.duration);
  }

 private:
  static std::string number(double value) {
    // The shortest text that is exact to a thousandth of a unit; servos are far less precise.
    const double rounded = std::round(value * 1e6) / 1e6;
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, rounded == 0 ? 0.0 : rounded).ptr;
    return {buffer, end};
  }
  std::string time(Duration duration) const {
    const auto unit =
        motion_.timeUnit == MotionFile::TimeUnit::kTicks ? kMotionTick : std::chrono::milliseconds(1);
    return std::to_string(duration / unit);
  }
  std::string column(const JointValue& value) const {
    if (value.kind == JointValue::Kind::kKeep) return "*";
    if (value.kind == JointValue::Kind::kRelease) return "-";
    return number(motion_.angleUnit == MotionFile::AngleUnit::kDegrees ? degrees(value.angle)
                                                                       : value.angle * 1000);
  }

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
  return text;
}

}  // namespace

std::string writeMotion(const MotionFile& motion) {
  std::string text = header(motion);
  const MotionText statements(motion);
  for (const MotionLine& line : motion.lines) {
    std::string row = std::visit(statements, line.statement);
    if (!line.comment.empty()) row += (row.empty() ? "" : " ") + line.comment;
    text += row + "\n";
  }
  return text;
}

}  // namespace robotlink
