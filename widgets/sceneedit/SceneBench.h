// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"
#include "widgets/View.h"
#include "widgets/sceneedit/SceneFile.h"

namespace widgets {

class RecoveryFile;

/// The scene files that are open in a window's editor: a current one of several, checked in a thread of its
/// own half a second after the last change, saved, and kept for the case of a crash. It opens no dialogs but
/// those of SceneDialogs.h.
///
/// After startRecovery(), unsaved texts are written to a recovery file in the user's folder two seconds after
/// a change, and are open again at the next start if this program does not end properly.
///
/// tick() is called 30 times a second. GUI thread; the context must outlive it.
class SceneBench final : public QObject {
  Q_OBJECT
 public:
  explicit SceneBench(ViewContext& context);
  ~SceneBench() override;

  ViewContext& context() const { return context_; }
  const std::vector<SceneFile*>& files() const { return files_; }
  /// Null: none is open.
  SceneFile* current() const { return current_; }
  void setCurrent(SceneFile* file);
  /// The scene that is simulated as its platform names it; empty: none is.
  std::string runningName() const;
  /// The file of the scene that is simulated; empty: none is, or it is not on this computer.
  std::filesystem::path runningScene() const;
  /// Whether a simulation runs that has read this file: it is its scene, or a model that its scene includes.
  bool isRunning(const SceneFile& file) const;
  /// The folder of the current file, where dialogs start.
  std::filesystem::path folder() const;

  /// Makes a file the current one, and opens it if it is not open.
  robotlink::Result<SceneFile*> open(const std::filesystem::path& path);
  /// Opens a file if it is not open, reads it again if another program has changed it, and leaves the current
  /// one as it is unless there is none.
  robotlink::Result<SceneFile*> ensure(const std::filesystem::path& path);
  /// The texts that are not saved, by path; new ones without a path are left out.
  std::map<std::filesystem::path, std::string> unsavedTexts() const;

  /// Opens a text that is not saved; `path`: where it is to be, or `name`: its name without one.
  SceneFile& startAnew(const QString& text, const std::filesystem::path& path, const QString& name = {});
  /// Closes a file; unsaved changes are lost.
  void close(SceneFile& file);
  /// The present text of a file was checked elsewhere, with these problems; it is not checked again.
  void noteChecked(const std::filesystem::path& path, std::vector<SceneProblem> problems);
  /// Saves the current file; fails if there is none or it has no path.
  robotlink::Result<void> save();
  robotlink::Result<void> saveAs(const std::filesystem::path& path);
  bool hasUnsaved() const;
  /// Saves all changed files that have a path; fails at the first that cannot be saved.
  robotlink::Result<void> saveAll();
  /// Saves the current file and lets the simulation continue in it, or opens it if it is another one.
  robotlink::Result<void> run();

  /// Goes to an object of the running scene, "red1/head/camera", by way of the files that are included. With
  /// an empty path to the beginning of the scene's file, or to the current file if nothing is simulated.
  /// Fails if the scene has no such object.
  robotlink::Result<void> goTo(const QString& object);
  /// Opens what the <include> around a position of the current file includes.
  robotlink::Result<void> openIncluded(int position);
  /// Goes to the place of a problem, in whichever file.
  robotlink::Result<void> goTo(const SceneProblem& problem);

  /// The target of goTo(), from begin to end, for the editor, which may be made after that. Only once.
  std::optional<std::pair<int, int>> takePlace() { return std::exchange(place_, std::nullopt); }

  /// Keeps the recovery file in `folder` from now on, and opens what was left there.
  void startRecovery(const std::filesystem::path& folder);
  void tick();
  /// Writes unsaved texts to the recovery file now and waits until that is done.
  void keepNow();
  /// The unsaved texts may be lost: deletes the recovery file.
  void forget();

 Q_SIGNALS:
  /// Emitted by tick().
  void ticked();
  /// Files were opened or closed, or their titles have changed.
  void filesChanged();
  void currentChanged();
  /// The problems of the current file changed.
  void problemsChanged();
  /// The editor is to select takePlace() in the current file.
  void placeWanted();
  /// The editor is to go to a line of the current file, from 1.
  void lineWanted(int line);
  /// Something was done; or could not be done.
  void reported(const QString& text, bool bad);

 private:
  struct Check {
    int file = 0, revision = 0;
    std::string text;
    std::filesystem::path path;
  };
  struct Checked {
    int file = 0, revision = 0;
    /// The problems; those in the file itself have no file name.
    std::vector<SceneProblem> problems;
  };
  SceneFile& add();
  SceneFile* find(const std::filesystem::path& path) const;
  void noticeChange(SceneFile& file);
  robotlink::Result<void> goWithin(const QString& object, int depth);
  /// Begins the next check that is due, and takes the results of the last one.
  void tickChecks();
  /// Reads files again that other programs have changed, and reports it; see SceneFile::follow().
  void followFile(SceneFile& file, bool looks);
  void tickFiles();
  void tickRecovery();
  robotlink::Result<void> restore(const std::filesystem::path& file);

  ViewContext& context_;
  std::vector<SceneFile*> files_;
  SceneFile* current_ = nullptr;
  std::optional<std::pair<int, int>> place_;
  /// Ticks until a file is checked, by its number; those that need no check are missing.
  std::map<int, int> due_;
  /// Keyed by file.
  std::map<SceneFile*, int> numbers_;
  int lastNumber_ = 0;
  int ticksUntilLook_ = 0;
  /// Null before startRecovery().
  std::unique_ptr<RecoveryFile> recovery_;
  /// Ticks since the first change that is not in the recovery file; 0: there is none.
  int ticksUnkept_ = 0;
  bool isKept_ = false;
  /// The last member, since its thread uses what the language has. Null without a language.
  std::unique_ptr<robotlink::Worker<Check, Checked>> checker_;
};

/// The bench of a window, created on the first call.
SceneBench& sceneBench(ViewContext& context);

}  // namespace widgets
