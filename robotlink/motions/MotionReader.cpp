// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionReader.h"

#include <algorithm>
#include <array>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/TextParts.h"
#include "robotlink/motions/MotionWords.h"

namespace robotlink {
namespace {

constexpr double kMaxOdometryMillimeters = 1000, kMaxOdometryDegrees = 180;

constexpr std::string_view kBlanks(" \t\r\f\v\0", 6);

bool isName(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

std::optional<double> number(std::string_view text) {
  const auto value = parsedNumberWithSign<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

class Reader {
 public:
  Reader(const std::string& path, const std::vector<std::string>& joints) {
    motion_.path = path;
    motion_.joints = joints;
    columns_ = joints.size();
  }

  MotionParse read(std::string_view text) {
    int labels = 0;
    while (!text.empty()) {
      if (++line_ > kMaxMotionLines) {
        fail(1, "motion.too-many-lines",
             "a motion has at most " + std::to_string(kMaxMotionLines) + " lines");
        break;
      }
      readLine(takeLine(text));
      if (!motion_.lines.empty() && std::holds_alternative<MotionLabel>(motion_.lines.back().statement) &&
          motion_.lines.back().number == line_ && ++labels > kMaxMotionLabels) {
        fail(1, "motion.too-many-labels",
             "a motion has at most " + std::to_string(kMaxMotionLabels) + " labels");
        break;
      }
    }
    if (motion_.name.empty() && errors_.empty()) {
      line_ = 1;
      fail(1, "motion.no-name", "the first line must be 'motion_id = NAME'");
    }
    return {std::move(motion_), std::move(errors_)};
  }

 private:
  void fail(int column, const char* id, std::string text) {
    errors_.push_back({id, std::move(text), {}, {motion_.path, line_, column}});
  }

  void readLine(std::string_view row) {
    const std::vector<MotionWord> words = motionWords(row);
    std::string_view remark = row.substr(motionCommentStart(row));
    while (!remark.empty() && kBlanks.find(remark.back()) != std::string_view::npos) remark.remove_suffix(1);

    if (words.size() >= 2 && words[1].text == "=") {
      readHeader(words);
    } else if (auto statement = readStatement(words)) {
      motion_.lines.push_back({std::move(*statement), std::string(remark), line_});
    }
  }

  void readHeader(const std::vector<MotionWord>& words) {
    const std::string_view key = words[0].text;
    const bool single = words.size() == 3;
    if (key == "joints") {
      readJoints(words);
    } else if (key == "motion_id" && single) {
      readName(words[2]);
    } else if (key == "units" && single && (words[2].text == "deg" || words[2].text == "mrad")) {
      motion_.angleUnit =
          words[2].text == "deg" ? MotionFile::AngleUnit::kDegrees : MotionFile::AngleUnit::kMilliradians;
    } else if (key == "time" && single && (words[2].text == "ms" || words[2].text == "ticks")) {
      motion_.timeUnit =
          words[2].text == "ms" ? MotionFile::TimeUnit::kMilliseconds : MotionFile::TimeUnit::kTicks;
    } else if (key == "begin" && single && (words[2].text == "stand" || words[2].text == "walk")) {
      motion_.begin = words[2].text == "walk" ? MotionFile::Begin::kWalk : MotionFile::Begin::kStand;
    } else if (key == "odometry" && words.size() == 5) {
      readOdometry(words);
    } else {
      fail(words[0].column, "motion.bad-header",
           "expected 'motion_id = NAME', 'joints = NAME...', 'units = deg|mrad', 'time = ms|ticks', "
           "'begin = stand|walk' or 'odometry = AHEAD LEFT TURN'");
    }
    if (columnsUsed_ && key != "motion_id") {
      fail(words[0].column, "motion.late-header",
           "'" + std::string(key) + "' must come before the first data line");
    }
  }

  void readName(const MotionWord& word) {
    if (!isName(word.text)) {
      fail(word.column, "motion.bad-name", "a motion's name consists of letters, digits, '_' and '-'");
    } else if (!motion_.name.empty()) {
      fail(word.column, "motion.second-name", "the motion already has the name '" + motion_.name + "'");
    } else {
      motion_.name = word.text;
    }
  }

  /// Millimeters ahead and to the left, degrees counterclockwise.
  void readOdometry(const std::vector<MotionWord>& words) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const MotionWord& word = words[i + 2];
      const auto value = number(word.text);
      if (!value || std::abs(*value) > (i < 2 ? kMaxOdometryMillimeters : kMaxOdometryDegrees)) {
        fail(
            word.column, "motion.bad-odometry",
            "'" + std::string(word.text) + "' is not " +
                (i < 2 ? "a number of millimeters from -1000 to 1000" : "an angle from -180 to 180 degrees"));
        return;
      }
      values[i] = *value;
    }
    motion_.odometry = {values[0] / 1000, values[1] / 1000, radians(values[2])};
  }

  void readJoints(const std::vector<MotionWord>& words) {
    motion_.joints.clear();
    motion_.hasJointHeader = true;
    motion_.jointHeaderLine = line_;
    for (std::size_t i = 2; i < words.size(); ++i) {
      const std::string name(words[i].text);
      if (std::count(motion_.joints.begin(), motion_.joints.end(), name) > 0) {
        fail(words[i].column, "motion.duplicate-joint", "the joint '" + name + "' has two columns");
      }
      motion_.joints.push_back(name);
    }
    if (motion_.joints.empty())
      fail(words[0].column, "motion.no-joints", "'joints =' must name at least one joint");
    columns_ = motion_.joints.size();
  }

  std::optional<MotionStatement> readStatement(const std::vector<MotionWord>& words) {
    if (words.empty()) return MotionRemark{};
    const std::string_view key = words[0].text;
    if (key == "label") return readLabel(words);
    if (key == "transition") return readTransition(words);
    if (key == "hardness") return readHardness(words);
    if (key == "*" || key == "~" || key == "-" || number(key)) return readKeyFrame(words);
    fail(words[0].column, "motion.unknown-line",
         "'" + std::string(key) +
             "' cannot begin a line of a motion; expected label, transition, hardness or angles");
    return std::nullopt;
  }

  bool checkNames(const std::vector<MotionWord>& words, std::size_t count, const char* usage) {
    if (words.size() != count + 1) {
      const MotionWord& at = words[std::min(words.size() - 1, count)];
      fail(at.column, "motion.wrong-count", std::string("expected '") + usage + "'");
      return false;
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (isName(words[i].text)) continue;
      fail(words[i].column, "motion.bad-name", "a name consists of letters, digits, '_' and '-'");
      return false;
    }
    return true;
  }

  std::optional<MotionStatement> readLabel(const std::vector<MotionWord>& words) {
    if (!checkNames(words, 1, "label NAME")) return std::nullopt;
    return MotionLabel{std::string(words[1].text)};
  }

  std::optional<MotionStatement> readTransition(const std::vector<MotionWord>& words) {
    if (!checkNames(words, 3, "transition REQUEST MOTION LABEL")) return std::nullopt;
    return MotionTransition{std::string(words[1].text), std::string(words[2].text),
                            std::string(words[3].text)};
  }

  /// Whether a line has one value per joint and `more` numbers after them.
  bool checkColumns(const std::vector<MotionWord>& words, std::size_t first, std::size_t more) {
    const std::size_t values = words.size() < first + more ? 0 : words.size() - first - more;
    if (columns_ == 0) columns_ = values;
    columnsUsed_ = true;
    if (values == columns_ && values > 0) return true;
    fail(words[std::min(first + columns_, words.size() - 1)].column, "motion.wrong-count",
         "expected " + std::to_string(columns_) + " joints and " + std::to_string(more) + " more " +
             (more == 1 ? "number" : "numbers") + ", found " + std::to_string(words.size() - first) +
             " values");
    return false;
  }

  std::optional<Duration> readDuration(const MotionWord& word, double minimum) {
    const auto value = number(word.text);
    const bool ticks = motion_.timeUnit == MotionFile::TimeUnit::kTicks;
    if (!value || *value < minimum || *value > 1e6 || *value != std::floor(*value)) {
      fail(word.column, "motion.bad-duration",
           std::string("a duration is a whole number of ") + (ticks ? "ticks" : "milliseconds") + " from " +
               std::to_string(static_cast<int>(minimum)) + " to 1000000, not '" + std::string(word.text) +
               "'");
      return std::nullopt;
    }
    return static_cast<Duration::rep>(*value) *
           (ticks ? kMotionTick : Duration(std::chrono::milliseconds(1)));
  }

  std::optional<MotionStatement> readHardness(const std::vector<MotionWord>& words) {
    if (!checkColumns(words, 1, 1)) return std::nullopt;
    MotionHardness hardness;
    for (std::size_t i = 1; i + 1 < words.size(); ++i) {
      const auto value = number(words[i].text);
      if (words[i].text == "*" || words[i].text == "~") {
        hardness.shares.emplace_back();
      } else if (value && *value >= 0 && *value <= 100) {
        hardness.shares.emplace_back(*value / 100);
      } else {
        fail(words[i].column, "motion.bad-hardness", "a hardness is '*' or a number from 0 to 100 percent");
        return std::nullopt;
      }
    }
    const auto duration = readDuration(words.back(), 0);
    if (!duration) return std::nullopt;
    hardness.duration = *duration;
    return hardness;
  }

  std::optional<JointValue> readAngle(const MotionWord& word) {
    if (word.text == "*" || word.text == "~") return JointValue{};
    if (word.text == "-") return JointValue{JointValue::Kind::kRelease, 0};
    const auto value = number(word.text);
    if (!value) {
      fail(word.column, "motion.bad-angle",
           "'" + std::string(word.text) + "' is neither an angle nor '*', '~' or '-'");
      return std::nullopt;
    }
    const bool inDegrees = motion_.angleUnit == MotionFile::AngleUnit::kDegrees;
    const double angle = inDegrees ? radians(*value) : *value / 1000;
    if (std::abs(angle) > radians(kMaxMotionDegrees) + 1e-9) {
      fail(word.column, "motion.angle-out-of-range",
           "the angle " + std::string(word.text) + " is beyond -210 to 210 degrees");
      return std::nullopt;
    }
    return JointValue{JointValue::Kind::kAngle, angle};
  }

  std::optional<MotionStatement> readKeyFrame(const std::vector<MotionWord>& words) {
    if (!checkColumns(words, 0, 2)) return std::nullopt;
    KeyFrame frame;
    for (std::size_t i = 0; i + 2 < words.size(); ++i) {
      const auto value = readAngle(words[i]);
      if (!value) return std::nullopt;
      frame.joints.push_back(*value);
    }
    const MotionWord& flag = words[words.size() - 2];
    if (flag.text.size() != 1 || flag.text[0] < '0' || flag.text[0] > '3') {
      fail(flag.column, "motion.bad-interpolation",
           "the interpolation is 0, 1, 2 or 3, not '" + std::string(flag.text) + "'");
      return std::nullopt;
    }
    frame.interpolation = flag.text[0] - '0';
    const auto duration = readDuration(words.back(), 1);
    if (!duration) return std::nullopt;
    frame.duration = *duration;
    return frame;
  }

  MotionFile motion_;
  Errors errors_;
  int line_ = 0;
  std::size_t columns_ = 0;
  bool columnsUsed_ = false;
};

}  // namespace

MotionParse parseMotion(std::string_view text, const std::string& path,
                        const std::vector<std::string>& joints) {
  return Reader(path, joints).read(text);
}

tl::expected<MotionFile, Errors> readMotion(std::string_view text, const std::string& path,
                                            const std::vector<std::string>& joints) {
  MotionParse parse = parseMotion(text, path, joints);
  if (!parse.errors.empty()) return tl::unexpected(std::move(parse.errors));
  return std::move(parse.motion);
}

tl::expected<MotionFile, Errors> readMotionFile(const std::filesystem::path& file,
                                                const std::vector<std::string>& joints) {
  const auto text = readFile(file);
  if (!text) {
    return tl::unexpected(Errors{{"motion.unreadable",
                                  "the file cannot be read; check its name and permissions",
                                  {},
                                  {file.string(), 0, 0}}});
  }
  return readMotion(*text, file.string(), joints);
}

}  // namespace robotlink
