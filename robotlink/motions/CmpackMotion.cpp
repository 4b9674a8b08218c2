// SPDX-License-Identifier: GPL-3.0-or-later
// readCmpackMotion() of MotionImport.h.
#include <algorithm>
#include <array>
#include <cmath>

#include "robotlink/base/bytes/LittleEndian.h"
#include "robotlink/motions/ImportedMotion.h"
#include "robotlink/motions/LegKinematics.h"
#include "robotlink/motions/MotionImport.h"
#include "robotlink/motions/MotionReader.h"

namespace robotlink {
namespace {

// A record is the body's place and rotation (6 doubles), four legs and the head, a time in ms and a reserved
// word. A leg or the head is its attributes, a reserved word, a point in mm (3 doubles) and 3 angles.
constexpr std::size_t kCountBytes = 4, kBodyBytes = 48, kLimbBytes = 56;
constexpr std::size_t kRecordBytes = kBodyBytes + 5 * kLimbBytes + 8;
constexpr int kMaxCmpackFrames = 63;
constexpr std::int32_t kHasAngles = 1, kHasPoint = 2;
constexpr int kMaxTimeMs = 1'000'000;

const std::vector<std::string> kCmpackJoints{"legFL1", "legFL2", "legFL3",   "legFR1",  "legFR2",
                                             "legFR3", "legHL1", "legHL2",   "legHL3",  "legHR1",
                                             "legHR2", "legHR3", "neckTilt", "headPan", "headRoll"};
constexpr std::array<const char*, 4> kPaws{"left fore paw", "right fore paw", "left hind paw",
                                           "right hind paw"};

/// The dimensions that the team computed with: its paws end at the ground, not at the center of a sphere.
RobotDimensions cmpackDimensions() {
  RobotDimensions dimensions;
  dimensions.pawOffset = 0.0005;
  dimensions.foreShank = std::hypot(0.01888, 0.06600);
  dimensions.foreShankAngle = std::atan2(-0.01888, 0.06600);
  dimensions.hindShank = std::hypot(0.02936, 0.07088);
  dimensions.hindShankAngle = std::atan2(-0.02936, 0.07088);
  return dimensions;
}

struct Limb {
  std::int32_t attributes = 0;
  Vector3 point;  // m
  std::array<double, 3> angles{};
};

/// Reads one record.
class CmpackRecord {
 public:
  explicit CmpackRecord(const std::uint8_t* bytes) : bytes_(bytes) {}

  Vector3 bodyPlace() const { return vector(0) / 1000; }
  Vector3 bodyRotation() const { return vector(24); }
  Limb limb(std::size_t number) const {
    const std::size_t at = kBodyBytes + number * kLimbBytes;
    const Vector3 angles = vector(at + 32);
    return {
        loadNumber<std::int32_t>(bytes_ + at), vector(at + 8) / 1000, {angles.x(), angles.y(), angles.z()}};
  }
  std::int32_t timeMs() const { return loadNumber<std::int32_t>(bytes_ + kRecordBytes - 8); }

 private:
  Vector3 vector(std::size_t at) const {
    return {loadNumber<double>(bytes_ + at), loadNumber<double>(bytes_ + at + 8),
            loadNumber<double>(bytes_ + at + 16)};
  }
  const std::uint8_t* bytes_;
};

class CmpackReader {
 public:
  explicit CmpackReader(const std::string& path)
      : path_(path), motion_(beginImport(path, kCmpackJoints, MotionFile::TimeUnit::kMilliseconds)) {}

  tl::expected<MotionFile, Errors> read(std::string_view bytes) {
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    if (bytes.size() < kCountBytes) return refused("the file is shorter than the number of its key frames");
    const auto count = loadNumber<std::int32_t>(data);
    if (count < 1 || count > kMaxCmpackFrames)
      return refused("this is not a motion of CMPack'02: those have 1 to 63 key frames, this one " +
                     std::to_string(count));
    const std::size_t expected = kCountBytes + static_cast<std::size_t>(count) * kRecordBytes;
    if (bytes.size() != expected)
      return refused(std::to_string(count) + " key frames need " + std::to_string(expected) +
                     " bytes, but the file has " + std::to_string(bytes.size()));
    for (frame_ = 1; frame_ <= count; ++frame_)
      readFrame(CmpackRecord(data + kCountBytes + static_cast<std::size_t>(frame_ - 1) * kRecordBytes));
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    finishImport(motion_);
    return std::move(motion_);
  }

 private:
  tl::unexpected<Errors> refused(std::string text) {
    return tl::unexpected(Errors{{"motion.bad-file", std::move(text), {}, {path_, 0, 0}}});
  }
  void fail(const char* id, const std::string& text) {
    errors_.push_back({id, "key frame " + std::to_string(frame_) + ": " + text, {}, {path_, 0, 0}});
  }

  void readFrame(const CmpackRecord& record) {
    KeyFrame frame;
    std::string remark;
    for (std::size_t leg = 0; leg < kLegs.size(); ++leg) addLeg(frame, record, kLegs[leg], remark);
    const Limb head = record.limb(kLegs.size());
    if ((head.attributes & kHasAngles) != 0) {
      addAngles(frame, head.angles);
    } else {
      frame.joints.resize(frame.joints.size() + 3);
      if ((head.attributes & kHasPoint) != 0) remark += "; the head looks at a point, which is left out";
    }
    if (record.timeMs() > kMaxTimeMs) fail("motion.bad-duration", "it lasts longer than 1000 s");
    // A key frame lasts at least 1 ms, as in the original.
    frame.duration = std::chrono::milliseconds(std::clamp(record.timeMs(), 1, kMaxTimeMs));
    motion_.lines.push_back({std::move(frame), remark.empty() ? "" : "//" + remark.substr(1), 0});
  }

  void addLeg(KeyFrame& frame, const CmpackRecord& record, Leg leg, std::string& remark) {
    const Limb limb = record.limb(index(leg));
    if ((limb.attributes & kHasAngles) != 0) return addAngles(frame, limb.angles);
    if ((limb.attributes & kHasPoint) == 0) return frame.joints.resize(frame.joints.size() + 3);
    const Vector3 rotation = record.bodyRotation(), place = record.bodyPlace();
    if (!rotation.allFinite() || !place.allFinite() || !limb.point.allFinite())
      return fail("motion.bad-place",
                  std::string("the place of the ") + kPaws[index(leg)] + " is not a number");
    const Vector3 pawInBody = Eigen::AngleAxisd(-rotation.y(), Vector3::UnitY()) *
                              (Eigen::AngleAxisd(rotation.z(), Vector3::UnitZ()) * (limb.point - place));
    const auto solution = kinematics_.anglesFor(leg, pawInBody - kinematics_.hipInBody(leg));
    if (!solution.reached)
      remark += std::string("; the ") + kPaws[index(leg)] + " cannot reach its place and comes close";
    addAngles(frame, {solution.angles.swing, solution.angles.spread, solution.angles.knee});
  }

  void addAngles(KeyFrame& frame, const std::array<double, 3>& angles) {
    for (const double angle : angles) {
      if (!(std::abs(angle) <= radians(kMaxMotionDegrees)))
        fail("motion.angle-out-of-range", "an angle is beyond -210 to 210 degrees");
      // A tenth of a degree is finer than any servo, and can be read.
      frame.joints.push_back({JointValue::Kind::kAngle, radians(std::round(degrees(angle) * 10) / 10)});
    }
  }

  const std::string path_;
  const LegKinematics kinematics_{cmpackDimensions()};
  MotionFile motion_;
  Errors errors_;
  int frame_ = 0;
};

}  // namespace

tl::expected<MotionFile, Errors> readCmpackMotion(std::string_view bytes, const std::string& path) {
  return CmpackReader(path).read(bytes);
}

}  // namespace robotlink
