// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneBench.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/RecoveryFile.h"
#include "widgets/sceneedit/SceneFileObjects.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

namespace {

/// Half a second.
constexpr int kTicksUntilChecked = 15;
/// The period of checks of the files: once a second.
constexpr int kTicksUntilLook = 30;
/// The maximum number of files that include each other on the way to an object.
constexpr int kMaxIncludes = 8;

std::filesystem::path wholePath(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, unknown), unknown);
}

/// Problems in the checked file itself name no file.
void shortenPlaces(std::vector<SceneProblem>& problems, const std::filesystem::path& path) {
  for (SceneProblem& problem : problems) {
    if (problem.file == path.string()) problem.file.clear();
  }
}

tl::unexpected<robotlink::Error> noFile() {
  return failure("scene.none", "no scene file is open in the editor; open one: scene.edit");
}

}  // namespace

SceneBench::SceneBench(ViewContext& context) : context_(context) {
  setObjectName(QStringLiteral("sceneBench"));
  if (context.sceneLanguage != nullptr) {
    checker_ = std::make_unique<robotlink::Worker<Check, Checked>>(
        [this, language = context.sceneLanguage](const Check& check, const std::stop_token&) {
          auto problems = language->check(check.text, check.path);
          shortenPlaces(problems, check.path);
          checker_->publish({check.file, check.revision, std::move(problems)});
        });
  }
  connect(qApp, &QCoreApplication::aboutToQuit, this, &SceneBench::keepNow);
}

SceneBench::~SceneBench() = default;

// ---- Files

SceneFile& SceneBench::add() {
  auto* file = new SceneFile(this);
  files_.push_back(file);
  numbers_[file] = ++lastNumber_;
  connect(file, &SceneFile::textChanged, this, [this, file] { noticeChange(*file); });
  connect(file, &SceneFile::titleChanged, this, &SceneBench::filesChanged);
  connect(file, &SceneFile::problemsChanged, this, [this, file] {
    if (file == current_) Q_EMIT problemsChanged();
  });
  return *file;
}

SceneFile* SceneBench::find(const std::filesystem::path& path) const {
  const auto found =
      std::ranges::find_if(files_, [&](const SceneFile* file) { return file->path() == path; });
  return found == files_.end() ? nullptr : *found;
}

void SceneBench::noticeChange(SceneFile& file) {
  due_[numbers_[&file]] = kTicksUntilChecked;
  if (ticksUnkept_ == 0) ticksUnkept_ = 1;
}

void SceneBench::setCurrent(SceneFile* file) {
  if (file == current_) return;
  current_ = file;
  Q_EMIT currentChanged();
  Q_EMIT problemsChanged();
}

std::filesystem::path SceneBench::folder() const {
  if (current_ != nullptr && !current_->path().empty()) return current_->path().parent_path();
  const auto running = runningScene();
  return running.empty() ? std::filesystem::current_path() : running.parent_path();
}

Result<SceneFile*> SceneBench::open(const std::filesystem::path& path) {
  const auto whole = wholePath(path);
  if (SceneFile* known = find(whole)) {
    followFile(*known, true);
    setCurrent(known);
    return known;
  }
  SceneFile& file = add();
  if (const auto read = file.read(whole); !read) {
    close(file);
    return tl::unexpected(read.error());
  }
  due_[numbers_[&file]] = 1;
  Q_EMIT filesChanged();
  setCurrent(&file);
  return &file;
}

Result<SceneFile*> SceneBench::ensure(const std::filesystem::path& path) {
  SceneFile* const before = current_;
  const auto whole = wholePath(path);
  if (SceneFile* known = find(whole); known != nullptr && !known->isChanged()) {
    followFile(*known, true);
    return known;
  }
  auto opened = open(path);
  if (before != nullptr) setCurrent(before);
  return opened;
}

std::map<std::filesystem::path, std::string> SceneBench::unsavedTexts() const {
  std::map<std::filesystem::path, std::string> texts;
  for (const SceneFile* file : files_) {
    if (file->isChanged() && !file->path().empty()) texts[file->path()] = file->text().toStdString();
  }
  return texts;
}

SceneFile& SceneBench::startAnew(const QString& text, const std::filesystem::path& path,
                                 const QString& name) {
  SceneFile& file = add();
  file.setUnsaved(text, path.empty() ? path : wholePath(path), name);
  due_[numbers_[&file]] = 1;
  Q_EMIT filesChanged();
  setCurrent(&file);
  return file;
}

void SceneBench::close(SceneFile& file) {
  const auto place = std::ranges::find(files_, &file);
  if (place == files_.end()) return;
  const auto index = place - files_.begin();
  files_.erase(place);
  due_.erase(numbers_[&file]);
  numbers_.erase(&file);
  if (current_ == &file) {
    const auto next = std::min<std::ptrdiff_t>(index, std::ssize(files_) - 1);
    setCurrent(next < 0 ? nullptr : files_[static_cast<std::size_t>(next)]);
  }
  Q_EMIT filesChanged();
  file.deleteLater();  // an editor may still show it
  if (ticksUnkept_ == 0) ticksUnkept_ = 1;
}

Result<void> SceneBench::save() {
  if (current_ == nullptr) return noFile();
  if (current_->path().empty())
    return failure("scene.no-file", "the scene has no file yet; name one: scene.save FILE");
  return saveAs(current_->path());
}

Result<void> SceneBench::saveAs(const std::filesystem::path& path) {
  if (current_ == nullptr) return noFile();
  const auto whole = wholePath(path);
  const SceneFile* other = find(whole);
  if (other != nullptr && other != current_)
    return failure("scene.open", "this file is open in the editor; close it there first",
                   {whole.string(), 0, 0});
  if (const auto saved = current_->write(whole); !saved) return saved;
  // In another folder, other models are found.
  due_[numbers_[current_]] = 1;
  if (ticksUnkept_ == 0) ticksUnkept_ = 1;
  Q_EMIT reported(tr("Saved: %1").arg(QString::fromStdString(whole.string())), false);
  return {};
}

bool SceneBench::hasUnsaved() const {
  return std::ranges::any_of(files_, &SceneFile::isChanged);
}

Result<void> SceneBench::saveAll() {
  for (SceneFile* file : files_) {
    if (!file->isChanged()) continue;
    if (file->path().empty())
      return failure("scene.no-file", "a new scene has no file yet; save it under a name in the editor");
    if (const auto saved = file->write(file->path()); !saved) return saved;
  }
  if (ticksUnkept_ == 0) ticksUnkept_ = 1;
  return {};
}

// ---- The running scene

std::string SceneBench::runningName() const {
  const auto* status = context_.session.store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, context_.session.timeline().newest());
  return status == nullptr ? std::string() : status->scene();
}

std::filesystem::path SceneBench::runningScene() const {
  const std::string name = runningName();
  if (name.empty()) return {};
  const auto whole = wholePath(name);
  std::error_code unknown;
  return std::filesystem::exists(whole, unknown) ? whole : std::filesystem::path();
}

bool SceneBench::isRunning(const SceneFile& file) const {
  const auto scene = runningScene();
  if (scene.empty() || file.path() == scene) return !scene.empty();
  SceneFile* open = find(scene);
  SceneFile fromDisk(nullptr);
  if (open == nullptr && !fromDisk.read(scene)) return false;
  for (const SceneObject& object : sceneObjects(open != nullptr ? open->text() : fromDisk.text())) {
    if (object.uri.isEmpty() || context_.sceneLanguage == nullptr) continue;
    const auto model = context_.sceneLanguage->modelFile(object.uri.toStdString(), scene);
    if (model && wholePath(*model) == file.path()) return true;
  }
  return false;
}

Result<void> SceneBench::run() {
  if (const auto saved = save(); !saved) return saved;
  if (isRunning(*current_)) return context_.commands.runLine("scene.reload");
  return context_.commands.run("simulation.open", {current_->path().string()});
}

// ---- Places

Result<void> SceneBench::goTo(const QString& object) {
  const auto scene = runningScene();
  if (object.isEmpty() && current_ != nullptr && scene.empty()) return {};
  if (scene.empty() && current_ == nullptr)
    return failure("scene.none",
                   "no simulation is running and no scene file is open; open one: simulation.open");
  if (!scene.empty()) {
    if (const auto opened = open(scene); !opened) return tl::unexpected(opened.error());
  }
  return object.isEmpty() ? Result<void>() : goWithin(object, 0);
}

Result<void> SceneBench::goWithin(const QString& object, int depth) {
  const FoundSceneObject found = findSceneObject(current_->text(), object, current_->instance());
  if (found.object.path.isEmpty() || depth > kMaxIncludes)
    return failure("scene.object", "the scene's files have no object " + object.toStdString(),
                   {current_->path().string(), 0, 0}, {object.toStdString()});
  if (!found.rest.isEmpty() && context_.sceneLanguage != nullptr) {
    const auto model = context_.sceneLanguage->modelFile(found.object.uri.toStdString(), current_->path());
    if (model) {
      if (const auto opened = open(*model); !opened) return tl::unexpected(opened.error());
      current_->setInstance(found.object.path);
      return goWithin(found.object.path + QLatin1Char('/') + found.rest, depth + 1);
    }
  }
  place_ = {found.object.begin, found.object.end};
  Q_EMIT placeWanted();
  return {};
}

Result<void> SceneBench::openIncluded(int position) {
  if (current_ == nullptr) return noFile();
  for (const SceneObject& object : sceneObjects(current_->text())) {
    if (object.uri.isEmpty() || position < object.begin || position >= object.end) continue;
    const auto model = context_.sceneLanguage == nullptr
                           ? std::nullopt
                           : context_.sceneLanguage->modelFile(object.uri.toStdString(), current_->path());
    if (!model)
      return failure("scene.unknown-model", "there is no model '" + object.uri.toStdString() + "'", {},
                     {object.uri.toStdString()});
    const QString instance = object.path;
    return open(*model).map([&](SceneFile* file) { file->setInstance(instance); });
  }
  return failure("scene.no-include", "there is no <include> at the cursor");
}

Result<void> SceneBench::goTo(const SceneProblem& problem) {
  if (!problem.file.empty()) {
    if (const auto opened = open(problem.file); !opened) return tl::unexpected(opened.error());
  }
  Q_EMIT lineWanted(std::max(1, problem.line));
  return {};
}

// ---- Checks

void SceneBench::noteChecked(const std::filesystem::path& path, std::vector<SceneProblem> problems) {
  SceneFile* file = find(path);
  if (file == nullptr) return;
  shortenPlaces(problems, path);
  due_.erase(numbers_[file]);
  file->setProblems(std::move(problems), file->revision());
}

void SceneBench::tickChecks() {
  if (checker_ == nullptr) return;
  if (auto checked = checker_->take()) {
    for (const auto& [file, number] : numbers_) {
      // Problems found in an older text would be underlined at wrong places; the newer one is checked soon.
      if (number == checked->file && checked->revision == file->revision())
        file->setProblems(std::move(checked->problems), checked->revision);
    }
  }
  for (auto& [number, ticks] : due_) {
    if (ticks > 0) --ticks;
  }
  const auto next = std::ranges::find_if(due_, [](const auto& one) { return one.second == 0; });
  if (next == due_.end()) return;
  const auto file =
      std::ranges::find_if(files_, [&](SceneFile* one) { return numbers_[one] == next->first; });
  if (file == files_.end() ||
      checker_->postIfFree({next->first, (*file)->revision(), (*file)->text().toStdString(),
                            (*file)->path().empty() ? folder() / "unnamed.sdf" : (*file)->path()}))
    due_.erase(next);
}

void SceneBench::followFile(SceneFile& file, bool looks) {
  if (!file.follow(looks)) return;
  if (file.isChanged()) {
    Q_EMIT reported(
        tr("%1 was changed by another program, and has unsaved changes here: saving asks which version to "
           "keep")
            .arg(file.name()),
        true);
  } else {
    Q_EMIT reported(tr("%1 was changed by another program, and was reloaded").arg(file.name()), false);
  }
}

void SceneBench::tickFiles() {
  if (--ticksUntilLook_ > 0) return;
  ticksUntilLook_ = kTicksUntilLook;
  for (SceneFile* file : files_) followFile(*file, false);
}

void SceneBench::tick() {
  tickFiles();
  tickChecks();
  Q_EMIT ticked();
  tickRecovery();
}

SceneBench& sceneBench(ViewContext& context) {
  if (context.scenes == nullptr) context.scenes = std::make_shared<SceneBench>(context);
  return *context.scenes;
}

}  // namespace widgets
