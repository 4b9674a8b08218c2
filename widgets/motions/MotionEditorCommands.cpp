// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/MotionEditorCommands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/config/RobotDescription.h"
#include "widgets/motion/ManualSteering.h"
#include "widgets/motions/MotionBench.h"
#include "widgets/motions/MotionFiles.h"
#include "widgets/motions/MotionLink.h"
#include "widgets/motions/PoseCapture.h"

namespace widgets {
namespace {

using robotlink::CommandTable;
using robotlink::failure;
using robotlink::Result;
using Values = CommandTable::Values;
using RunMotion = std::function<Result<void>(MotionBench&, const Values&)>;

const std::string& motionWord(const Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}
double motionNumber(const Values& values, std::size_t index) {
  return std::get<double>(values[index]);
}
/// A wholeNumber; none if it is no whole motionNumber.
std::optional<int> wholeNumber(const Values& values, std::size_t index) {
  const double value = motionNumber(values, index);
  return std::abs(value) <= 1e6 && value == std::floor(value) ? std::optional(static_cast<int>(value))
                                                              : std::nullopt;
}
tl::unexpected<robotlink::Error> notWhole() {
  return failure("motion.wholeNumber", "expected a whole number");
}

Result<void> noUnsavedMotion(MotionBench& bench) {
  if (bench.isEmpty() || !motionFiles(bench.context()).changed()) return {};
  return failure(
      "motion.unsaved",
      "the motion was changed; save it (motion.save-as FILE) or discard the changes (motion.discard)");
}

Result<void> stepMotionHistory(QUndoStack& stack, bool forth) {
  if (forth ? !stack.canRedo() : !stack.canUndo())
    return failure("motion.history", forth ? "there is nothing to redo" : "there is nothing to undo");
  forth ? stack.redo() : stack.undo();
  return {};
}

Result<void> selectKeyFrame(MotionBench& bench, const Values& values) {
  const auto wanted = wholeNumber(values, 0);
  if (!wanted || *wanted < 1 || *wanted > static_cast<int>(bench.frames().size()))
    return failure("motion.no-frame",
                   "the motion has " + std::to_string(bench.frames().size()) + " key frames, counted from 1");
  bench.setFrame(*wanted - 1);
  return {};
}

Result<void> setKeyFrameValue(MotionBench& bench, const Values& values) {
  const auto columns = bench.columns();
  const auto found = std::ranges::find(columns, motionWord(values, 0));
  if (found == columns.end())
    return failure("motion.no-column", "the motion has no column " + motionWord(values, 0), {},
                   {motionWord(values, 0)});
  return bench.setValue(bench.frame(), static_cast<int>(found - columns.begin()),
                        QString::fromStdString(motionWord(values, 1)));
}

Result<void> setKeyFrameDuration(MotionBench& bench, const Values& values) {
  const double ms = motionNumber(values, 0);
  if (!(ms >= 1 && ms <= 1e6)) return failure("motion.bad-duration", "a duration is from 1 to 1000000 ms");
  return bench.setDuration(bench.frame(), robotlink::fromSeconds(ms / 1000));
}

Result<void> captureByCommand(MotionBench& bench, const Values& values) {
  const auto source = motionWord(values, 1) == "requested" ? PoseSource::kRequested : PoseSource::kMeasured;
  const double ms = motionNumber(values, 0);
  if (!(ms >= 1 && ms <= 1e6)) return failure("joints.duration", "a key frame takes from 1 to 1000000 ms");
  return capturePose(bench.context(), source, robotlink::fromSeconds(ms / 1000)).map([](const QString&) {});
}

/// Attaches commands of a table. They hold weak references, so they fail once the window no longer exists.
class MotionCommandTable {
 public:
  explicit MotionCommandTable(ViewContext& context) : context_(context) { motionBench(context); }

  void attach(const char* name, RunMotion run, CommandTable::Offer offer = {}) {
    const auto act = [run = std::move(run),
                      shared = std::weak_ptr(context_.motions)](const Values& values) -> Result<void> {
      if (const auto bench = shared.lock()) return run(*bench, values);
      return failure("motion.closed", "the window with the motion is closed");
    };
    context_.commands.attach(name, act, std::move(offer));
  }
  /// Offers a list of the bench for completion.
  CommandTable::Offer offer(std::function<std::vector<std::string>(MotionBench&)> list) {
    return [list = std::move(list), shared = std::weak_ptr(context_.motions)](const auto& before) {
      const auto bench = shared.lock();
      return bench && before.empty() ? list(*bench) : std::vector<std::string>();
    };
  }

 private:
  ViewContext& context_;
};

std::vector<std::string> motionsOfRobot(MotionBench& bench) {
  std::vector<std::string> names;
  if (const auto* table = bench.table()) {
    for (const auto& motion : table->motions()) names.push_back(motion.name());
  }
  return names;
}

std::vector<std::string> jointsOfRobot(MotionBench& bench) {
  return bench.document().joints();
}

void attachMotionFiles(MotionCommandTable& commands) {
  commands.attach("motion.new", [](MotionBench& bench, const Values& values) {
    return noUnsavedMotion(bench).and_then(
        [&] { return motionFiles(bench.context()).startAnew(motionWord(values, 0)); });
  });
  commands.attach("motion.open", [](MotionBench& bench, const Values& values) {
    return noUnsavedMotion(bench).and_then(
        [&] { return motionFiles(bench.context()).open(motionWord(values, 0)); });
  });
  commands.attach(
      "motion.open-from-robot",
      [](MotionBench& bench, const Values& values) {
        return noUnsavedMotion(bench).and_then(
            [&] { return motionFiles(bench.context()).openFromRobot(motionWord(values, 0)); });
      },
      commands.offer(motionsOfRobot));
  commands.attach("motion.save",
                  [](MotionBench& bench, auto&) { return motionFiles(bench.context()).save(); });
  commands.attach("motion.save-as", [](MotionBench& bench, const Values& values) {
    return motionFiles(bench.context()).saveAs(motionWord(values, 0));
  });
  commands.attach("motion.discard",
                  [](MotionBench& bench, auto&) { return motionFiles(bench.context()).discardChanges(); });
  commands.attach("motion.undo",
                  [](MotionBench& bench, auto&) { return stepMotionHistory(bench.undoStack(), false); });
  commands.attach("motion.redo",
                  [](MotionBench& bench, auto&) { return stepMotionHistory(bench.undoStack(), true); });
}

void attachMotionEdits(MotionCommandTable& commands) {
  commands.attach("motion.select", selectKeyFrame);
  commands.attach("motion.set", setKeyFrameValue,
                  commands.offer([](MotionBench& bench) { return bench.columns(); }));
  commands.attach("motion.duration", setKeyFrameDuration);
  commands.attach("motion.interpolation", [](MotionBench& bench, const Values& values) -> Result<void> {
    return bench.setInterpolation(bench.frame(), wholeNumber(values, 0).value_or(-1));
  });
  commands.attach("motion.duplicate", [](MotionBench& bench, auto&) { return bench.duplicateFrame(); });
  commands.attach("motion.remove", [](MotionBench& bench, auto&) { return bench.removeFrame(); });
  commands.attach("motion.move", [](MotionBench& bench, const Values& values) -> Result<void> {
    const auto places = wholeNumber(values, 0);
    if (!places) return notWhole();
    return bench.moveFrame(*places);
  });
  commands.attach("motion.mirror", [](MotionBench& bench, const Values& values) {
    bench.tick();
    return bench.mirror(motionWord(values, 0) == "key-frame");
  });
}

void attachMotionRobot(MotionCommandTable& commands) {
  commands.attach("motion.send",
                  [](MotionBench& bench, auto&) { return motionLink(bench.context()).send(); });
  commands.attach("motion.auto-send", [](MotionBench& bench, const Values& values) -> Result<void> {
    motionLink(bench.context()).setAutoSend(std::get<bool>(values[0]));
    return {};
  });
  commands.attach("motion.take-back",
                  [](MotionBench& bench, auto&) { return motionLink(bench.context()).takeBack(); });
  commands.attach("motion.play",
                  [](MotionBench& bench, auto&) { return motionLink(bench.context()).play(); });
  commands.attach("motion.step", [](MotionBench& bench, const Values& values) -> Result<void> {
    const auto places = wholeNumber(values, 0);
    if (!places) return notWhole();
    return motionLink(bench.context()).step(*places);
  });
}

void attachJointCommands(MotionCommandTable& commands) {
  commands.attach(
      "joints.set",
      [](MotionBench& bench, const Values& values) {
        return manualSteering(bench.context()).setJoint(motionWord(values, 0), motionNumber(values, 1));
      },
      commands.offer(jointsOfRobot));
  commands.attach("joints.limp", [](MotionBench& bench, const Values& values) {
    return manualSteering(bench.context()).setLimp(std::get<bool>(values[0]));
  });
  commands.attach("joints.capture", captureByCommand);
}

}  // namespace

void attachMotionEditorCommands(ViewContext& context) {
  if (context.commands.isAttached("motion.new")) return;
  MotionCommandTable commands(context);
  attachMotionFiles(commands);
  attachMotionEdits(commands);
  attachMotionRobot(commands);
  attachJointCommands(commands);
}

}  // namespace widgets
