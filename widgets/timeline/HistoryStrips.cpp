// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/HistoryStrips.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "foxglove/Robot.pb.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/search/MessageSource.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/log/LogReader.h"

namespace widgets {

using robotlink::Instant;

namespace {

constexpr char kSaidType[] = "foxglove.Log";

/// The stream of images that is shown, as of a log: that of the camera, if there is one.
std::string imageStreamOf(const robotlink::StreamStore& store, const std::string& robot) {
  LogOverview overview;
  for (const auto* stream : store.streams(robot + "/"))
    overview.streams.push_back({stream->path, stream->type, stream->count, 0, {}, {}});
  const auto images = overview.imageStreams();
  return images.empty() ? std::string() : images.front();
}

/// Appends the message if it is a warning or an error.
void addIfSaid(const robotlink::StreamMessage& message, std::vector<LogEntry>& texts) {
  const auto* log = dynamic_cast<const foxglove::Log*>(message.value.get());
  if (log != nullptr && log->level() >= foxglove::Log::WARNING) texts.push_back(loggedEntry(message, *log));
}

/// The newest message of a stream in a piece that is not later.
robotlink::PackagePtr latestIn(const robotlink::HistoryArchive::Piece& piece, const std::string& stream,
                               Instant time) {
  robotlink::PackagePtr newest;
  const auto times = piece.times->find(stream);
  if (times == piece.times->end()) return newest;
  if (!piece.file.empty()) {
    const auto log = logplayer::LogFile::open(piece.file, {});
    const auto message = log ? (*log)->latest(stream, time) : std::nullopt;
    return message ? message->value : nullptr;
  }
  for (const robotlink::StreamMessage& message : *piece.messages) {
    if (message.path == stream && message.time <= time) newest = message.value;
  }
  return newest;
}

}  // namespace

HistoryStrips::HistoryStrips(robotlink::Session& session)
    : session_(session),
      worker_([this](const Job& job, const std::stop_token& stop) { worker_.publish(make(job, stop)); }) {}

HistoryStrips::Made HistoryStrips::make(const Job& job, const std::stop_token& stop) {
  Made made{job.epoch};
  for (const Picture& picture : job.pictures) {
    if (stop.stop_requested()) return made;
    const auto value = picture.value ? picture.value : latestIn(picture.piece, picture.stream, picture.time);
    made.thumbnails.emplace_back(picture.robot, LogThumbnail{picture.time, thumbnailOf(value, job.height)});
  }
  if (job.pieces.empty() || job.streams.empty()) return made;
  const auto source = logplayer::historySource(job.pieces);
  const auto cursor = source->read(job.streams, Instant::min());
  while (!stop.stop_requested()) {
    const auto message = cursor->next();
    if (!message) break;
    addIfSaid(*message, made.texts);
  }
  return made;
}

void HistoryStrips::want(const std::string& robot, std::vector<Instant> times, int height) {
  robots_[robot].wanted = std::move(times);
  height_ = height;
}

void HistoryStrips::followSession() {
  const auto& store = session_.store();
  const bool isOther = generation_ != store.generation() || store.newest() < knownTo_;
  generation_ = store.generation();
  if (!isOther) return;
  ++epoch_;
  listed_ = {};
  robots_.clear();
  unread_.clear();
  knownTo_ = Instant::min();
}

void HistoryStrips::tick() {
  followSession();
  takeMade();
  findImages();
  takeTexts();
  if (ticks_++ % kEvery != 0) return;
  Job job{epoch_, height_, nextPictures(), {}, {}};
  const std::size_t count = std::min(kPiecesAtOnce, unread_.size());
  job.pieces.assign(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(count));
  for (const auto* stream : streamsOfType(session_.store(), {}, kSaidType))
    job.streams.push_back(stream->path);
  if (job.pictures.empty() && job.pieces.empty()) return;
  if (!worker_.postIfFree(std::move(job))) return;
  unread_.erase(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(count));
}

void HistoryStrips::findImages() {
  decltype(listed_) now{session_.store().listVersion(), session_.robots()};
  if (now == listed_) return;
  listed_ = std::move(now);
  for (const std::string& robot : session_.robots())
    robots_[robot].strip.imageStream = imageStreamOf(session_.store(), robot);
}

void HistoryStrips::takeMade() {
  auto made = worker_.take();
  if (!made || made->epoch != epoch_) return;
  for (auto& [robot, thumbnail] : made->thumbnails) {
    auto& thumbnails = robots_[robot].strip.thumbnails;
    if (thumbnails.size() >= kMaxThumbnails) thumbnails.clear();
    thumbnails[thumbnail.time] = std::move(thumbnail.image);
  }
  addTexts(made->texts);
}

void HistoryStrips::takeTexts() {
  const auto& store = session_.store();
  const auto* archive = session_.history().archive();
  // Messages that have left the memory since were not seen here.
  if (archive != nullptr && store.horizon() > knownTo_) {
    for (const Piece& piece : archive->pieces()) {
      if (piece.held.to >= knownTo_) unread_.push_back(piece);
    }
  }
  std::vector<LogEntry> texts;
  for (const auto* stream : streamsOfType(store, {}, kSaidType)) {
    Robot& robot = robots_[robotlink::streams::robotOf(stream->path)];
    if (!robot.strip.said) robot.strip.said = std::make_shared<const std::vector<LogEntry>>();
    for (const auto* message : robot.cursors[stream->path].take(*stream).messages) addIfSaid(*message, texts);
  }
  addTexts(texts);
  knownTo_ = std::max(knownTo_, store.newest());
}

void HistoryStrips::addTexts(const std::vector<LogEntry>& texts) {
  std::map<std::string, std::vector<LogEntry>> ofRobots;
  for (const LogEntry& text : texts) ofRobots[text.robot.toStdString()].push_back(text);
  const auto isBefore = [](const LogEntry& a, const LogEntry& b) {
    return std::tie(a.time, a.source, a.text) < std::tie(b.time, b.source, b.text);
  };
  const auto isSame = [](const LogEntry& a, const LogEntry& b) {
    return a.time == b.time && a.source == b.source && a.text == b.text;
  };
  for (auto& [robot, all] : ofRobots) {
    auto& said = robots_[robot].strip.said;
    if (said) all.insert(all.end(), said->begin(), said->end());
    // Texts in memory may also be on disk.
    std::sort(all.begin(), all.end(), isBefore);
    all.erase(std::unique(all.begin(), all.end(), isSame), all.end());
    if (all.size() > kMaxSaid) all.erase(all.begin(), all.end() - std::ptrdiff_t{kMaxSaid});
    said = std::make_shared<const std::vector<LogEntry>>(std::move(all));
  }
}

std::vector<HistoryStrips::Picture> HistoryStrips::nextPictures() {
  std::vector<Picture> pictures;
  for (auto& [name, robot] : robots_) {
    for (const Instant time : std::exchange(robot.wanted, {})) {
      if (pictures.size() == kImagesAtOnce) return pictures;
      if (robot.strip.thumbnails.contains(time)) continue;
      if (auto picture = find(name, time)) {
        pictures.push_back(std::move(*picture));
      } else {
        robot.strip.thumbnails[time] = {};
      }
    }
  }
  return pictures;
}

std::optional<HistoryStrips::Picture> HistoryStrips::find(const std::string& robot, Instant time) const {
  Picture picture{robot, time, robots_.at(robot).strip.imageStream};
  const auto& store = session_.store();
  if (store.has(time)) {
    const auto* message = store.latest(picture.stream, time);
    if (message == nullptr) return std::nullopt;
    picture.value = message->value;
    return picture;
  }
  const auto* archive = session_.history().archive();
  if (archive == nullptr) return std::nullopt;
  // The messages of a stream are in the order of the pieces.
  bool isThere = false;
  for (const Piece& piece : archive->pieces()) {
    const auto times = piece.times->find(picture.stream);
    if (times == piece.times->end() || times->second.from > time) continue;
    picture.piece = piece;
    isThere = true;
  }
  return isThere ? std::optional(std::move(picture)) : std::nullopt;
}

}  // namespace widgets
