// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/MotionBench.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/motions/MotionLibrary.h"
#include "robotlink/motions/MotionWords.h"
#include "robotlink/session/Session.h"
#include "widgets/controls/HistoryStep.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

MotionBench::MotionBench(ViewContext& context, QObject* parent) : QObject(parent), context_(context) {
  setObjectName(QStringLiteral("motionBench"));
  undo_.setObjectName(tr("(motion)"));
}

void MotionBench::change(const QString& what, std::string next, const std::string& gesture) {
  const std::size_t before = document_.position();
  if (next == document_.text()) return;
  const bool isStep = document_.change(what.toStdString(), std::move(next), gesture);
  // A continued gesture has its place on the stack already.
  if (isStep || document_.position() != before)
    undo_.push(new HistoryStep(what, document_, [this] { takeChange(); }));
  else
    takeChange();
}

void MotionBench::setDocument(std::string text, const std::string& path, bool changed) {
  std::vector<std::string> joints = document_.joints();
  document_ = robotlink::MotionDocument(std::move(text), path);
  document_.setJoints(std::move(joints));
  undo_.clear();
  // An empty stack ignores clear(), also that it was marked as changed.
  changed ? undo_.resetClean() : undo_.setClean();
  line_ = 1;
  takeChange();
  if (!frames_.empty()) setFrame(0);
}

void MotionBench::setSaved(const std::string& path) {
  document_.setPath(path);
  document_.setSaved();
  undo_.setClean();
}

void MotionBench::takeChange() {
  frames_ = robotlink::keyFramesOf(document_.motion());
  compile();
  Q_EMIT changed();
}

// ---- The robot

void MotionBench::tick() {
  follow();
  const auto* now = table();
  if (now != seenTable_ || std::exchange(isCompileDue_, false)) {
    compile();
    Q_EMIT robotChanged();
  }
}

void MotionBench::follow() {
  const std::string& robot = context_.session.selectedRobot();
  const auto known = context_.robots.find(robot);
  auto description = known == context_.robots.end() ? nullptr : known->second;
  if (robot == robot_ && description == description_) return;
  robot_ = robot;
  description_ = std::move(description);
  std::vector<std::string> joints;
  if (description_ != nullptr) {
    for (const auto& joint : description_->joints) joints.push_back(joint.name);
  }
  if (joints != document_.joints()) {
    document_.setJoints(std::move(joints));
    takeChange();
  }
  isCompileDue_ = true;
}

const robotcontrol::MotionTable* MotionBench::table() const {
  return context_.session.store().latestAs<robotcontrol::MotionTable>(
      robot_ + '/' + robotlink::streams::kMotions, context_.session.timeline().newest());
}

std::optional<MotionBench::RobotText> MotionBench::robotText() const {
  const auto* motions = table();
  if (motions == nullptr) return std::nullopt;
  const auto found =
      std::ranges::find(motions->motions(), motion().name, &robotcontrol::MotionTable::Motion::name);
  if (found == motions->motions().end()) return std::nullopt;
  return RobotText{found->text(), found->sent()};
}

void MotionBench::compile() {
  compileErrors_.clear();
  const auto* motions = table();
  seenTable_ = motions;
  if (isEmpty() || !document_.errors().empty() || document_.joints().empty()) return;
  robotlink::MotionLibrary library;
  if (motions != nullptr) {
    for (const auto& each : motions->motions()) library.replace(each.name(), each.text());
  } else if (auto files = robotlink::MotionLibrary::load(robotlink::resource("motions"))) {
    library = std::move(*files);
  }
  library.replace(motion().name, document_.text());
  const auto net = library.compile(document_.joints());
  if (net) return;
  const std::string own = motion().name + ".mof";
  for (const robotlink::Error& error : net.error()) {
    if (error.where.file == own || error.id == "motion.no-entry") compileErrors_.push_back(error);
  }
}

const robotlink::Errors& MotionBench::errors() const {
  return document_.errors().empty() ? compileErrors_ : document_.errors();
}

std::vector<std::string> MotionBench::columns() const {
  if (!motion().joints.empty()) return motion().joints;
  std::vector<std::string> numbers;
  const std::size_t count =
      frames_.empty() ? 0 : robotlink::keyFrameAt(motion(), frames_.front()).joints.size();
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(std::to_string(i + 1));
  return numbers;
}

// ---- The selection

void MotionBench::setLine(int line) {
  line = std::max(line, 1);
  if (line == line_) return;
  line_ = line;
  Q_EMIT lineChanged();
}

int MotionBench::frame() const {
  const auto after = std::ranges::upper_bound(frames_, line_, {}, &robotlink::KeyFramePlace::line);
  return static_cast<int>(after - frames_.begin()) - 1;
}

void MotionBench::setFrame(int frame) {
  if (frame >= 0 && frame < static_cast<int>(frames_.size()))
    setLine(frames_[static_cast<std::size_t>(frame)].line);
}

Result<void> MotionBench::requireFrame(int frame) const {
  if (isEmpty()) return failure("motion.none", "there is no motion; open one, or start one: motion.new NAME");
  if (frame >= 0 && frame < static_cast<int>(frames_.size())) return {};
  return failure("motion.no-frame",
                 frames_.empty() ? "the motion has no key frames"
                                 : "there is no such key frame; there are " + std::to_string(frames_.size()));
}

// ---- Edits

void MotionBench::addFrame(const QString& what, const robotlink::KeyFrame& frame) {
  const int selected = this->frame();
  const int after = selected >= 0 ? frames_[static_cast<std::size_t>(selected)].line
                                  : robotlink::lastFrameLine(document_.text(), motion());
  change(what, robotlink::withFrame(document_.text(), motion(), after, frame));
  setLine(after + 1);
}

Result<void> MotionBench::duplicateFrame() {
  const int selected = frame();
  return requireFrame(selected).map([&] {
    addFrame(tr("Duplicate key frame"),
             robotlink::keyFrameAt(motion(), frames_[static_cast<std::size_t>(selected)]));
  });
}

Result<void> MotionBench::removeFrame() {
  const int selected = frame();
  return requireFrame(selected).map([&] {
    change(tr("Remove key frame"),
           robotlink::withoutLine(document_.text(), frames_[static_cast<std::size_t>(selected)].line));
    setFrame(std::min(selected, static_cast<int>(frames_.size()) - 1));
  });
}

Result<void> MotionBench::moveFrame(int count) {
  const int selected = frame();
  return requireFrame(selected).and_then([&] { return requireFrame(selected + count); }).map([&] {
    const int from = frames_[static_cast<std::size_t>(selected)].line;
    const int to = frames_[static_cast<std::size_t>(selected + count)].line;
    change(tr("Move key frame"), robotlink::withLinesSwapped(document_.text(), from, to));
    setLine(to);
  });
}

Result<std::vector<robotlink::MirroredJoint>> MotionBench::mirrorOfColumns() const {
  if (description_ == nullptr || description_->joints.empty())
    return failure("motion.mirror",
                   "mirroring needs a robot, whose description names the joints of each side; select one");
  std::vector<robotlink::MirroredJoint> mirror;
  for (const std::string& column : columns()) {
    const int index = description_->jointIndex(column);
    if (index < 0)
      return failure("motion.mirror",
                     robot_ + " has no joint " + column + ", so its mirror image is not known", {},
                     {robot_, column});
    const auto& joint = description_->joints[static_cast<std::size_t>(index)];
    mirror.push_back({joint.mirror, joint.mirrorIsNegated});
  }
  return mirror;
}

Result<void> MotionBench::mirror(bool onlyFrame) {
  const int selected = frame();
  if (const auto has = requireFrame(onlyFrame ? selected : 0); !has) return has;
  const auto mirror = mirrorOfColumns();
  if (!mirror) return tl::unexpected(mirror.error());
  std::optional<int> line;
  if (onlyFrame) line = frames_[static_cast<std::size_t>(selected)].line;
  auto text = robotlink::mirrored(document_.text(), motion(), *mirror, line);
  if (!text) return tl::unexpected(text.error());
  change(onlyFrame ? tr("Mirror key frame") : tr("Mirror motion"), std::move(*text));
  return {};
}

Result<void> MotionBench::setValue(int frame, int column, const QString& value) {
  if (const auto has = requireFrame(frame); !has) return has;
  const std::string word = value.trimmed().toStdString();
  bool isNumber = false;
  const double number = value.trimmed().toDouble(&isNumber);
  const double limit = motion().angleUnit == robotlink::MotionFile::AngleUnit::kDegrees
                           ? robotlink::kMaxMotionDegrees
                           : robotlink::radians(robotlink::kMaxMotionDegrees) * 1000;
  const bool isAngle = isNumber && std::abs(number) <= limit;
  if (!isAngle && word != "*" && word != "~" && word != "-")
    return failure("motion.bad-angle",
                   "'" + word + "' is neither an angle nor '*' (stays as it is) nor '-' (released)", {},
                   {word});
  const auto& place = frames_[static_cast<std::size_t>(frame)];
  const auto& joints = robotlink::keyFrameAt(motion(), place).joints;
  if (column < 0 || column >= static_cast<int>(joints.size()))
    return failure("motion.no-column", "the motion has no such column");
  change(tr("Angle"),
         robotlink::withWord(document_.text(), place.line, static_cast<std::size_t>(column), word));
  return {};
}

Result<void> MotionBench::setInterpolation(int frame, int interpolation) {
  if (const auto has = requireFrame(frame); !has) return has;
  if (interpolation < 0 || interpolation > 3)
    return failure("motion.bad-interpolation", "the interpolation is 0 (jumps), 1 (linear), 2 or 3 (soft)");
  change(tr("Interpolation"),
         robotlink::withInterpolation(document_.text(), motion(),
                                      frames_[static_cast<std::size_t>(frame)].line, interpolation));
  return {};
}

Result<void> MotionBench::setDuration(int frame, robotlink::Duration duration, const std::string& gesture) {
  if (const auto has = requireFrame(frame); !has) return has;
  if (duration.count() <= 0 || duration > std::chrono::seconds(1000))
    return failure("motion.bad-duration", "a duration is from 1 ms to 1000 s");
  change(tr("Duration"),
         robotlink::withDuration(document_.text(), motion(), frames_[static_cast<std::size_t>(frame)].line,
                                 duration),
         gesture);
  return {};
}

MotionBench& motionBench(ViewContext& context) {
  if (context.motions == nullptr) context.motions = std::make_shared<MotionBench>(context);
  return *context.motions;
}

}  // namespace widgets
