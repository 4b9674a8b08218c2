// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionEdits.h"

#include <algorithm>

#include "robotlink/base/TextParts.h"
#include "robotlink/motions/MotionWords.h"
#include "robotlink/motions/MotionWriter.h"

namespace robotlink {
namespace {

/// Columns of new key frames are as wide as "-117.5".
constexpr std::size_t kColumnWidth = 6;

std::vector<std::string> rowsOf(std::string_view text) {
  std::vector<std::string> rows;
  for (const std::string_view row : motionRows(text)) rows.emplace_back(row);
  return rows;
}

/// The index of a line in the rows of a text; none if there is no such line.
std::optional<std::size_t> rowOf(const std::vector<std::string>& rows, int line) {
  const auto index = static_cast<std::size_t>(line - 1);
  return line >= 1 && index < rows.size() ? std::optional(index) : std::nullopt;
}

void replaceWord(std::string& row, std::size_t number, std::string_view to) {
  const auto words = motionWords(row);
  if (number >= words.size()) return;
  auto begin = static_cast<std::size_t>(words[number].column - 1);
  std::size_t length = words[number].text.size();
  std::string put(to);
  if (begin > 0 && put.size() < length) put.insert(0, length - put.size(), ' ');
  // A longer word replaces blanks before it, except one.
  const std::size_t keep = number > 0 ? 1 : 0;
  while (put.size() > length && begin > keep && row[begin - 1] == ' ' &&
         (keep == 0 || row[begin - 2] == ' ')) {
    --begin;
    ++length;
  }
  row.replace(begin, length, put);
}

const MotionLine* lineAt(const MotionFile& motion, int number) {
  const auto found = std::ranges::find(motion.lines, number, &MotionLine::number);
  return found == motion.lines.end() ? nullptr : &*found;
}

/// The number of joints in the key frame of a line; none if there is no key frame.
std::optional<std::size_t> columnsAt(const MotionFile& motion, int line) {
  const MotionLine* found = lineAt(motion, line);
  const auto* frame = found == nullptr ? nullptr : std::get_if<KeyFrame>(&found->statement);
  return frame == nullptr ? std::nullopt : std::optional(frame->joints.size());
}

std::string aligned(const std::string& value) {
  return std::string(value.size() < kColumnWidth ? kColumnWidth - value.size() : 1, ' ') + value;
}

/// "-9" of "9" and the reverse; '*', '~' and '-' and zeros have no sign.
std::string negated(const std::string& word) {
  const bool isNumber = word.find_first_of("123456789") != std::string::npos;
  if (!isNumber) return word;
  if (word.front() == '-') return word.substr(1);
  return "-" + (word.front() == '+' ? word.substr(1) : word);
}

/// For each column of the motion, the column that it takes its values from.
Result<std::vector<std::size_t>> partners(const MotionFile& motion,
                                          const std::vector<MirroredJoint>& mirror) {
  std::vector<std::size_t> from;
  for (const MirroredJoint& joint : mirror) {
    const auto found = std::ranges::find(motion.joints, joint.joint);
    if (found == motion.joints.end())
      return failure(
          "motion.mirror",
          "the motion has no column for " + joint.joint + ", so it cannot be mirrored; add it to 'joints ='",
          {motion.path, 0, 0}, {joint.joint});
    from.push_back(static_cast<std::size_t>(found - motion.joints.begin()));
  }
  return from;
}

/// Mirrors the values of a row, which begin with its word `first`.
void mirrorRow(std::string& row, std::size_t first, const std::vector<std::size_t>& from,
               const std::vector<MirroredJoint>& mirror, bool hasSigns) {
  std::vector<std::string> values;
  for (const MotionWord& word : motionWords(row)) values.emplace_back(word.text);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::string& value = values[first + from[i]];
    replaceWord(row, first + i, hasSigns && mirror[i].isNegated ? negated(value) : value);
  }
}

}  // namespace

std::vector<KeyFramePlace> keyFramesOf(const MotionFile& motion) {
  std::vector<KeyFramePlace> places;
  Duration begin{};
  for (std::size_t i = 0; i < motion.lines.size(); ++i) {
    const auto* frame = std::get_if<KeyFrame>(&motion.lines[i].statement);
    if (frame == nullptr) continue;
    places.push_back({i, motion.lines[i].number, begin});
    begin += frame->duration;
  }
  return places;
}

const KeyFrame& keyFrameAt(const MotionFile& motion, const KeyFramePlace& place) {
  return std::get<KeyFrame>(motion.lines[place.index].statement);
}

std::string newMotion(const std::string& name, const std::vector<std::string>& joints) {
  std::string text = "motion_id = " + name + "\n";
  if (!joints.empty()) {
    text += "joints =";
    for (const std::string& joint : joints) text += " " + joint;
    text += "\n";
  }
  return text + "\nlabel start\n\ntransition allMotions extern start\n";
}

std::string withName(std::string_view text, const std::string& name) {
  std::vector<std::string> rows = rowsOf(text);
  for (std::string& row : rows) {
    const auto words = motionWords(row);
    if (words.size() != 3 || words[0].text != "motion_id" || words[1].text != "=") continue;
    row.replace(static_cast<std::size_t>(words[2].column - 1), words[2].text.size(), name);
    return joined(rows, "\n");
  }
  return "motion_id = " + name + "\n" + std::string(text);
}

std::string withWord(std::string_view text, int line, std::size_t word, std::string_view to) {
  std::vector<std::string> rows = rowsOf(text);
  if (const auto row = rowOf(rows, line)) replaceWord(rows[*row], word, to);
  return joined(rows, "\n");
}

std::string withValue(std::string_view text, const MotionFile& motion, int line, std::size_t column,
                      const JointValue& value) {
  const auto columns = columnsAt(motion, line);
  if (!columns || column >= *columns) return std::string(text);
  return withWord(text, line, column, writeValue(motion, value));
}

std::string withInterpolation(std::string_view text, const MotionFile& motion, int line, int interpolation) {
  const auto columns = columnsAt(motion, line);
  return columns ? withWord(text, line, *columns, std::to_string(std::clamp(interpolation, 0, 3)))
                 : std::string(text);
}

std::string withDuration(std::string_view text, const MotionFile& motion, int line, Duration duration) {
  const auto columns = columnsAt(motion, line);
  if (!columns) return std::string(text);
  const bool inTicks = motion.timeUnit == MotionFile::TimeUnit::kTicks;
  const Duration unit = inTicks ? kMotionTick : Duration(std::chrono::milliseconds(1));
  const Duration rounded = std::max<Duration::rep>(1, (duration + unit / 2) / unit) * unit;
  return withWord(text, line, *columns + 1, writeDuration(motion, rounded));
}

int lastFrameLine(std::string_view text, const MotionFile& motion) {
  const auto frames = keyFramesOf(motion);
  if (!frames.empty()) return frames.back().line;
  int line = static_cast<int>(motionRows(text).size()) - 1;
  for (const MotionLine& each : motion.lines) {
    if (std::holds_alternative<MotionLabel>(each.statement)) line = each.number;
  }
  return line;
}

std::string withFrame(std::string_view text, const MotionFile& motion, int afterLine, const KeyFrame& frame) {
  std::string row;
  for (const JointValue& value : frame.joints) row += aligned(writeValue(motion, value));
  row += " " + std::to_string(frame.interpolation) + " " + writeDuration(motion, frame.duration);
  std::vector<std::string> rows = rowsOf(text);
  const auto after = std::clamp<std::ptrdiff_t>(afterLine, 0, static_cast<std::ptrdiff_t>(rows.size()));
  rows.insert(rows.begin() + after, std::move(row));
  return joined(rows, "\n");
}

std::string withoutLine(std::string_view text, int line) {
  std::vector<std::string> rows = rowsOf(text);
  if (const auto row = rowOf(rows, line)) rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(*row));
  return joined(rows, "\n");
}

std::string withLinesSwapped(std::string_view text, int a, int b) {
  std::vector<std::string> rows = rowsOf(text);
  const auto first = rowOf(rows, a), second = rowOf(rows, b);
  if (first && second) std::swap(rows[*first], rows[*second]);
  return joined(rows, "\n");
}

Result<std::string> mirrored(std::string_view text, const MotionFile& motion,
                             const std::vector<MirroredJoint>& mirror, std::optional<int> line) {
  const auto from = partners(motion, mirror);
  if (!from) return tl::unexpected(from.error());
  std::vector<std::string> rows = rowsOf(text);
  for (const MotionLine& each : motion.lines) {
    const auto row = rowOf(rows, each.number);
    if (!row || (line && *line != each.number)) continue;
    const auto* frame = std::get_if<KeyFrame>(&each.statement);
    const auto* hardness = std::get_if<MotionHardness>(&each.statement);
    if (frame != nullptr && frame->joints.size() == from->size())
      mirrorRow(rows[*row], 0, *from, mirror, true);
    if (hardness != nullptr && hardness->shares.size() == from->size())
      mirrorRow(rows[*row], 1, *from, mirror, false);
  }
  return joined(rows, "\n");
}

}  // namespace robotlink
