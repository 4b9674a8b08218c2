// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/core/HistoryKeeper.h"
#include "app/core/PlatformThread.h"
#include "app/core/Recording.h"
#include "app/core/platform/HostingMemory.h"
#include "app/core/remote/OpeningQuestion.h"
#include "app/core/remote/RemoteRobots.h"
#include "app/core/remote/RobotSearch.h"
#include "app/core/remote/SessionOffer.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/session/Session.h"

namespace app {

/// Owns everything that is open in the workbench: the running platform (a simulation, a real robot, or logs),
/// the remote robots connected in addition to it, the session that they feed, its offer to others, and
/// the recording. Only in one thread, that of the GUI, which calls tick() at 30 Hz.
class OpenPlatform {
 public:
  /// The settings of the recording, the debug keys that were on for each robot, where programs run, and what
  /// connections may carry are kept below `userFolder`.
  explicit OpenPlatform(std::filesystem::path userFolder);
  ~OpenPlatform();

  robotlink::Session& session() { return session_; }
  Recording& recording() { return recording_; }
  HistoryKeeper& history() { return history_; }
  const RemoteRobots& remote() const { return remote_; }
  const SessionOffer& offer() const { return offer_; }
  SessionOffer& offer() { return offer_; }
  /// Robots that announce themselves.
  RobotSearch& search() { return search_; }

  /// Starts to open a platform. The result arrives in a later tick(), as for all functions that open or close
  /// something or change the layout. For a real robot it says only whether its program can be run; the
  /// progress of the connection is published on its stream link/status.
  void open(PlatformOpening opening);
  /// Adds a log to those that are open, on the same timeline; `offset` is added to its times.
  void addLog(const std::filesystem::path& file, robotlink::Duration offset);
  /// Retries the connection to a real robot at once if it was lost. Fails if no such robot is open.
  robotlink::Result<void> connectNow();
  /// Ends what runs.
  void close();
  /// Reads the scene of the simulation again, which was edited, and continues in it; if its robots are others
  /// now, it is opened from the start. `texts` count instead of files until it is loaded again.
  void reloadScene(const FileTexts& texts = {});
  /// reloadScene() with the files as they are saved, whoever edits them.
  void readSceneAgain();
  /// Called by readSceneAgain().
  void onSceneRead(std::function<void()> handler) { onSceneRead_ = std::move(handler); }
  /// The same as reloadScene() if everything fits between what is there now, or if the scene is opened from
  /// the start; otherwise tick() calls `refused` with all reasons, which onErrors() does not get then.
  void fitScene(const FileTexts& texts, std::function<void(const robotlink::Errors&)> refused);
  /// Restarts the robots' programs in another layout; with a name only those of that robot or team of a
  /// simulation.
  void setLayout(const std::filesystem::path& file, const std::string& name = {});

  /// Connects robots that run remotely, see RemoteRobots::connect().
  robotlink::Result<void> connectRemote(const std::string& url, const std::string& token);
  /// Also gives up a body whose program was to run here, or runs here, and that asks for something.
  robotlink::Result<void> disconnectRemote(const std::string& url);
  /// See RemoteRobots::trust().
  robotlink::Result<void> trustRemote(const std::string& url, const std::string& fingerprint);
  /// Shows another token to a robot that objected to the one before.
  robotlink::Result<void> showToken(const std::string& url, const std::string& token);
  /// Remembers the token of a connection once it was accepted.
  robotlink::Result<void> rememberToken(const std::string& url);
  /// Whether one of questions() is about a body whose program is to run here.
  bool asksForBody() const { return openingQuestion_.asked().has_value(); }
  /// The objections of remote robots that the user can resolve.
  std::vector<LinkQuestion> questions() const;
  /// Limits what a connection carries, also that to a body whose program runs here, now and whenever it is
  /// connected. Fails if the URL makes no sense.
  robotlink::Result<void> limitRemote(const std::string& url, const LinkLimits& limits);
  /// See RemoteRobots::recordings().
  RecordingJobs* recordingsAt(const std::string& url) { return remote_.recordings(url); }
  DeployJobs* deploymentAt(const std::string& url) { return remote_.deployment(url); }
  /// Takes control of a robot, even if another client has it, or gives control up. Fails if no other client
  /// can have it.
  robotlink::Result<void> steer(const std::string& robot, bool giveUp);
  /// Offers the session to others, see SessionOffer::begin().
  robotlink::Result<void> offerSession(const std::string& address);
  void stopOffering() { offer_.end(); }

  /// The folders in which models of scenes are searched first; from one run to the next. Any thread.
  std::vector<std::filesystem::path> modelFolders() const { return hosting_.modelFolders(); }

  /// Sends a request to what runs. A refusal is passed to the handler of onErrors().
  void ask(robotcontrol::Request request);

  /// Applies the results of loading, updates the session, and calls the handlers below.
  void tick();
  /// The handler is called with what runs now when something was loaded or closed, or a layout was changed.
  void onLoaded(std::function<void(const LoadedPlatform&)> handler) { onLoaded_ = std::move(handler); }
  /// The handler is called when remote robots were added or removed, or more is known about them.
  void onRemoteRobots(std::function<void()> handler) { onRemoteRobots_ = std::move(handler); }
  /// The handler is called if something could not be loaded, in which case what ran before continues; if a
  /// request was refused; and with warnings.
  void onErrors(std::function<void(const robotlink::Errors&)> handler) { onErrors_ = std::move(handler); }

  /// The platform that runs; null until something was loaded for the first time.
  const LoadedPlatform* loaded() const { return loaded_ ? &*loaded_ : nullptr; }
  /// Whether something is being loaded now.
  bool loading() const { return !openings_.empty(); }
  /// Returns why something could not be opened since the last call, or was canceled; empty if nothing failed.
  robotlink::Errors takeOpeningErrors() { return std::exchange(openingErrors_, {}); }
  /// The share of the file being opened that was read, in [0, 1]; unset if none is being opened.
  std::optional<double> progress() const;
  /// The name of that file; empty if there is none.
  std::string openingName() const;
  /// Cancels opening that file, and those that are to be opened after it; what ran before continues.
  void cancelOpening();

  /// From now on nothing that is chosen is kept for the next start, neither keys nor how programs run: a
  /// script chooses, and no person.
  void keepNothing() { keepsChoices_ = false; }
  /// Saves the modes of each robot's debug keys for the next start. Those of a robot that has not yet
  /// switched on what was saved before stay as saved. Fails if a file cannot be written.
  robotlink::Result<void> keepKeys();

 private:
  /// The progress of a file that is being opened, shared with the platform's thread.
  struct Opening {
    explicit Opening(const std::filesystem::path& file) : name(file.filename().string()) {}
    const std::string name;
    std::atomic<double> share = 0;
    std::atomic<bool> canceled = false;
  };
  /// The subject of a result: another platform, or another layout, an edited scene, or other robots on the
  /// same one. The last is not a response to a request to open something.
  enum class Change { kPlatform, kLayout, kScene, kRobots };
  /// A result from the platform's thread.
  struct Outcome {
    Change change;
    tl::expected<LoadedPlatform, robotlink::Errors> loaded;
    /// Empty: errors are reported.
    std::function<void(const robotlink::Errors&)> refused = {};
  };
  /// The function that updates an opening.
  static logplayer::LogFile::Progress progressOf(std::shared_ptr<Opening> opening);
  /// Returns a handler that enqueues the result for tick(), after `opening` was added to openings_.
  PlatformThread::LoadHandler outcomeOf(Change change, std::shared_ptr<Opening> opening = nullptr);
  /// See reloadScene() and fitScene().
  void goOnIn(const FileTexts& texts, bool mustFit, std::function<void(const robotlink::Errors&)> refused);
  /// Applies a result from the platform's thread.
  void apply(Outcome outcome);
  /// Tells the session of the robots of the platform and of remote ones.
  void listRobots();
  void followRemote();
  /// Passes a request of the session to the recording, the platform, or a remote robot.
  void take(const robotcontrol::Request& request);
  /// Calls the handler of onErrors().
  void report(const robotlink::Errors& errors);
  /// Switches on the debug keys that were on when the robot was last open; at first, those of a shipped
  /// preset.
  void switchKeysOn(const std::string& robot);

  std::filesystem::path userFolder_;
  robotlink::Session session_;
  HistoryKeeper history_;
  Recording recording_;
  /// From the platform's thread. Unbounded: each outcome belongs to one of openings_, and there are no more
  /// than a person has begun.
  robotlink::BoundedQueue<Outcome> outcomes_{std::numeric_limits<std::size_t>::max()};
  std::optional<LoadedPlatform> loaded_;
  robotlink::Errors openingErrors_;
  /// The number of requests of switchKeysOn() that a robot has not answered yet, by robot. Shared with the
  /// handlers of the answers, which count down.
  std::map<std::string, std::shared_ptr<int>> keysToSwitchOn_;
  std::function<void(const LoadedPlatform&)> onLoaded_;
  std::function<void()> onSceneRead_;
  std::function<void()> onRemoteRobots_;
  std::function<void(const robotlink::Errors&)> onErrors_;
  /// The subjects of the results to come, in their order; null where no file is read.
  std::deque<std::shared_ptr<Opening>> openings_;
  OpeningQuestion openingQuestion_;
  RobotSearch search_;
  LinkLimitsMemory limits_;
  RemoteRobots remote_;
  /// RemoteRobots::version() when the session was informed.
  std::uint64_t remoteVersion_ = 0;
  /// The remote robots whose debug keys were restored as they were at the previous connection.
  std::set<std::string> remoteSwitchedOn_;
  SessionOffer offer_;
  bool keepsChoices_ = true;
  HostingMemory hosting_;
  /// The last member, since its thread uses the others.
  PlatformThread platform_;
};

}  // namespace app
