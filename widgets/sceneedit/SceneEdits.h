// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "widgets/world/SceneFileEdit.h"

namespace robotcontrol {
class Request;
}

namespace widgets {

class SceneBench;
class SceneFile;
struct ViewContext;

/// What the views of the running scene do to it, with one history of all of it. Two things are kept apart:
///
/// - The state of the simulation, such as where a robot was dragged. Views change it by requests, and say by
///   addRequests() how that is undone. It is in no file.
/// - The texts of the scene's files. The functions here change them in the scene editor, unsaved, and have
///   the simulation go on in them. Each text is checked first; what the simulator would refuse is refused
///   here, with its reason, and nothing changes.
///
/// Files are written by SceneBench::saveAll(), and by nothing here. Objects are those of the world itself,
/// by their names: models, includes, and lights ("light:lamp"). A check takes some 100 ms, for large scenes
/// longer. GUI thread.
class SceneEdits final : public QObject {
  Q_OBJECT
 public:
  using Texts = std::map<std::filesystem::path, std::string>;
  using Done = robotlink::Result<void>;

  /// Belongs to the bench.
  explicit SceneEdits(SceneBench& bench);
  ~SceneEdits() override;

  /// `goOn` has the simulation go on with texts that count instead of files; `mayWrite` says whether a file
  /// is one of the open scene. Without them no text can be changed.
  void setHost(std::function<Done(const Texts& unsaved)> goOn,
               std::function<bool(const std::filesystem::path& file)> mayWrite);
  /// Whether the running scene has a text that can be changed.
  bool canChange() const;

  /// Changes elements; `title` says in a few words what for.
  Done change(const std::vector<SceneFileEdit>& edits, const QString& title);
  /// Adds an object on the ground; returns its name. `kind`: see SceneLanguage::newObject().
  robotlink::Result<std::string> insert(const std::string& kind, double x, double y);
  /// Adds a copy of an object at another pose (x y z roll pitch heading; m, rad); returns its name.
  robotlink::Result<std::string> copy(const std::string& object, const std::array<double, 6>& pose);
  Done erase(const std::string& object);
  Done rename(const std::string& object, const std::string& name);
  /// Writes where an object is into the text.
  Done setPose(const std::string& object, const std::array<double, 6>& pose);
  /// Whether an object is one of the world's own, so that it can be copied, erased and renamed.
  bool isOwn(const std::string& object) const;
  /// Has the simulation go on in the texts as they are in the editor.
  Done apply();

  /// Something was done to the state of the simulation: `redo` was requested, and `undo` takes it back. What
  /// is refused then is reported by the bench.
  void addRequests(const QString& title, const robotcontrol::Request& undo,
                   const robotcontrol::Request& redo);
  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  /// What undo() and redo() would be about; empty: nothing.
  QString undoTitle() const { return undo_.empty() ? QString() : undo_.back().title; }
  QString redoTitle() const { return redo_.empty() ? QString() : redo_.back().title; }
  /// Fail if there is nothing, or if the text was edited by hand since; then the history stays as it is.
  Done undo();
  Done redo();

  static constexpr std::size_t kMaxSteps = 200;

 Q_SIGNALS:
  void historyChanged();

 private:
  struct Step {
    QString title;
    std::function<Done()> undo, redo;
  };
  void add(Step step);
  std::function<Done()> requesting(const robotcontrol::Request& request);
  /// The text of the running scene; fails where none can be changed.
  robotlink::Result<SceneFile*> scene() const;
  /// Checks new texts, puts them in the editor, and has the simulation go on.
  Done put(const std::map<SceneFile*, QString>& texts, const QString& title);
  /// Puts texts in place of others if these are still there.
  Done exchange(const std::map<std::string, QString>& from, const std::map<std::string, QString>& to);
  Done walk(std::deque<Step>& from, std::deque<Step>& to, std::function<Done()> Step::*act);

  SceneBench& bench_;
  std::function<Done(const Texts&)> goOn_;
  std::function<bool(const std::filesystem::path&)> mayWrite_;
  std::deque<Step> undo_, redo_;
};

/// Those of a window, created on the first call.
SceneEdits& sceneEdits(ViewContext& context);

/// Six numbers as a file has them, without digits that say nothing.
std::string poseText(const std::array<double, 6>& pose);

}  // namespace widgets
