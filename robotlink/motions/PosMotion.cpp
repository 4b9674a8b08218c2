// SPDX-License-Identifier: GPL-3.0-or-later
// readPosMotion() of MotionImport.h.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/motions/ImportedMotion.h"
#include "robotlink/motions/MotionImport.h"
#include "robotlink/motions/MotionReader.h"
#include "robotlink/motions/MotionWords.h"

namespace robotlink {
namespace {

/// The columns after the duration. '?' instead of a head's angle leaves the head to others.
const std::vector<std::string> kPosJoints{"neckTilt", "headPan", "headRoll", "legFR1", "legFR2",
                                          "legFR3",   "legFL1",  "legFL2",   "legFL3", "legHR1",
                                          "legHR2",   "legHR3",  "legHL1",   "legHL2", "legHL3"};
constexpr std::size_t kHeadColumns = 3;
constexpr double kMaxPosFrames = 1e6;

class PosReader {
 public:
  explicit PosReader(const std::string& path)
      : path_(path), motion_(beginImport(path, kPosJoints, MotionFile::TimeUnit::kTicks)) {}

  tl::expected<MotionFile, Errors> read(std::string_view text) {
    for (const std::string_view row : motionRows(text)) {
      if (++line_ > kMaxMotionLines) {
        fail(1, "motion.too-many-lines",
             "a motion has at most " + std::to_string(kMaxMotionLines) + " lines");
        break;
      }
      readRow(row);
    }
    if (!announced_) {
      line_ = 1;
      fail(1, "motion.no-count", "the first line must be the number of key frames");
    } else if (errors_.empty() && *announced_ != frames_) {
      line_ = countLine_;
      fail(1, "motion.wrong-count",
           std::to_string(*announced_) + " key frames are announced, but there are " +
               std::to_string(frames_));
    }
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    finishImport(motion_);
    return std::move(motion_);
  }

 private:
  void fail(int column, const char* id, std::string text) {
    errors_.push_back({id, std::move(text), {}, {path_, line_, column}});
  }

  void readRow(std::string_view row) {
    if (const auto first = row.find_first_not_of(" \t\r"); first != row.npos && row[first] == '#') {
      std::string_view remark = row.substr(first + 1);
      while (!remark.empty() && (remark.back() == '\r' || remark.back() == ' ')) remark.remove_suffix(1);
      motion_.lines.push_back({MotionRemark{}, "//" + std::string(remark), 0});
      return;
    }
    const auto words = motionWords(row);
    if (words.empty()) return;
    if (!announced_)
      readCount(words);
    else
      readFrame(words);
  }

  void readCount(const std::vector<MotionWord>& words) {
    const auto count = parsedNumber<int>(words[0].text);
    countLine_ = line_;
    announced_ = count.value_or(0);
    if (words.size() != 1 || !count || *count < 1 || *count > kMaxMotionLines)
      fail(words[0].column, "motion.no-count",
           "expected the number of key frames, from 1 to " + std::to_string(kMaxMotionLines));
  }

  void readFrame(const std::vector<MotionWord>& words) {
    ++frames_;
    if (words.size() != kPosJoints.size() + 1) {
      fail(words[std::min(words.size() - 1, kPosJoints.size() + 1)].column, "motion.wrong-count",
           "expected the duration and " + std::to_string(kPosJoints.size()) + " angles, found " +
               std::to_string(words.size()) + " values");
      return;
    }
    // The original jumps to each pose and stays there; the servos are as slow as they are.
    KeyFrame frame{{}, 0, durationOf(words[0])};
    for (std::size_t i = 1; i < words.size(); ++i) frame.joints.push_back(valueOf(words[i], i));
    motion_.lines.push_back({std::move(frame), {}, 0});
  }

  Duration durationOf(const MotionWord& word) {
    const auto frames = parsedNumberWithSign<double>(word.text);
    if (frames && *frames >= 1 && *frames <= kMaxPosFrames && *frames == std::floor(*frames))
      return static_cast<Duration::rep>(*frames) * kMotionTick;
    fail(word.column, "motion.bad-duration",
         "a duration is a whole number of frames of 8 ms from 1 to 1000000, not '" + std::string(word.text) +
             "'");
    return kMotionTick;
  }

  JointValue valueOf(const MotionWord& word, std::size_t column) {
    if (word.text == "?" && column <= kHeadColumns) return {};
    const auto angle = parsedNumberWithSign<double>(word.text);
    if (!angle || !(std::abs(*angle) <= kMaxMotionDegrees)) {
      fail(word.column, "motion.bad-angle",
           "'" + std::string(word.text) + "' is not an angle from -210 to 210 degrees");
      return {};
    }
    return {JointValue::Kind::kAngle, radians(*angle)};
  }

  const std::string path_;
  MotionFile motion_;
  Errors errors_;
  int line_ = 0, countLine_ = 1;
  std::optional<int> announced_;
  int frames_ = 0;
};

}  // namespace

tl::expected<MotionFile, Errors> readPosMotion(std::string_view text, const std::string& path) {
  return PosReader(path).read(text);
}

}  // namespace robotlink
