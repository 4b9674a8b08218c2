// SPDX-License-Identifier: GPL-3.0-or-later
// SceneEdits: what was done to each scene, undone and redone.
#include <QPointer>
#include <algorithm>
#include <deque>
#include <iterator>
#include <memory>
#include <utility>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/View.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneEdits.h"
#include "widgets/sceneedit/SceneFile.h"
#include "widgets/world/SceneSelection.h"

namespace widgets {

using robotlink::failure;

SceneEdits::Done SceneEdits::exchange(const Texts& from, const Texts& to) {
  std::map<std::filesystem::path, SceneFile*> files;
  for (const auto& [path, text] : from) {
    const auto file = bench_.ensure(path);
    if (!file) return tl::unexpected(file.error());
    if ((*file)->text().toStdString() != text)
      return failure("scene.history",
                     "the text was edited by hand since; undo that in the scene editor first",
                     {path.string(), 0, 0});
    files[path] = *file;
  }
  for (const auto& [path, text] : to) files[path]->replaceText(QString::fromStdString(text));
  return {};
}

SceneEdits::Done SceneEdits::act(const Step& step, Way way) {
  const bool isBack = way == Way::kBack;
  if (step.undo) {
    request(isBack ? step.undo : step.redo);
    return {};
  }
  if (!goOn_) return failure("scene.file", "no scene of a file is simulated here");
  if (auto done = exchange(isBack ? step.after : step.before, isBack ? step.before : step.after); !done)
    return done;
  return goOn_(bench_.unsavedTexts(), [edits = QPointer<SceneEdits>(this), scene = bench_.runningName(),
                                       number = step.number, way](const std::string& reason) {
    if (edits) edits->takeBack(scene, number, way, reason);
  });
}

void SceneEdits::takeBack(const std::string& scene, int number, Way way, const std::string& reason) {
  const bool wasBack = way == Way::kBack;
  History& history = histories_[scene];
  auto& from = wasBack ? history.redo : history.undo;
  auto& to = wasBack ? history.undo : history.redo;
  if (std::ranges::find(from, number, &Step::number) == from.end()) return;
  // Later steps were written into its text, which the simulation has not received.
  std::deque<Step> requested;
  for (bool isDone = false; !isDone;) {
    Step step = std::move(from.back());
    from.pop_back();
    isDone = step.number == number;
    if (step.undo) {
      requested.push_front(std::move(step));
      continue;
    }
    SceneSelection& selection = sceneSelection(bench_.context());
    if (!wasBack && selection.object() == step.object) selection.select({});
    if (const auto done = exchange(wasBack ? step.before : step.after, wasBack ? step.after : step.before);
        !done)
      Q_EMIT bench_.reported(QString::fromStdString(done.error().describe()), true);
    to.push_back(std::move(step));
  }
  std::ranges::move(requested, std::back_inserter(from));
  Q_EMIT bench_.reported(QString::fromStdString(reason), true);
  Q_EMIT historyChanged();
}

SceneEdits::Done SceneEdits::discard(SceneFile& file) {
  const std::string before = file.text().toStdString();
  const auto saved = file.readAgain();
  if (!saved) return tl::unexpected(saved.error());
  if (!canChange() || !mayWrite_(file.path())) {
    file.replaceText(*saved);
    return {};
  }
  Step step{++lastStep_,
            tr("Discard changes of %1").arg(file.name()),
            {},
            {{file.path(), before}},
            {{file.path(), saved->toStdString()}}};
  if (auto done = act(step, Way::kForth); !done) return done;
  add(std::move(step));
  return {};
}

const SceneEdits::Step* SceneEdits::last(std::deque<Step> History::*side) const {
  const auto found = histories_.find(bench_.runningName());
  return found == histories_.end() || (found->second.*side).empty() ? nullptr : &(found->second.*side).back();
}

void SceneEdits::add(Step step) {
  History& history = histories_[bench_.runningName()];
  history.redo.clear();
  history.undo.push_back(std::move(step));
  if (history.undo.size() > kMaxSteps) history.undo.pop_front();
  Q_EMIT historyChanged();
}

void SceneEdits::request(const std::shared_ptr<const robotcontrol::Request>& request) {
  // The answer may come after the window is closed.
  const QPointer<SceneBench> bench = &bench_;
  bench_.context().session.request(*request, [bench](const robotcontrol::RequestResult& result) {
    if (bench && !result.accepted()) Q_EMIT bench->reported(QString::fromStdString(result.reason()), true);
  });
}

void SceneEdits::addRequests(const QString& title, const robotcontrol::Request& undo,
                             const robotcontrol::Request& redo) {
  add({++lastStep_,
       title,
       {},
       {},
       {},
       std::make_shared<const robotcontrol::Request>(undo),
       std::make_shared<const robotcontrol::Request>(redo)});
}

SceneEdits::Done SceneEdits::walk(Way way) {
  const bool isBack = way == Way::kBack;
  if (last(isBack ? &History::undo : &History::redo) == nullptr)
    return failure("scene.history", "there is nothing of the scene to undo or redo");
  History& history = histories_[bench_.runningName()];
  auto& from = isBack ? history.undo : history.redo;
  auto& to = isBack ? history.redo : history.undo;
  Step step = std::move(from.back());
  from.pop_back();
  auto done = act(step, way);
  const std::string object = step.object;
  (done ? to : from).push_back(std::move(step));
  SceneSelection& selection = sceneSelection(bench_.context());
  if (done && !object.empty()) {
    if (isOwn(object))
      selection.select(object);
    else if (selection.object() == object)
      selection.select({});
  }
  Q_EMIT historyChanged();
  return done;
}

QString SceneEdits::undoTitle() const {
  if (!waiting_.empty()) return waiting_.back().title;
  if (checking_) return checking_->title;
  const Step* step = last(&History::undo);
  return step == nullptr ? QString() : step->title;
}

QString SceneEdits::redoTitle() const {
  const Step* step = last(&History::redo);
  return step == nullptr ? QString() : step->title;
}

SceneEdits::Done SceneEdits::undo() {
  if (!isBusy()) return walk(Way::kBack);
  const Change dropped = waiting_.empty() ? *std::move(checking_) : std::move(waiting_.back());
  waiting_.empty() ? checking_.reset() : waiting_.pop_back();
  drop(dropped);
  Q_EMIT historyChanged();
  return {};
}

SceneEdits::Done SceneEdits::redo() {
  return walk(Way::kForth);
}

}  // namespace widgets
