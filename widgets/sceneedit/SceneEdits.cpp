// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneEdits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "robotcontrol/World.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/View.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneFile.h"
#include "widgets/sceneedit/SceneFileObjects.h"
#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/world/ObjectPose.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

namespace {

Result<SceneObject> ownObject(const QString& text, const std::string& path) {
  const QString name = QString::fromStdString(path);
  const FoundSceneObject found = findSceneObject(text, name);
  const bool isOuter =
      !found.object.name.isEmpty() && found.rest.isEmpty() && !found.object.path.contains(QLatin1Char('/'));
  if (!isOuter)
    return failure("scene.object",
                   path +
                       " is not in the scene's own file; change "
                       "it in its own file: go to its text",
                   {}, {path});
  return found.object;
}

/// The first step to an object's elements; see SceneFileEdit.
std::string stepTo(const SceneObject& object) {
  const bool isLight = object.element == QLatin1String("light");
  return (isLight ? "light[" : "instance[") + object.name.toStdString() + "]";
}

/// The words of an element with the blanks before its first line.
QString withIndent(const QString& text, const SceneObject& object) {
  int begin = object.begin;
  while (begin > 0 && (text[begin - 1] == QLatin1Char(' ') || text[begin - 1] == QLatin1Char('\t'))) --begin;
  return text.mid(begin, object.end - begin) + QLatin1Char('\n');
}

bool isSceneName(const std::string& name) {
  return !name.empty() && name.size() <= 100 && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

}  // namespace

std::string poseText(const std::array<double, 6>& pose) {
  QStringList numbers;
  for (const double number : pose) numbers << QString::number(std::abs(number) < 5e-7 ? 0.0 : number, 'g', 6);
  return numbers.join(QLatin1Char(' ')).toStdString();
}

SceneEdits::SceneEdits(SceneBench& bench) : QObject(&bench), bench_(bench) {
  connect(&bench, &SceneBench::ticked, this, &SceneEdits::tick);
}
SceneEdits::~SceneEdits() = default;

void SceneEdits::setHost(GoOn goOn, std::function<bool(const std::filesystem::path&)> mayWrite) {
  goOn_ = std::move(goOn);
  mayWrite_ = std::move(mayWrite);
}

bool SceneEdits::canChange() const {
  const auto running = bench_.runningScene();
  return goOn_ && bench_.context().sceneLanguage != nullptr && !running.empty() &&
         running.extension() != ".map" && mayWrite_(running);
}

// ---- Changes of texts

SceneEdits::Checked SceneEdits::check(const SceneLanguage& language, const Job& job) {
  Checked checked{job.number, job.before, job.make(language, job.before)};
  const auto refuse = [&](const SceneProblem& wrong) {
    checked.made = failure("scene.refused", wrong.text, {wrong.file, wrong.line, 0});
    return checked;
  };
  if (!checked.made) {
    // In a text that is broken nothing can be found; then that is to be said.
    for (const auto& [file, text] : job.before) {
      const auto problems = language.check(text, file);
      if (const SceneProblem* wrong = findWrong(problems)) return refuse(*wrong);
    }
    return checked;
  }
  for (const auto& [file, text] : checked.made->texts) {
    if (text == job.before.at(file)) continue;
    auto problems = language.check(text, file);
    if (const SceneProblem* wrong = findWrong(problems)) return refuse(*wrong);
    checked.problems[file] = std::move(problems);
  }
  return checked;
}

const SceneProblem* SceneEdits::findWrong(const std::vector<SceneProblem>& problems) {
  const auto wrong = std::ranges::find_if(
      problems, [](const SceneProblem& one) { return !one.isWarning && one.inside.empty(); });
  return wrong == problems.end() ? nullptr : &*wrong;
}

void SceneEdits::drop(const Change& change) {
  if (change.told) change.told(failure(kDropped, "it was given up before it was done"));
}

void SceneEdits::begin(Change change) {
  if (!canChange()) {
    const bool isMap = bench_.runningScene().extension() == ".map";
    if (change.told)
      change.told(failure("scene.file",
                          isMap ? "a map has no scene text that could be changed; open a "
                                  "scene (.sdf)"
                                : "no scene of a file is simulated here, so there is no text to change"));
    return;
  }
  change.scene = bench_.runningName();
  const auto isReplaced = [&](const Change& other) {
    return !other.place.empty() && other.place == change.place;
  };
  std::vector<Change> dropped;
  if (checking_ && isReplaced(*checking_)) {
    dropped.push_back(*std::move(checking_));
    checking_.reset();
  }
  for (Change& other : waiting_) {
    if (isReplaced(other)) dropped.push_back(other);
  }
  std::erase_if(waiting_, isReplaced);
  waiting_.push_back(std::move(change));
  std::ranges::for_each(dropped, &SceneEdits::drop);
  Q_EMIT historyChanged();
}

void SceneEdits::checkNext() {
  while (!checking_ && !waiting_.empty()) {
    checking_ = std::move(waiting_.front());
    waiting_.pop_front();
    Job job{++number_, {}, checking_->make};
    for (const auto& path : checking_->files) {
      const auto file = bench_.ensure(path);
      if (!file) {
        take({number_, {}, tl::unexpected(file.error())});
        break;
      }
      job.before[path] = (*file)->text().toStdString();
    }
    if (!checking_) continue;
    if (worker_ == nullptr) {
      worker_ = std::make_unique<robotlink::Worker<Job, Checked>>(
          [this, language = bench_.context().sceneLanguage](const Job& todo, const std::stop_token&) {
            worker_->publish(check(*language, todo));
          });
    }
    worker_->post(std::move(job));
  }
}

void SceneEdits::followScene() {
  std::string scene = bench_.runningName();
  if (scene == scene_) return;
  scene_ = std::move(scene);
  std::vector<Change> dropped;
  const auto isOther = [this](const Change& change) { return change.scene != scene_; };
  if (checking_ && isOther(*checking_)) {
    dropped.push_back(*std::move(checking_));
    checking_.reset();
  }
  std::ranges::copy_if(waiting_, std::back_inserter(dropped), isOther);
  std::erase_if(waiting_, isOther);
  std::ranges::for_each(dropped, &SceneEdits::drop);
  Q_EMIT historyChanged();
}

void SceneEdits::tick() {
  followScene();
  if (worker_ != nullptr) {
    if (auto checked = worker_->take(); checked && checking_ && checked->number == number_)
      take(*std::move(checked));
  }
  checkNext();
}

void SceneEdits::take(Checked checked) {
  Change change = *std::move(checking_);
  checking_.reset();
  for (const auto& [path, text] : checked.before) {
    const auto file = bench_.ensure(path);
    if (file && (*file)->text().toStdString() != text) {
      waiting_.push_front(std::move(change));
      return;
    }
  }
  if (checked.made) {
    auto done = checkStarts(checked);
    if (done) done = put(checked, change.title);
    if (!done) checked.made = tl::unexpected(done.error());
  }
  Q_EMIT historyChanged();
  if (change.told) change.told(checked.made.map([](const Made& made) { return made.object; }));
}

SceneEdits::Done SceneEdits::put(const Checked& checked, const QString& title) {
  Texts before, after;
  for (const auto& [path, text] : checked.made->texts) {
    if (text == checked.before.at(path)) continue;
    before[path] = checked.before.at(path);
    after[path] = text;
  }
  if (after.empty()) return {};
  Step step{++lastStep_, title, checked.made->object, std::move(before), std::move(after)};
  if (auto done = act(step, Way::kForth); !done) return done;
  reportStarts(checked);
  for (const auto& [path, problems] : checked.problems) bench_.noteChecked(path, problems);
  add(std::move(step));
  return {};
}

SceneEdits::Done SceneEdits::checkStarts(const Checked& checked) const {
  const auto objectOf = [&](const std::string& name) {
    return worldObject(bench_.context().session, checked.made->former(name));
  };
  for (const auto& [path, problems] : checked.problems) {
    for (const SceneProblem& problem : problems) {
      if (problem.inside.size() < 2) continue;
      const auto mayHaveMoved = [&](const std::string& name) {
        const auto* object = objectOf(name);
        return object != nullptr && object->is_movable();
      };
      if (std::ranges::any_of(problem.inside, mayHaveMoved)) continue;
      const std::size_t added = objectOf(problem.inside[0]) == nullptr ? 0 : 1;
      return failure("scene.no-room",
                     "there is no room for '" + problem.inside[added] + "': it would be inside '" +
                         problem.inside[1 - added] + "'; choose another place",
                     {}, {problem.inside[added], problem.inside[1 - added]});
    }
  }
  return {};
}

void SceneEdits::reportStarts(const Checked& checked) {
  for (const auto& [path, problems] : checked.problems) {
    const auto file = bench_.ensure(path);
    for (const SceneProblem& problem : problems) {
      if (problem.inside.empty() || !file) continue;
      std::vector<std::string> former;
      for (const std::string& model : problem.inside) former.push_back(checked.made->former(model));
      if (std::ranges::count((*file)->problems(), former, &SceneProblem::inside) > 0) continue;
      Q_EMIT bench_.reported(tr("The simulation continues, but the scene could not be opened from its "
                                "initial state: %1, or write the present pose into the scene (Ctrl+Shift+W)")
                                 .arg(QString::fromStdString(problem.text)),
                             true);
    }
  }
}

void SceneEdits::finish() {
  while (isBusy()) {
    checkNext();
    if (worker_ != nullptr) worker_->finish();
    tick();
  }
}

SceneEdits::Done SceneEdits::apply() {
  return goOn({});
}

void SceneEdits::beginInScene(const QString& title, Make make, Told told, std::string place) {
  begin({title, {}, {bench_.runningScene()}, std::move(make), std::move(told), std::move(place)});
}

void SceneEdits::change(const std::vector<SceneFileEdit>& edits, const QString& title, Told told) {
  Change change{title, {}, {}, {}, std::move(told)};
  std::vector<SceneFileEdit> whole = edits;
  for (SceneFileEdit& edit : whole) {
    const bool mayWrite = mayWrite_ && mayWrite_(edit.file);
    const auto file = mayWrite
                          ? bench_.ensure(edit.file)
                          : failure("scene.file", "it is not a file of the open scene, so it is not changed",
                                    {edit.file, 0, 0});
    if (!file) {
      if (change.told) change.told(tl::unexpected(file.error()));
      return;
    }
    change.files.push_back((*file)->path());
    edit.file = (*file)->path().string();
    change.place += edit.file + '\n';
    for (const std::string& step : edit.element) change.place += step + '/';
  }
  change.make = [whole](const SceneLanguage& language, const Texts& before) -> Result<Made> {
    Made made{{}, before};
    for (const SceneFileEdit& edit : whole) {
      auto text = language.withElement(made.texts.at(edit.file), edit.file, edit.element, edit.value);
      if (!text) return tl::unexpected(text.error());
      made.texts[edit.file] = *std::move(text);
    }
    return made;
  };
  begin(std::move(change));
}

void SceneEdits::insert(const std::string& kind, double x, double y, Told told) {
  const auto make = [=](const SceneLanguage& language, const Texts& before) -> Result<Made> {
    const auto& [file, text] = *before.begin();
    const QString present = QString::fromStdString(text);
    const std::string name = freeObjectName(present, QString::fromStdString(kind)).toStdString();
    const auto xml = language.newObject(kind, name, x, y, file);
    if (!xml) return tl::unexpected(xml.error());
    return Made{kind == "lamp" ? "light:" + name : name,
                {{file, withElements(present, QString::fromStdString(*xml), nullptr).toStdString()}}};
  };
  beginInScene(tr("Add %1").arg(QString::fromStdString(kind)), make, std::move(told));
}

void SceneEdits::copy(const std::string& object, const std::array<double, 6>& pose, Told told) {
  const auto make = [=](const SceneLanguage& language, const Texts& before) -> Result<Made> {
    const auto& [file, text] = *before.begin();
    const QString present = QString::fromStdString(text);
    auto own = ownObject(present, object);
    if (!own) return tl::unexpected(own.error());
    own->name = copiedObjectName(present, own->name);
    const QString element = renamedObject(withIndent(present, *own), own->name);
    const auto placed =
        language.withElement(element.toStdString(), file.string(), {stepTo(*own), "pose"}, poseText(pose));
    if (!placed) return tl::unexpected(placed.error());
    const bool isLight = own->element == QLatin1String("light");
    return Made{(isLight ? "light:" : "") + own->name.toStdString(),
                {{file, withElements(present, QString::fromStdString(*placed), nullptr).toStdString()}}};
  };
  beginInScene(tr("Duplicate %1").arg(QString::fromStdString(object)), make, std::move(told));
}

void SceneEdits::erase(const std::string& object, Told told) {
  const auto make = [object](const SceneLanguage&, const Texts& before) -> Result<Made> {
    const auto& [file, text] = *before.begin();
    const QString present = QString::fromStdString(text);
    const auto own = ownObject(present, object);
    if (!own) return tl::unexpected(own.error());
    return Made{object, {{file, withoutObject(present, *own).toStdString()}}};
  };
  beginInScene(tr("Delete %1").arg(QString::fromStdString(object)), make, std::move(told));
}

void SceneEdits::rename(const std::string& object, const std::string& name, Told told) {
  const auto make = [=](const SceneLanguage&, const Texts& before) -> Result<Made> {
    const auto& [file, text] = *before.begin();
    const QString present = QString::fromStdString(text), wanted = QString::fromStdString(name);
    const auto own = ownObject(present, object);
    if (!own) return tl::unexpected(own.error());
    if (!isSceneName(name))
      return failure("scene.name", "a name consists of letters, digits, '_' and '-'", {}, {name});
    const std::string path = object.substr(0, object.find(':') + 1) + name;
    if (wanted == own->name) return Made{path, before};
    if (freeObjectName(present, wanted) != wanted)
      return failure("scene.name", "there is another object " + name, {}, {name});
    const QString element = renamedObject(present.mid(own->begin, own->end - own->begin), wanted);
    return Made{path,
                {{file, (present.left(own->begin) + element + present.mid(own->end)).toStdString()}},
                name,
                own->name.toStdString()};
  };
  beginInScene(tr("Rename %1").arg(QString::fromStdString(object)), make, std::move(told));
}

void SceneEdits::setPose(const std::string& object, const std::array<double, 6>& pose, Told told) {
  const auto make = [=](const SceneLanguage& language, const Texts& before) -> Result<Made> {
    const auto& [file, text] = *before.begin();
    const auto own = ownObject(QString::fromStdString(text), object);
    if (!own) return tl::unexpected(own.error());
    auto placed = language.withElement(text, file.string(), {stepTo(*own), "pose"}, poseText(pose));
    if (!placed) return tl::unexpected(placed.error());
    return Made{object, {{file, *std::move(placed)}}};
  };
  beginInScene(tr("Write the pose of %1").arg(QString::fromStdString(object)), make, std::move(told),
               "pose of " + object);
}

bool SceneEdits::isOwn(const std::string& object) const {
  if (!canChange()) return false;
  const auto file = bench_.ensure(bench_.runningScene());
  return file && ownObject((*file)->text(), object).has_value();
}

SceneEdits& sceneEdits(ViewContext& context) {
  SceneBench& bench = sceneBench(context);
  auto* edits = bench.findChild<SceneEdits*>(QString(), Qt::FindDirectChildrenOnly);
  return edits != nullptr ? *edits : *new SceneEdits(bench);
}

}  // namespace widgets
