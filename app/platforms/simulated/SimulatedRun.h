// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/core/own/OwnProgram.h"
#include "app/core/platform/HostingChoices.h"
#include "app/core/platform/StopSwitch.h"
#include "app/core/program/LeftOverPrograms.h"
#include "app/core/program/RobotHost.h"
#include "app/core/team/GameMail.h"
#include "app/platforms/simulated/ArcosPorts.h"
#include "app/platforms/simulated/ChosenSolutions.h"
#include "app/platforms/simulated/game/Referee.h"
#include "app/platforms/simulated/game/TeamRadio.h"
#include "app/platforms/simulated/snapshots/RunJournal.h"
#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "simcore/Scene.h"

namespace logplayer {
class Recorder;
}
namespace robotcontrol {
class GameStatus;
class HostProgram;
class Request;
}  // namespace robotcontrol
namespace robotlink {
class RobotProgram;
struct FieldDescription;
struct GroundMap;
struct Layout;
struct Preset;
}  // namespace robotlink

namespace simcore {
struct ModelInstance;
}

namespace app {

class RecordingTap;

/// The options of a simulated run. Paths are files; defaults come from the resources.
struct RunOptions {
  /// An SDFormat file or a map (.map).
  std::filesystem::path scene;
  /// Texts that count instead of what files of the scene have, because they are not saved.
  simcore::SceneTexts texts = {};
  /// The layout of all robots; empty: chosen by kind.
  std::filesystem::path layout;
  /// Layouts by kind of robot ("ers210"); kinds without one have the layout of their description.
  std::map<std::string, std::filesystem::path> layouts = {};
  /// Layouts of single robots, by name; they go before those of kinds, and both before those of the scene.
  std::map<std::string, std::filesystem::path> robotLayouts = {};
  /// Folders in which model://NAME is searched first.
  std::vector<std::filesystem::path> models = {};
  SimulatedWorld::Options world;
  /// Robots in addition to those of the scene. Unset: one for a map, otherwise none.
  std::optional<simcore::RobotsToAdd> robots = {};
  /// TCP ports at which other programs find the Pioneers; unset: none.
  std::optional<ArcosPorts::Options> ports = {};
  /// The time that a module may take before it counts as not returning, in real time; 0: forever.
  std::chrono::milliseconds patience{0};
  /// Whether a window shows the run, with which it shares the processors.
  bool isWatched = false;
  /// The choice of where programs run, and whether in threads.
  HostingChoices hosting = {};
  /// The options of running those in processes of their own.
  OwnProgram::Options own = {};
  /// Makes what runs instead of programs, such as links to remote programs; empty: programs.
  HostedProgram::Maker instead = {};
  /// Maps tasks to the solutions at the start, instead of the layout's.
  std::map<std::string, std::string> solutions;
  /// The same for single robots and teams, by name; those of a robot go before those of its team, and both
  /// before those of all.
  TeamSolutions robotSolutions = {};
  /// Solutions that were chosen earlier for robots and teams, by name, while their programs ran; they go
  /// before those of the layouts. What is chosen above goes before them.
  TeamSolutions keptSolutions = {};
  /// A preset with which all programs additionally start; null: none.
  std::shared_ptr<const robotlink::Preset> preset = nullptr;
  /// The same for single robots and teams, by name, instead of that of all; that of a robot goes before that
  /// of its team.
  std::map<std::string, std::shared_ptr<const robotlink::Preset>> robotPresets = {};
  /// The solutions that run in shadow mode, by the names of robots and teams, and in all
  /// programs by an empty name.
  std::map<std::string, std::vector<robotlink::ShadowName>> shadows = {};
  /// The color tables of single robots and teams, by name, and that of all others by an empty name; those of
  /// robots go before those of their teams. Robots without one make theirs from the field's colors.
  std::map<std::string, std::shared_ptr<const robotcontrol::ColorTable>> colorTables = {};
  /// Whether there is an Umpire: a Referee, or else ball and robots are put back after a goal.
  bool kickOffs = true;
  /// The rules by which the referee decides: the name of shipped ones, or a file. Empty: those that the scene
  /// names; kNoGame: without a referee.
  std::string game = {};
  /// Called while the scene is loaded; can cancel that.
  simcore::LoadProgress progress = {};
  /// Whether the true classes are sent with all images, even without a receiver.
  bool classImages = false;

  ExecutorKind executor() const { return hosting.threads ? ExecutorKind::kThreads : ExecutorKind::kLockstep; }
};

/// The simulation that is opened by default: the shipped soccer field, with as many threads as the machine
/// has cores.
RunOptions defaultSimulation();

/// Applies what a user has chosen, LAYOUT for all robots that can be run in it or NAME=LAYOUT for one robot
/// or kind of robots; layouts are files or names of shipped ones. Fails if a text is neither.
robotlink::Result<void> chooseLayouts(const std::vector<std::string>& texts, RunOptions& options);
/// Applies TASK=SOLUTION for all robots, or NAME/TASK=SOLUTION for one robot or team. Fails if a text is
/// neither.
robotlink::Result<void> chooseSolutions(const std::vector<std::string>& texts, RunOptions& options);
/// The same for solutions that are to run in shadow mode; also fails if there is no such solution.
robotlink::Result<void> chooseShadows(const std::vector<std::string>& texts, RunOptions& options);

/// A simulated world with the programs of all its robots, stepped by the caller. It is made as a whole or
/// refused with all reasons.
///
/// One thread at a time. Listeners are called in that thread in lockstep, and in the threads of the processes
/// otherwise.
class SimulatedRun {
 public:
  /// Functions that are called with what happens; each may be empty.
  struct Listeners {
    /// Called with each debug queue of a robot.
    std::function<void(const std::string& robot, std::shared_ptr<const robotlink::SharedDebugQueue>)> queue;
    /// Called if a process was stopped, starves, or could not get its priority.
    std::function<void(const std::string& robot, const robotlink::Process& process, const std::string& text)>
        trouble;
    /// Called with each image and its true classes (oracle/classes). While it is set, these are computed for
    /// all images.
    std::function<void(const std::string& robot, const foxglove::RawImage& image,
                       const foxglove::RawImage& classes)>
        labeled = {};
    /// Called with a line about what other programs did at the robots' ports.
    std::function<void(const std::string& text)> ports = {};
    /// Called with a sentence about what happened in the game.
    std::function<void(robotlink::Instant time, const std::string& text)> game = {};
    /// Called with sentences about a robot's platform being set up and shut down.
    std::function<void(const std::string& robot, robotlink::Instant time, const std::string& text)> platform =
        {};
    /// Called when it has changed where a robot's program runs, or whether it does.
    std::function<void(const std::string& robot, robotlink::Instant time,
                       const robotcontrol::HostingStatus& status)>
        hosting = {};
    /// Called with a sentence about a controller of the scene that was switched off.
    std::function<void(const std::string& controller, robotlink::Instant time, const std::string& text)>
        control = {};
  };

  /// The recorder gets everything that a log may contain and must outlive the run; null: nothing is recorded.
  static tl::expected<std::unique_ptr<SimulatedRun>, robotlink::Errors> create(
      RunOptions options, Listeners listeners, logplayer::Recorder* recorder = nullptr);
  /// Ends the programs. Waits for modules that do not return, unless end() was called and hasEnded() is true.
  ~SimulatedRun();
  /// Ends the programs and closes the ports. Nothing else but hasEnded() may be called then.
  void end();
  /// Whether all modules of programs that were ended have returned. Any thread, after end().
  bool hasEnded() const;

  /// Ends the wait for a module that does not return, so that STOP acts. Not null.
  std::shared_ptr<StopSwitch> stopSwitch() const { return stopSwitch_; }

  /// Makes one step of the world, its platforms, and all processes that can run then.
  void step();
  /// Call this while the simulation is paused, in lockstep: passes the results of open requests, which the
  /// programs will give in their next frames, to the listener of queues, together with the tables and
  /// parameters that follow from them. Neither the programs nor the recording are affected, so a run does not
  /// depend on how long it is paused.
  void publishComingAnswers();
  /// Puts world and programs back to the start, with another seed. The user's overrides are kept. If the
  /// programs cannot be made again, everything continues as before.
  robotlink::Errors reset(std::uint64_t seed);
  /// Fulfills a request that changes the world only (WorldChanges.h), and keeps it for runAgain().
  robotlink::Result<void> changeWorld(const robotcontrol::Request& request);
  /// Passes a request to the referee, or the radio of the teams, and keeps it for runAgain(). Fails with
  /// the reason, changing nothing.
  robotlink::Result<void> controlGame(const robotcontrol::Request& request);
  /// Keeps the state of the world and the game, and what is needed to run the programs again.
  simcore::Snapshot snapshot() const;
  /// Puts the world to where it was; the programs run on, and their time does, too. Fails, changing nothing,
  /// if the snapshot is of another scene or is not possible. Returns what SimulatedWorld::restore() does.
  robotlink::Result<std::vector<std::string>> restore(const simcore::Snapshot& snapshot);
  /// The same in the recent past; see SimulatedWorld::rewind().
  robotlink::Result<void> rewind(robotlink::Duration back);
  /// Begins to bring world and programs to the state of a snapshot: all start over, and each step() repeats
  /// its requests. Fails, changing nothing, with the reason where it cannot be known that the same
  /// state results: programs in threads or elsewhere, other settings, robots driven from outside, or
  /// where something happened that is not kept.
  robotlink::Result<void> runAgain(const simcore::Snapshot& snapshot);
  /// The progress of that, in [0, 1); unset: it is not being done.
  std::optional<double> ranAgain() const;
  /// Ends it where it is.
  void stopRunningAgain() { again_.reset(); }
  /// The outcome of the last one finished since the last call: empty, or why the state is another one,
  /// when the world was put to the snapshot alone. Unset: none was finished.
  std::optional<std::string> takeRunAgainOutcome() { return std::exchange(againOutcome_, std::nullopt); }

  /// The result of reload().
  struct Reloaded {
    /// False: the field or the map are others, so the scene has to be opened instead; nothing was changed.
    bool inPlace = false;
    /// Robots whose programs were started, since they are new or have other sensors or motors.
    std::vector<std::string> started = {};
    /// Removed robots, whose programs have ended.
    std::vector<std::string> ended = {};
    /// Models that could not keep their state, see simcore::SceneChange.
    std::vector<std::string> putBack = {};
  };
  /// Reads the scene's files again, with texts that count instead of them, and continues in it: time, poses,
  /// joint angles and velocities of models that have not changed stay, and so do the programs with all that
  /// they know. Models added, removed or duplicated since it was opened are so in it, too. A model that was
  /// in it before gets back its pose and motion. Fails with all errors of the file, and if something does
  /// not fit that must; then everything continues as before.
  tl::expected<Reloaded, robotlink::Errors> reload(simcore::SceneTexts texts = {}, bool mustFit = false);

  // Changes of the models that there are, between two steps; the file of the scene stays as it is. The
  // program of a robot starts and ends with it, all others continue. The same change at the same step gives
  // the same bytes. Each returns a sentence about what was done, or fails with all reasons; then everything
  // continues as before.
  tl::expected<std::string, robotlink::Errors> addModel(const simcore::ModelToAdd& model);
  tl::expected<std::string, robotlink::Errors> removeModel(const std::string& model);
  /// Places a copy next to the model, where there is room; an empty name chooses one.
  tl::expected<std::string, robotlink::Errors> duplicateModel(const std::string& model,
                                                              const std::string& name);
  /// Undoes the last of these changes. A removed model gets back its pose and motion.
  tl::expected<std::string, robotlink::Errors> undoEdit();
  /// The change that undoEdit() would undo: "the removal of red1"; empty: none.
  std::string undoable() const;
  /// Restarts the programs of all kinds of robots that can be run in a layout; the world continues. If there
  /// is no such kind, everything continues as before. The user's overrides are kept as far as the layout
  /// permits.
  robotlink::Errors setLayout(const std::filesystem::path& file);
  /// The same for one robot, or for those of a team; the other programs continue, too.
  robotlink::Errors setLayoutOf(const std::string& name, const std::filesystem::path& file);
  /// Chooses where the program of a robot runs, or of all if the name is empty, and starts programs there or
  /// again; the world and the other programs continue. If that is impossible, everything continues as before.
  robotlink::Errors hostProgram(const std::string& robot, const robotcontrol::HostProgram& choice);
  /// The layout files of those robots whose programs run in another one than layout(), by name.
  std::map<std::string, std::filesystem::path> otherLayouts() const;
  /// The real time that programs have taken in lockstep since the start or the last reset.
  robotlink::Duration programTime() const { return programTime_; }
  /// The overrides that the present programs cannot fulfill, as a sentence each.
  const std::vector<std::string>& lostChoices() const { return lostChoices_; }

  /// Has the forces of contacts be measured for views; a recording measures them anyway.
  void readForces(bool shown);
  SimulatedWorld& world() { return *world_; }
  const SimulatedWorld& world() const { return *world_; }
  const RunOptions& options() const { return options_; }
  /// The options with which the scene is to be opened again: also with the solutions that were chosen since.
  RunOptions optionsToKeep() const;
  /// Whether a solution was chosen since this was called last.
  bool takeSolutionsChosen() { return chosenSolutions_->takeNews(); }
  /// The names of the robots, in the order of the scene.
  std::vector<std::string> robots() const;
  /// Whether a robot, or a team that robots are of, has this name.
  bool hasRobotOrTeam(const std::string& name) const;
  /// Returns null if there is no such robot.
  std::shared_ptr<const robotlink::RobotDescription> description(const std::string& robot) const;
  /// Not null; its name is empty if there is no field.
  std::shared_ptr<const robotlink::FieldDescription> field() const { return field_; }
  /// Null without a field or a ball, or if kick-offs are switched off.
  const Umpire* game() const { return umpire_.get(); }
  /// Null if there is none: the scene names no rules.
  const Referee* referee() const { return referee_; }
  /// The game for those who watch; null without a referee.
  std::shared_ptr<const robotcontrol::GameStatus> gameStatus() const;
  /// The radio by which robots of a team hear each other.
  const TeamRadio& radio() const { return radio_; }
  /// The layout file of a robot's program; empty if there is no such robot.
  std::filesystem::path layoutOf(const std::string& robot) const;
  /// The layout of the first robot; empty if there are no robots.
  std::filesystem::path layout() const;

  /// Opens the ports of the options if they are not open. Fails if that is impossible.
  robotlink::Result<void> openPorts();
  /// Closes the ports, so that another run can open them.
  void closePorts() { ports_.reset(); }
  /// Null if other programs cannot drive the robots.
  const ArcosPorts* ports() const { return ports_.get(); }
  /// The map that the world was made from; null if it was made from a scene without one.
  std::shared_ptr<const robotlink::GroundMap> map() const;
  /// Enqueues a request for a robot's program, or has the robot's platform fulfill it (STOP, motors, sonars).
  /// Fails if there is no such robot or the request is refused.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  /// The robots for which STOP is engaged.
  std::vector<std::string> stoppedRobots() const;

 private:
  SimulatedRun(RunOptions options, Listeners listeners, logplayer::Recorder* recorder);
  /// Makes and starts everything; call this once.
  robotlink::Errors load();
  /// Makes referee and radio. Fails if the rules cannot be read.
  robotlink::Errors makeGame();
  /// The umpire that the present scene has.
  void makeUmpire();
  /// The game starts over.
  void restartGame();
  /// Lets the umpire follow the models that there are.
  void followModels();
  /// Reads descriptions and field, and makes the hosts.
  robotlink::Errors describeRobots();
  using Hosts = std::vector<std::unique_ptr<RobotHost>>;
  /// Makes hosts for all robots of a scene that do not continue in it unchanged.
  tl::expected<Hosts, robotlink::Errors> newHosts(const simcore::Scene& scene) const;
  /// Distributes the layout that was chosen for all to those kinds that can be run in it.
  robotlink::Errors distributeLayout();
  /// Checks the solutions of the options, also those in shadow mode, against the layouts.
  robotlink::Errors checkChosenSolutions() const;
  /// Layout files by kind of robot.
  using Layouts = std::map<std::string, std::filesystem::path>;
  /// The candidate programs, one for each robot.
  using Candidates = std::vector<RobotHost::Candidate>;
  /// The layout file for a robot: the chosen one of it or of its kind, otherwise that of the scene, otherwise
  /// that of its description.
  std::filesystem::path layoutOf(const RobotHost& robot, const Layouts& chosen) const;
  /// The preset with which a robot begins.
  std::shared_ptr<const robotlink::Preset> presetOf(const std::string& robot, const std::string& team) const;
  /// The user's choices for a robot that enters the scene.
  ProgramOverrides overridesOf(const HostedRobot& robot) const;
  /// The part of RunOptions::keptSolutions that applies to a robot, by task.
  std::map<std::string, std::string> keptSolutionsOf(const HostedRobot& robot) const;
  /// The solutions that were chosen for a robot instead of its layout's, by task.
  std::map<std::string, std::string> solutionsOf(const RobotHost& robot) const;
  /// Its layout with them.
  tl::expected<robotlink::Layout, robotlink::Errors> readLayoutOf(const RobotHost& robot,
                                                                  const std::filesystem::path& file) const;
  /// Makes programs for all robots without touching those that run.
  tl::expected<Candidates, robotlink::Errors> makePrograms(const Layouts& layouts);
  /// Returns why robots of a kind cannot be run in a layout; nothing if they can.
  robotlink::Errors whyNot(const std::string& kind, const std::filesystem::path& layout);
  /// Makes a new platform and a program for one robot. STOP stays as it is.
  tl::expected<RobotHost::Candidate, robotlink::Errors> makeProgram(RobotHost& robot,
                                                                    const std::filesystem::path& file,
                                                                    const robotlink::Layout& layout);
  /// The same on the platform that the robot has.
  tl::expected<RobotHost::Candidate, robotlink::Errors> makeProgramOnPlatform(RobotHost& robot);
  /// Returns the maker of a robot's program; empty: the program is one inside.
  HostedProgram::Maker makerFor(const std::string& robot) const;
  /// Begins programs in a new executor;
  /// those of other robots continue in it.
  void beginPrograms(const std::vector<RobotHost*>& robots);
  /// Returns null if there is no such robot.
  RobotHost* find(const std::string& robot) const;
  /// Replaces all programs and their executor.
  void startPrograms(Candidates candidates);
  /// Records map, scene, solids and objects.
  void recordWorld();
  /// Records what a step has published, and transforms and forces at their rate.
  void recordStep();
  /// Ends all programs and their executor.
  void stopPrograms();
  /// Ends the executor; programs whose modules do not return are left over, the others stay.
  void stopExecutor();
  /// The robots whose programs are exchanged by hostProgram(); adapts the options.
  std::vector<RobotHost*> applyHosting(const std::string& robot, const robotcontrol::HostProgram& choice);
  robotlink::Errors checkHosting(const std::string& robot) const;
  /// Makes new programs for robots, and exchanges theirs. If that is impossible, all continue as they are.
  robotlink::Errors exchangePrograms(const std::vector<RobotHost*>& robots);
  /// Reads the scene of the options, with the robots that are added to it.
  tl::expected<std::shared_ptr<const simcore::Scene>, robotlink::Errors> readScene();
  /// reload() with the texts of the options.
  tl::expected<Reloaded, robotlink::Errors> goOn(bool mustFit);
  /// Goes on in another scene with the same field and map, with the robots that it has.
  tl::expected<Reloaded, robotlink::Errors> goOnIn(std::shared_ptr<const simcore::Scene> scene,
                                                   simcore::Continuation how);
  /// Programs that are to be started in a scene that the world is in already.
  struct Successors {
    std::vector<RobotHost*> robots;
    Candidates candidates;
  };
  tl::expected<Successors, robotlink::Errors> makeSuccessors(const Hosts& fresh,
                                                             const std::vector<std::string>& changed);
  /// Whether the present host of a robot stays in the present scene.
  bool stays(const RobotHost& robot, const Hosts& fresh) const;
  /// Replaces the hosts by those of the present scene; returns the names of the removed ones.
  std::vector<std::string> exchangeHosts(Hosts fresh);
  /// Starts the executor again after a change that failed.
  void resumePrograms();
  /// Lets referee, STOP and ports follow the robots that there are.
  void followRobots(const std::vector<std::string>& pioneersBefore);
  std::vector<std::string> pioneerNames() const;
  /// A change of the models, with what takes it back.
  struct Edit {
    enum class Kind : std::uint8_t { kAddition, kRemoval };
    Kind kind = Kind::kAddition;
    std::string model;
    /// Only of a removal: what was removed, where it was in the list of models, and how it moved.
    std::shared_ptr<const simcore::ModelInstance> instance = nullptr;
    std::size_t index = 0;
    std::shared_ptr<const simcore::ModelMotion> motion = nullptr;
  };
  void noteEdit(Edit edit);
  tl::expected<void, robotlink::Errors> takeOut(const std::string& model);
  /// The scene that was read, with what was changed by hand since.
  std::shared_ptr<const simcore::Scene> withEdits(std::shared_ptr<const simcore::Scene> scene) const;
  /// Passes a problem of a process to the robot that owns it.
  void reportTrouble(const robotlink::Process& process, const std::string& text);
  /// World and programs start over; the programs with these overrides by robot, unless that is null.
  robotlink::Errors restart(std::uint64_t seed, const std::map<std::string, ProgramOverrides>* overrides);
  /// The settings that, besides requests, decide what a run does: a "name: value" in a line each.
  std::string settings() const;
  void beginJournal();
  /// Puts what the radio has on the way to where it was.
  void restoreRadio(const simcore::Snapshot& snapshot);
  void restoreGame(const simcore::Snapshot& snapshot);
  /// The run cannot be repeated from here on; `what` is a clause: "the layout was changed".
  void spoilJournal(const std::string& what);
  robotlink::Result<RunJournal> journalToRepeat(const simcore::Snapshot& snapshot) const;
  /// Repeats the requests that were made at this step of the run that is repeated.
  void repeatRequests();
  /// Compares the resulting state with that of the snapshot.
  void endRunningAgain();

  /// Lets the umpire act, and reports what happened.
  void watchGame();
  /// Carries what robots tell their team.
  void passMail();
  /// The mail between a robot's platform and the game.
  std::shared_ptr<GameMail> mailOf(const std::string& robot);
  void recordGame();
  /// Reports controllers that were switched off.
  void watchControllers();

  RunOptions options_;
  Listeners listeners_;
  std::shared_ptr<const robotlink::FieldDescription> field_;
  std::unique_ptr<SimulatedWorld> world_;
  /// The scene as its file described it when it was read last.
  std::shared_ptr<const simcore::Scene> read_;
  /// The motions of models, by name, that are no longer in the scene after its file was edited.
  std::map<std::string, std::shared_ptr<const simcore::ModelMotion>> goneMotions_;
  /// The newest last.
  std::vector<Edit> edits_;
  /// Null if there are none.
  std::shared_ptr<const GameRules> rules_;
  /// Null if there is none; see game().
  std::unique_ptr<Umpire> umpire_;
  /// The umpire, if it is one.
  Referee* referee_ = nullptr;
  TeamRadio radio_;
  /// The mail of each robot, by its name.
  std::map<std::string, std::shared_ptr<GameMail>> mails_;
  /// The state of the game that was last sent to robots, and when.
  std::uint64_t publishedChanges_ = 0;
  robotlink::Instant publishedAt_;
  /// Null if they are closed. Declared after the world, which it uses.
  std::unique_ptr<ArcosPorts> ports_;
  /// Null if nothing is recorded.
  std::unique_ptr<RecordingTap> tap_;
  std::vector<std::unique_ptr<RobotHost>> robots_;
  std::vector<std::string> lostChoices_;
  /// The solutions that were chosen; not null.
  const std::shared_ptr<ChosenSolutions> chosenSolutions_ = std::make_shared<ChosenSolutions>();
  /// The steps since the start, and the requests since then.
  std::uint64_t stepsMade_ = 0;
  RunJournal journal_;
  /// A run that is repeated.
  struct Again {
    simcore::Snapshot snapshot;
    RunJournal journal;
    std::size_t next = 0;
  };
  std::optional<Again> again_;
  std::optional<std::string> againOutcome_;
  robotlink::Duration programTime_{};
  /// The controllers whose end was reported since the start or the last reset.
  std::set<std::string> endedControllers_;
  /// Steps until transforms are recorded again.
  int stepsToTransforms_ = 0;
  /// For whom the forces of contacts are measured.
  bool showsForces_ = false, recordsForces_ = false;
  /// With modules inside, and with programs in processes of their own; shared with stopSwitch_.
  std::shared_ptr<ModulePatience> patience_, ownPatience_;
  std::shared_ptr<StopSwitch> stopSwitch_;
  LeftOverPrograms leftOver_;
  /// The last member, since it uses platforms and programs.
  std::unique_ptr<ProgramExecutor> executor_;
};

}  // namespace app
