// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneEdits.h"

#include <QPointer>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/View.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneFile.h"
#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/sceneedit/SceneObjects.h"

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
                       " is no object of the scene's own file, so it is changed in its "
                       "own file only: go to its text",
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

SceneEdits::SceneEdits(SceneBench& bench) : QObject(&bench), bench_(bench) {}
SceneEdits::~SceneEdits() = default;

void SceneEdits::setHost(std::function<Done(const Texts&)> goOn,
                         std::function<bool(const std::filesystem::path&)> mayWrite) {
  goOn_ = std::move(goOn);
  mayWrite_ = std::move(mayWrite);
}

bool SceneEdits::canChange() const {
  const auto running = bench_.runningScene();
  return goOn_ && bench_.context().sceneLanguage != nullptr && !running.empty() &&
         running.extension() != ".map" && mayWrite_(running);
}

Result<SceneFile*> SceneEdits::scene() const {
  if (!canChange())
    return failure("scene.file", "no scene of a file is simulated here, so there is no text to change");
  return bench_.ensure(bench_.runningScene());
}

// ---- Texts

SceneEdits::Done SceneEdits::put(const std::map<SceneFile*, QString>& texts, const QString& title) {
  std::map<std::string, QString> before, after;
  for (const auto& [file, text] : texts) {
    if (text == file->text()) continue;
    for (const SceneProblem& one : bench_.context().sceneLanguage->check(text.toStdString(), file->path())) {
      if (!one.isWarning) return failure("scene.refused", one.text, {one.file, one.line, 0});
    }
    before[file->path().string()] = file->text();
    after[file->path().string()] = text;
  }
  if (after.empty()) return {};
  if (auto done = exchange(before, after); !done) return done;
  add({title, [this, before, after] { return exchange(after, before); },
       [this, before, after] { return exchange(before, after); }});
  return {};
}

SceneEdits::Done SceneEdits::exchange(const std::map<std::string, QString>& from,
                                      const std::map<std::string, QString>& to) {
  std::map<std::string, SceneFile*> files;
  for (const auto& [path, text] : from) {
    const auto file = bench_.ensure(path);
    if (!file) return tl::unexpected(file.error());
    if ((*file)->text() != text)
      return failure("scene.history",
                     "the text was edited by hand since; undo that in the scene editor first", {path, 0, 0});
    files[path] = *file;
  }
  for (const auto& [path, text] : to) files[path]->replaceText(text);
  return apply();
}

SceneEdits::Done SceneEdits::apply() {
  if (!goOn_) return failure("scene.file", "no scene of a file is simulated here");
  return goOn_(bench_.unsavedTexts());
}

SceneEdits::Done SceneEdits::change(const std::vector<SceneFileEdit>& edits, const QString& title) {
  if (!canChange()) return scene().map([](SceneFile*) {});
  std::map<SceneFile*, QString> texts;
  for (const SceneFileEdit& edit : edits) {
    if (!mayWrite_(edit.file))
      return failure("scene.file", "it is no file of the open scene, so it is not changed",
                     {edit.file, 0, 0});
    const auto file = bench_.ensure(edit.file);
    if (!file) return tl::unexpected(file.error());
    const QString before = texts.contains(*file) ? texts[*file] : (*file)->text();
    const auto text = bench_.context().sceneLanguage->withElement(before.toStdString(), edit.file,
                                                                  edit.element, edit.value);
    if (!text) return tl::unexpected(text.error());
    texts[*file] = QString::fromStdString(*text);
  }
  return put(texts, title);
}

Result<std::string> SceneEdits::insert(const std::string& kind, double x, double y) {
  const auto file = scene();
  if (!file) return tl::unexpected(file.error());
  const QString name = freeObjectName((*file)->text(), QString::fromStdString(kind));
  const auto xml = bench_.context().sceneLanguage->newObject(kind, name.toStdString(), x, y, (*file)->path());
  if (!xml) return tl::unexpected(xml.error());
  const QString text = withElements((*file)->text(), QString::fromStdString(*xml), nullptr);
  if (auto done = put({{*file, text}}, tr("Add %1").arg(name)); !done) return tl::unexpected(done.error());
  return kind == "lamp" ? "light:" + name.toStdString() : name.toStdString();
}

Result<std::string> SceneEdits::copy(const std::string& object, const std::array<double, 6>& pose) {
  const auto file = scene();
  if (!file) return tl::unexpected(file.error());
  const QString text = (*file)->text();
  auto own = ownObject(text, object);
  if (!own) return tl::unexpected(own.error());
  own->name = freeObjectName(text, own->name);
  const QString element = renamedObject(withIndent(text, *own), own->name);
  const auto placed = bench_.context().sceneLanguage->withElement(
      element.toStdString(), (*file)->path().string(), {stepTo(*own), "pose"}, poseText(pose));
  if (!placed) return tl::unexpected(placed.error());
  const QString changed = withElements(text, QString::fromStdString(*placed), nullptr);
  if (auto done = put({{*file, changed}}, tr("Duplicate %1").arg(QString::fromStdString(object))); !done)
    return tl::unexpected(done.error());
  const bool isLight = own->element == QLatin1String("light");
  return (isLight ? "light:" : "") + own->name.toStdString();
}

SceneEdits::Done SceneEdits::erase(const std::string& object) {
  const auto file = scene();
  if (!file) return tl::unexpected(file.error());
  const auto own = ownObject((*file)->text(), object);
  if (!own) return tl::unexpected(own.error());
  return put({{*file, withoutObject((*file)->text(), *own)}},
             tr("Delete %1").arg(QString::fromStdString(object)));
}

SceneEdits::Done SceneEdits::rename(const std::string& object, const std::string& name) {
  const auto file = scene();
  if (!file) return tl::unexpected(file.error());
  const QString text = (*file)->text();
  const auto own = ownObject(text, object);
  if (!own) return tl::unexpected(own.error());
  const QString wanted = QString::fromStdString(name);
  if (!isSceneName(name))
    return failure("scene.name", "a name consists of letters, digits, '_' and '-'", {}, {name});
  if (wanted == own->name) return {};
  if (freeObjectName(text, wanted) != wanted)
    return failure("scene.name", "there is another object " + name, {}, {name});
  const QString element = renamedObject(text.mid(own->begin, own->end - own->begin), wanted);
  return put({{*file, text.left(own->begin) + element + text.mid(own->end)}},
             tr("Rename %1").arg(QString::fromStdString(object)));
}

SceneEdits::Done SceneEdits::setPose(const std::string& object, const std::array<double, 6>& pose) {
  const auto file = scene();
  if (!file) return tl::unexpected(file.error());
  const auto own = ownObject((*file)->text(), object);
  if (!own) return tl::unexpected(own.error());
  return change({{(*file)->path().string(), {stepTo(*own), "pose"}, poseText(pose)}},
                tr("Write the pose of %1").arg(QString::fromStdString(object)));
}

bool SceneEdits::isOwn(const std::string& object) const {
  if (!canChange()) return false;
  const auto file = bench_.ensure(bench_.runningScene());
  return file && ownObject((*file)->text(), object).has_value();
}

// ---- History

void SceneEdits::add(Step step) {
  redo_.clear();
  undo_.push_back(std::move(step));
  if (undo_.size() > kMaxSteps) undo_.pop_front();
  Q_EMIT historyChanged();
}

std::function<SceneEdits::Done()> SceneEdits::requesting(const robotcontrol::Request& request) {
  return [this, what = std::make_shared<const robotcontrol::Request>(request)]() -> Done {
    // The answer may come after the window is closed.
    const QPointer<SceneBench> bench = &bench_;
    bench_.context().session.request(*what, [bench](const robotcontrol::RequestResult& result) {
      if (bench && !result.accepted()) Q_EMIT bench->reported(QString::fromStdString(result.reason()), true);
    });
    return {};
  };
}

void SceneEdits::addRequests(const QString& title, const robotcontrol::Request& undo,
                             const robotcontrol::Request& redo) {
  add({title, requesting(undo), requesting(redo)});
}

SceneEdits::Done SceneEdits::walk(std::deque<Step>& from, std::deque<Step>& to,
                                  std::function<Done()> Step::*act) {
  if (from.empty()) return failure("scene.history", "there is nothing of the scene to undo or redo");
  Step step = std::move(from.back());
  from.pop_back();
  auto done = (step.*act)();
  (done ? to : from).push_back(std::move(step));
  Q_EMIT historyChanged();
  return done;
}

SceneEdits& sceneEdits(ViewContext& context) {
  SceneBench& bench = sceneBench(context);
  auto* edits = bench.findChild<SceneEdits*>(QString(), Qt::FindDirectChildrenOnly);
  return edits != nullptr ? *edits : *new SceneEdits(bench);
}

SceneEdits::Done SceneEdits::undo() {
  return walk(undo_, redo_, &Step::undo);
}

SceneEdits::Done SceneEdits::redo() {
  return walk(redo_, undo_, &Step::redo);
}

}  // namespace widgets
