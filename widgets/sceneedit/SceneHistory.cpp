// SPDX-License-Identifier: GPL-3.0-or-later
// SceneEdits: what was done to each scene, undone and redone.
#include <QPointer>
#include <algorithm>
#include <deque>
#include <iterator>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

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

namespace {

tl::unexpected<robotlink::Error> editedSince(const std::filesystem::path& path) {
  return failure("scene.history", "the text was edited by hand since; undo that in the scene editor first",
                 {path.string(), 0, 0});
}

}  // namespace

SceneEdits::Done SceneEdits::exchange(const Texts& from, const Texts& to) {
  std::map<std::filesystem::path, SceneFile*> files;
  for (const auto& [path, text] : from) {
    const auto file = bench_.ensure(path);
    if (!file) return tl::unexpected(file.error());
    if ((*file)->text().toStdString() != text) return editedSince(path);
    files[path] = *file;
  }
  for (const auto& [path, text] : to) files[path]->replaceText(QString::fromStdString(text));
  return {};
}

SceneEdits::Done SceneEdits::goOn(const Refused& refused) {
  if (!goOn_) return failure("scene.file", "no scene of a file is simulated here");
  ++lastAsked_;
  return goOn_(bench_.unsavedTexts(), refused);
}

SceneEdits::Done SceneEdits::act(const Step& step, Way way) {
  const bool isBack = way == Way::kBack;
  if (step.undo) {
    request(isBack ? step.undo : step.redo);
    return {};
  }
  const Texts &from = isBack ? step.after : step.before, &to = isBack ? step.before : step.after;
  if (auto done = exchange(from, to); !done) return done;
  const Asked asked{bench_.runningName(), step.number, lastAsked_ + 1, way};
  auto done = goOn([edits = QPointer<SceneEdits>(this), asked](const std::string& reason) {
    if (edits) edits->takeBack(asked, reason);
  });
  if (!done) std::ignore = exchange(to, from);  // nothing has changed them since
  return done;
}

SceneEdits::Done SceneEdits::exchangeBack(std::span<const Step> steps, Way way) {
  const bool wasBack = way == Way::kBack;
  Texts present, wanted;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    for (const auto& [path, text] : wasBack ? step->before : step->after) {
      const auto [older, isNewest] = wanted.try_emplace(path);
      if (isNewest) present[path] = text;
      if (!isNewest && older->second != text) return editedSince(path);
      older->second = (wasBack ? step->after : step->before).at(path);
    }
  }
  return exchange(present, wanted);
}

void SceneEdits::takeBack(const Asked& asked, const std::string& reason) {
  const bool wasBack = asked.way == Way::kBack;
  History& history = histories_[asked.scene];
  auto& from = wasBack ? history.redo : history.undo;
  auto& to = wasBack ? history.undo : history.redo;
  const auto refused = std::ranges::find(from, asked.step, &Step::number);
  const bool isKnown = refused != from.end();
  // Later edits were made in its text, so they are undone with it; requested steps stay.
  const std::vector<Step> steps(refused, from.end());
  const auto done = exchangeBack(steps, asked.way);
  if (done) {
    const auto isRequested = [](const Step& step) { return step.undo != nullptr; };
    from.erase(std::stable_partition(refused, from.end(), isRequested), from.end());
    SceneSelection& selection = sceneSelection(bench_.context());
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      if (isRequested(*step)) continue;
      if (!wasBack && selection.object() == step->object) selection.select({});
      to.push_back(*step);
    }
  }
  QString text = QString::fromStdString(reason);
  if (!done)
    text +=
        QLatin1Char('\n') + QString::fromStdString(done.error().describe()) + QLatin1Char('\n') +
        tr("So the text keeps the change, and the simulation continues in it; objects in the way return to "
           "their places in the file.");
  Q_EMIT bench_.reported(text, true);
  // The simulation may have gone on in texts that are gone now, and has not in those that stay.
  const bool isSame = done && isKnown && asked.number == lastAsked_;
  if (!isSame && asked.scene == bench_.runningName()) {
    if (const auto again = goOn({}); !again)
      Q_EMIT bench_.reported(QString::fromStdString(again.error().describe()), true);
  }
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
