// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"
#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/world/SceneFileEdit.h"

namespace robotcontrol {
class Request;
}

namespace widgets {

class SceneBench;
class SceneFile;
struct ViewContext;

/// Executes edits of the running scene from all views, with one undo history. Two things are kept apart:
///
/// - The state of the simulation, such as where a robot was dragged. Views change it by requests, and say by
///   addRequests() how that is undone. It is in no file.
/// - The texts of the scene's files. The functions here change them in the scene editor, unsaved, and have
///   the simulation continue in them. Each text is checked first, in a thread of its own, which takes some
///   100 ms, for large scenes longer; what the simulator would refuse is refused here, with its reason, and
///   nothing changes. A text that was edited meanwhile is changed and checked again.
///
/// Changes are made one after the other, in the order in which they were begun. One of the same place, such
/// as a pose that is dragged on, replaces the one before if that is not made yet.
///
/// Files are written by SceneBench::saveAll(), and by nothing here. Objects are those of the world itself,
/// by their names: models, includes, and lights ("light:lamp"). GUI thread.
class SceneEdits final : public QObject {
  Q_OBJECT
 public:
  using Texts = std::map<std::filesystem::path, std::string>;
  using Done = robotlink::Result<void>;
  /// Called once, in the GUI thread, perhaps before the function returns that was given it: the path of the
  /// object that was changed, or why nothing was. The error of a change that was replaced or taken back
  /// before it was made has the id kDropped.
  using Told = std::function<void(const robotlink::Result<std::string>& object)>;
  static constexpr const char* kDropped = "scene.dropped";

  /// Belongs to the bench, whose tick() makes the changes.
  explicit SceneEdits(SceneBench& bench);
  /// Waits for the check in progress.
  ~SceneEdits() override;

  /// Called in the GUI thread, later, if something of a scene does not fit between what is there now.
  using Refused = std::function<void(const std::string& reason)>;
  /// `goOn` has the simulation continue with texts that count instead of files; without a Refused what is in
  /// the way of something is put back. `mayWrite` says whether a file is one of the open scene. Without them
  /// no text can be changed.
  using GoOn = std::function<Done(const Texts& unsaved, const Refused& refused)>;
  void setHost(GoOn goOn, std::function<bool(const std::filesystem::path& file)> mayWrite);
  /// Whether the running scene has a text that can be changed.
  bool canChange() const;

  /// Changes elements; `title` says in a few words what for. `told` gets an empty path.
  void change(const std::vector<SceneFileEdit>& edits, const QString& title, Told told = {});
  /// Adds an object on the ground. `kind`: see SceneLanguage::newObject().
  void insert(const std::string& kind, double x, double y, Told told = {});
  /// Adds a copy of an object at another pose (x y z roll pitch heading; m, rad).
  void copy(const std::string& object, const std::array<double, 6>& pose, Told told = {});
  void erase(const std::string& object, Told told = {});
  void rename(const std::string& object, const std::string& name, Told told = {});
  /// Writes where an object is into the text.
  void setPose(const std::string& object, const std::array<double, 6>& pose, Told told = {});
  /// Whether an object is one of the world's own, so that it can be copied, erased and renamed.
  bool isOwn(const std::string& object) const;
  /// Has the simulation continue in the texts as they are in the editor.
  Done apply();
  /// Goes back to what a file has on the disk, also in the simulation if it is of its scene, which can be
  /// undone.
  Done discard(SceneFile& file);

  /// Whether a change is not made yet.
  bool isBusy() const { return checking_.has_value() || !waiting_.empty(); }
  /// Blocks until all changes are made, for commands, whose next one may depend on them.
  void finish();

  /// Something was done to the state of the simulation: `redo` was requested, and `undo` takes it back. What
  /// is refused then is reported by the bench.
  void addRequests(const QString& title, const robotcontrol::Request& undo,
                   const robotcontrol::Request& redo);
  /// The history is that of the scene that is simulated; each scene has its own.
  bool canUndo() const { return isBusy() || last(&History::undo) != nullptr; }
  bool canRedo() const { return last(&History::redo) != nullptr; }
  /// The change that undo() or redo() would concern; empty: none.
  QString undoTitle() const;
  QString redoTitle() const;
  /// Drops the last change that is not made yet; else takes back the last one that was. Fails if there is
  /// nothing, or if the text was edited by hand since; then the history stays as it is.
  Done undo();
  Done redo();

  static constexpr std::size_t kMaxSteps = 200;

 Q_SIGNALS:
  void historyChanged();

 private:
  /// Something that was done: texts of files that were replaced by others, or a request.
  struct Step {
    int number = 0;
    QString title;
    /// The object that is selected when it is there again; empty: none.
    std::string object;
    Texts before, after;
    std::shared_ptr<const robotcontrol::Request> undo = nullptr, redo = nullptr;
  };
  struct History {
    std::deque<Step> undo, redo;
  };
  enum class Way : std::uint8_t { kBack, kForth };
  /// A pending request to the simulation: to continue with a step of a scene.
  struct Asked {
    std::string scene;
    int step = 0, number = 0;
    Way way = Way::kForth;
  };
  /// Texts as a change makes them of others, and the object that it is about.
  struct Made {
    std::string object;
    Texts texts;
    /// The name and the one that the object had before; empty: it has the same.
    std::string name = {}, formerName = {};
    /// Returns the former name of a model.
    const std::string& former(const std::string& model) const {
      return !name.empty() && model == name ? formerName : model;
    }
  };
  using Make = std::function<robotlink::Result<Made>(const SceneLanguage& language, const Texts& before)>;
  struct Change {
    QString title;
    /// SceneBench::runningName() when it was begun.
    std::string scene;
    /// The files whose texts it makes others of.
    std::vector<std::filesystem::path> files;
    /// Called in the worker's thread.
    Make make;
    Told told;
    /// Names the place; empty: no other change replaces it.
    std::string place = {};
  };
  struct Job {
    std::uint64_t number = 0;
    Texts before;
    Make make;
  };
  struct Checked {
    std::uint64_t number = 0;
    Texts before;
    robotlink::Result<Made> made;
    std::map<std::filesystem::path, std::vector<SceneProblem>> problems = {};
  };
  static const SceneProblem* findWrong(const std::vector<SceneProblem>& problems);
  static Checked check(const SceneLanguage& language, const Job& job);
  void begin(Change change);
  /// Begins a change of the text of the running scene.
  void beginInScene(const QString& title, Make make, Told told, std::string place = {});
  void tick();
  /// Has the first change checked that waits, unless one is being checked.
  void checkNext();
  void take(Checked checked);
  /// Drops changes of a scene that is simulated no more.
  void followScene();
  /// Fails if an object starts inside what cannot have moved away.
  Done checkStarts(const Checked& checked) const;
  /// Reports those that start inside each other now, and did not before.
  void reportStarts(const Checked& checked);
  /// Has a change that was checked take effect.
  Done put(const Checked& checked, const QString& title);
  static void drop(const Change& change);
  const Step* last(std::deque<Step> History::*side) const;
  void add(Step step);
  void request(const std::shared_ptr<const robotcontrol::Request>& request);
  /// Puts texts in place of others if these are still there.
  Done exchange(const Texts& from, const Texts& to);
  /// Has the simulation go on in the texts as they are now.
  Done goOn(const Refused& refused);
  /// Exchanges the texts of a step, and has the simulation go on in them; both or neither.
  Done act(const Step& step, Way way);
  /// Undoes in the texts what steps have done to them, the newest of which is the last; all or nothing.
  Done exchangeBack(std::span<const Step> steps, Way way);
  /// The simulation did not go on with a step, so neither do the texts. Where they cannot go back, it goes on
  /// in them nevertheless.
  void takeBack(const Asked& asked, const std::string& reason);
  Done walk(Way way);

  SceneBench& bench_;
  GoOn goOn_;
  std::function<bool(const std::filesystem::path&)> mayWrite_;
  /// The histories of scenes, by SceneBench::runningName().
  std::map<std::string, History> histories_;
  int lastStep_ = 0;
  /// Counts how often the simulation was asked to go on.
  int lastAsked_ = 0;
  std::string scene_;
  /// Changes that are not checked yet, and the one that is.
  std::deque<Change> waiting_;
  std::optional<Change> checking_;
  /// The number of that one; results of others are outdated.
  std::uint64_t number_ = 0;
  /// The last member, since its thread uses what the language has. Null before the first change.
  std::unique_ptr<robotlink::Worker<Job, Checked>> worker_;
};

/// The edits of a window, created on the first call.
SceneEdits& sceneEdits(ViewContext& context);

/// Six numbers as a file has them, without digits that say nothing.
std::string poseText(const std::array<double, 6>& pose);

}  // namespace widgets
