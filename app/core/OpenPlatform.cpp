// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/OpenPlatform.h"

#include <algorithm>
#include <utility>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/KeyPresets.h"

namespace app {

OpenPlatform::OpenPlatform(std::filesystem::path userFolder)
    : userFolder_(std::move(userFolder)),
      history_(session_, userFolder_ / "history.json"),
      recording_(userFolder_),
      limits_(userFolder_ / "links.json"),
      remote_(session_, recording_.recorder(), limits_),
      offer_(session_),
      hosting_(userFolder_ / "hosting.json"),
      platform_(session_, recording_.recorder(), &hosting_, &limits_) {
  session_.setRequestSink([this](const robotcontrol::Request& request) { take(request); });
  history_.setLive(true);
  platform_.onRobotsChanged([this](const auto& loaded) { outcomes_.push({Change::kRobots, loaded}); });
  // Refusals are among the notes of remote_.
  offer_.onSteerElsewhere(
      [this](const std::string& robot, bool giveUp) { static_cast<void>(remote_.steer(robot, giveUp)); });
}

OpenPlatform::~OpenPlatform() {
  session_.setRequestSink({});
}

PlatformThread::LoadHandler OpenPlatform::outcomeOf(Change change, std::shared_ptr<Opening> opening) {
  openings_.push_back(std::move(opening));
  // Debug keys that are on stay on in the next platform.
  if (change == Change::kPlatform) {
    if (const auto kept = keepKeys(); !kept) report({kept.error()});
  }
  return [this, change](const auto& loaded) { outcomes_.push({.change = change, .loaded = loaded}); };
}

void OpenPlatform::open(PlatformOpening opening) {
  openingQuestion_.begin(opening);
  const auto reading = opening.file.empty() ? nullptr : std::make_shared<Opening>(opening.file);
  platform_.open(std::move(opening), reading ? progressOf(reading) : logplayer::LogFile::Progress(),
                 outcomeOf(Change::kPlatform, reading));
}

logplayer::LogFile::Progress OpenPlatform::progressOf(std::shared_ptr<Opening> opening) {
  return [opening = std::move(opening)](double share) {
    opening->share = share;
    return !opening->canceled;
  };
}

std::optional<double> OpenPlatform::progress() const {
  return loading() && openings_.front() ? std::optional(openings_.front()->share.load()) : std::nullopt;
}

std::string OpenPlatform::openingName() const {
  return loading() && openings_.front() ? openings_.front()->name : std::string();
}

void OpenPlatform::cancelOpening() {
  for (const auto& opening : openings_) {
    if (opening) opening->canceled = true;
  }
}

void OpenPlatform::addLog(const std::filesystem::path& file, robotlink::Duration offset) {
  const auto reading = std::make_shared<Opening>(file);
  platform_.addLog(file, offset, progressOf(reading), outcomeOf(Change::kPlatform, reading));
}

robotlink::Result<void> OpenPlatform::connectNow() {
  if (!loaded_ || !loaded_->isReal())
    return robotlink::failure("robot.not-real",
                              "no robot is connected over a line; connect one with the menu Robot first");
  platform_.connectNow();
  return {};
}
void OpenPlatform::close() {
  platform_.close(outcomeOf(Change::kPlatform));
}

void OpenPlatform::reloadScene(const FileTexts& texts) {
  goOnIn(texts, false, {});
}

void OpenPlatform::readSceneAgain() {
  reloadScene();
  if (onSceneRead_) onSceneRead_();
}

void OpenPlatform::fitScene(const FileTexts& texts, std::function<void(const robotlink::Errors&)> refused) {
  goOnIn(texts, true, std::move(refused));
}

void OpenPlatform::goOnIn(const FileTexts& texts, bool mustFit,
                          std::function<void(const robotlink::Errors&)> refused) {
  if (const auto kept = keepKeys(); !kept) report({kept.error()});
  openings_.push_back(nullptr);
  const auto outcome = [this, refused = std::move(refused)](Change change) {
    return [this, change, refused](const auto& loaded) {
      outcomes_.push({.change = change, .loaded = loaded, .refused = refused});
    };
  };
  platform_.reload(texts, mustFit, outcome(Change::kScene), outcome(Change::kPlatform));
}

void OpenPlatform::setLayout(const std::filesystem::path& file, const std::string& name) {
  platform_.setLayout(file, outcomeOf(Change::kLayout), name);
}

robotlink::Result<void> OpenPlatform::connectRemote(const std::string& url, const std::string& token) {
  const auto connected = remote_.connect(url, token);
  if (!connected) return tl::unexpected(connected.error());
  return {};
}
robotlink::Result<void> OpenPlatform::trustRemote(const std::string& url, const std::string& fingerprint) {
  if (!openingQuestion_.isAbout(url)) return remote_.trust(url, fingerprint);
  auto opening = openingQuestion_.trust(fingerprint);
  if (!opening) return tl::unexpected(opening.error());
  if (*opening) open(**std::move(opening));
  return {};
}
robotlink::Result<void> OpenPlatform::showToken(const std::string& url, const std::string& token) {
  if (!openingQuestion_.isAbout(url)) return connectRemote(url, token);
  open(openingQuestion_.show(token));
  return {};
}
robotlink::Result<void> OpenPlatform::rememberToken(const std::string& url) {
  if (!openingQuestion_.isShowing(url)) return remote_.rememberToken(url);
  openingQuestion_.rememberToken();
  return {};
}
std::vector<LinkQuestion> OpenPlatform::questions() const {
  std::vector<LinkQuestion> all;
  if (openingQuestion_.asked()) all.push_back(*openingQuestion_.asked());
  for (const auto& connection : remote_.connections()) {
    const auto& objection = connection.state.objection;
    if (objection.kind != robotlink::websocket::ServerObjection::Kind::kNone)
      all.push_back({connection.url, objection});
  }
  return all;
}
robotlink::Result<void> OpenPlatform::disconnectRemote(const std::string& url) {
  if (openingQuestion_.isAbout(url)) {
    if (openingQuestion_.drop()) close();
    report({{"body.declined",
             "the program of the robot at " + url +
                 " does not run here, because the question about its connection was not answered; choose "
                 "Robot > Connect… to try again",
             {url},
             {}}});
    return {};
  }
  if (auto kept = keepKeys(); !kept) report({kept.error()});
  return remote_.disconnect(url);
}
robotlink::Result<void> OpenPlatform::limitRemote(const std::string& url, const LinkLimits& limits) {
  const auto parsed = robotlink::websocket::parseServerUrl(url);
  if (!parsed) return tl::unexpected(parsed.error());
  limits_.choose(toString(*parsed), limits);
  return {};
}
robotlink::Result<void> OpenPlatform::steer(const std::string& robot, bool giveUp) {
  const auto& robots = session_.robots();
  if (std::ranges::find(robots, robot) == robots.end())
    return robotlink::failure("robot.unknown", "there is no robot " + robot, {}, {robot});
  return session_.remoteRobots().contains(robot) ? remote_.steer(robot, giveUp) : offer_.steer(robot, giveUp);
}
robotlink::Result<void> OpenPlatform::offerSession(const std::string& address) {
  if (auto done = offer_.begin(address); !done) return done;
  if (loaded_) publishPrograms(session_, *loaded_);
  return {};
}

void OpenPlatform::ask(robotcontrol::Request request) {
  session_.request(std::move(request), [this](const robotcontrol::RequestResult& result) {
    if (!result.accepted()) report({{"request.refused", result.reason(), {}, {}}});
  });
}

void OpenPlatform::take(const robotcontrol::Request& request) {
  if (robotlink::kindOf(request).doer != robotlink::RequestDoer::kRecording) {
    if (!remote_.take(request)) platform_.request(request);
    return;
  }
  const auto done = recording_.control(request.control_recording());
  robotcontrol::RequestResult result;
  result.set_id(request.id());
  result.set_accepted(done.has_value());
  if (!done) result.set_reason(done.error().text);
  session_.pushResult(result);
}

void OpenPlatform::tick() {
  for (Outcome& outcome : outcomes_.drain()) apply(std::move(outcome));
  if (const robotlink::Errors warnings = recording_.takeWarnings(); !warnings.empty()) report(warnings);
  if (auto problem = history_.takeProblem()) report({*std::move(problem)});
  if (keepsChoices_) {
    if (const auto saved = hosting_.save(); !saved) report({saved.error()});
    if (const auto saved = limits_.save(); !saved) report({saved.error()});
  }
  if (!loading()) openingQuestion_.follow();
  followRemote();
  session_.tick();
  offer_.tick();
}

void OpenPlatform::followRemote() {
  remote_.tick();
  for (robotlink::Error& note : remote_.takeNotes()) report({std::move(note)});
  if (std::exchange(remoteVersion_, remote_.version()) != remote_.version()) {
    listRobots();
    if (onRemoteRobots_) onRemoteRobots_();
  }
  const std::vector<std::string> robots = remote_.robots();
  std::erase_if(remoteSwitchedOn_,
                [&](const std::string& name) { return std::ranges::find(robots, name) == robots.end(); });
  for (const std::string& robot : robots) {
    const bool known = session_.store().latest(robot + "/" + robotlink::streams::kKeys,
                                               robotlink::Instant::max()) != nullptr;
    if (known && remoteSwitchedOn_.insert(robot).second) switchKeysOn(robot);
  }
}

void OpenPlatform::listRobots() {
  std::vector<std::string> robots;
  if (loaded_) {
    for (const auto& [name, description] : loaded_->robots) robots.push_back(name);
  }
  for (std::string& name : remote_.robots()) robots.push_back(std::move(name));
  session_.setRobots(std::move(robots));
}

void OpenPlatform::report(const robotlink::Errors& errors) {
  if (onErrors_) onErrors_(errors);
}

void OpenPlatform::apply(Outcome outcome) {
  if (outcome.change != Change::kRobots) openings_.pop_front();
  if (!outcome.loaded) {
    const robotlink::Errors& errors = outcome.loaded.error();
    if (outcome.refused) {
      openingErrors_ = errors;
      return outcome.refused(errors);
    }
    if (openingQuestion_.ask(errors)) return;
    openingErrors_ = errors;
    const bool wanted =
        errors.size() == 1 && (errors.front().id == "log.given-up" || errors.front().id == "scene.given-up");
    if (!wanted) report(errors);
    return;
  }
  std::set<std::string> before;
  if (loaded_ && outcome.change != Change::kPlatform) {
    for (const auto& [name, description] : loaded_->robots) before.insert(name);
  }
  loaded_ = std::move(*outcome.loaded);
  if (outcome.change == Change::kPlatform) {
    if (const auto kept = openingQuestion_.finish(loaded_->sources); !kept) report({kept.error()});
  }
  std::set<std::string> robots;
  for (const auto& [name, description] : loaded_->robots) robots.insert(name);
  history_.setLive(loaded_->time != TimeKind::kLogged);
  remote_.setPlatform(loaded_->time ? std::optional(robots) : std::nullopt);
  listRobots();
  if (offer_.isOffered()) publishPrograms(session_, *loaded_);
  if (outcome.change == Change::kPlatform) keysToSwitchOn_.clear();
  for (const std::string& robot : robots) {
    if (!before.contains(robot)) switchKeysOn(robot);
  }
  if (onLoaded_) onLoaded_(*loaded_);
  robotlink::Errors lost;
  for (const std::string& text : loaded_->lostChoices) lost.push_back({"choices.lost", text, {}, {}});
  if (!loaded_->leftOut.empty()) lost.push_back({"scene.left-out", loaded_->leftOut, {}, {}});
  if (!lost.empty()) report(lost);
}

void OpenPlatform::switchKeysOn(const std::string& robot) {
  auto keys = robotlink::KeyPresets(userFolder_ / "session").load(robot);
  if (!keys) keys = robotlink::KeyPresets(robotlink::resource("presets")).load("start");
  if (!keys) return;
  const auto unanswered = std::make_shared<int>(keys->keys_size());
  keysToSwitchOn_[robot] = unanswered;
  for (const auto& key : keys->keys()) {
    robotcontrol::Request request;
    request.set_robot(robot);
    request.mutable_set_key()->set_name(key.name());
    *request.mutable_set_key()->mutable_mode() = key.mode();
    // Another program may lack some of the keys that were on; that is no error to report.
    session_.request(std::move(request), [unanswered](const robotcontrol::RequestResult&) { --*unanswered; });
  }
}

robotlink::Result<void> OpenPlatform::keepKeys() {
  if (!keepsChoices_) return {};
  for (const std::string& robot : session_.robots()) {
    // Its table may still be the one from before the saved keys were switched on.
    const auto unanswered = keysToSwitchOn_.find(robot);
    if (unanswered != keysToSwitchOn_.end() && *unanswered->second > 0) continue;
    const auto* table = session_.store().latestAs<robotcontrol::KeyTable>(robot + "/tables/keys",
                                                                          session_.timeline().newest());
    if (table == nullptr) continue;
    if (auto saved = robotlink::KeyPresets(userFolder_ / "session").save(robot, *table); !saved) return saved;
  }
  return {};
}

}  // namespace app
