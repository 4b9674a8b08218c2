// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogReader.h"

#include <algorithm>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/file/LogImport.h"
#include "logplayer/images/ImageCoding.h"
#include "widgets/image/RawPicture.h"

namespace widgets {

using robotlink::Instant;
using Stage = LogOverview::Stage;

namespace {

constexpr std::size_t kMaxSaid = 5000, kMaxTexts = 50'000;
/// Most data is read only once here; only thumbnails are read in any order.
constexpr std::size_t kLogCacheBytes = 16U << 20U;

}  // namespace

LogEntry loggedEntry(const robotlink::StreamMessage& message, const foxglove::Log& log) {
  LogEntry entry;
  entry.time = message.time;
  entry.level = static_cast<LogEntry::Level>(std::clamp(static_cast<int>(log.level()), 0, 5));
  entry.robot = QString::fromStdString(message.path.substr(0, message.path.find('/')));
  entry.source = QString::fromStdString(log.name());
  entry.text = QString::fromStdString(log.message());
  return entry;
}

QImage thumbnailOf(const robotlink::PackagePtr& value, int height) {
  std::shared_ptr<const foxglove::RawImage> raw;
  if (const auto compressed = std::dynamic_pointer_cast<const foxglove::CompressedImage>(value)) {
    if (auto decoded = logplayer::rawImage(*compressed)) raw = std::move(*decoded);
  } else {
    raw = std::dynamic_pointer_cast<const foxglove::RawImage>(value);
  }
  if (raw == nullptr) return {};
  const QImage image = rawPicture(*raw);
  return image.isNull() ? image : image.scaledToHeight(height, Qt::SmoothTransformation);
}

std::unique_ptr<LogReading> readLogFile(const std::filesystem::path& file) {
  return std::make_unique<LogReader>(file);
}

LogReader::LogReader(std::filesystem::path file)
    : file_(std::move(file)),
      thumbnailWorker_(
          [this](const Wanted& wanted, const std::stop_token& stop) { readThumbnails(wanted, stop); }),
      overviewWorker_([this](std::monostate, const std::stop_token& stop) {
        stop_ = stop;
        readAll();
      }) {
  LogOverview overview;
  overview.file = file_.string();
  publish(overview);
  overviewWorker_.post({});
}

LogReader::~LogReader() = default;

std::shared_ptr<const LogOverview> LogReader::overview() {
  const std::lock_guard lock(mutex_);
  return overview_;
}

std::optional<robotlink::Result<logplayer::Bookmarks>> LogReader::takeBookmarks() {
  const std::lock_guard lock(mutex_);
  auto taken = std::move(bookmarks_);
  bookmarks_.reset();
  return taken;
}

void LogReader::publish(const LogOverview& overview) {
  auto shared = std::make_shared<const LogOverview>(overview);
  const std::lock_guard lock(mutex_);
  overview_ = std::move(shared);
}

bool LogReader::report(LogOverview& overview, double share) {
  // Publishing copies the overview; doing so for each percent would take longer than reading.
  if (share - overview.progress >= 0.1 || share < overview.progress) {
    overview.progress = share;
    publish(overview);
  }
  return !stop_.stop_requested();
}

void LogReader::readAll() {
  LogOverview overview;
  overview.file = file_.string();
  if (!open(overview)) return;
  readTimes(overview);
  if (!stop_.stop_requested()) readBookmarks();
  if (!stop_.stop_requested()) readTexts(overview);
  if (!stop_.stop_requested()) countSizes(overview);
}

bool LogReader::open(LogOverview& overview) {
  logplayer::LogFile::Options options;
  options.cacheBytes = kLogCacheBytes;
  options.progress = [&](double share) { return report(overview, share); };
  overview.converted = logplayer::canImport(file_);
  auto opened = logplayer::LogFile::open(file_, options);
  if (!opened) {
    overview.failure = QString::fromStdString(opened.error().describe());
    publish(overview);
    return false;
  }
  auto& log = **opened;
  overview.readOnly = log.readOnly();
  overview.damage = QString::fromStdString(log.damageText());
  overview.begin = log.begin();
  overview.robots = log.robots();
  overview.end = log.end();
  for (const auto& stream : log.streams()) {
    const bool decoded = stream.isDecoded();
    const std::string type = decoded ? stream.type : stream.type + " (" + stream.encoding + ", not decoded)";
    overview.streams.push_back({stream.path, type, stream.count, stream.bytes, stream.first, stream.last,
                                decoded ? std::string() : stream.encoding});
  }
  overview.stage = Stage::kTimes;
  overview.progress = 0;
  publish(overview);
  const std::lock_guard lock(mutex_);
  log_ = std::move(*opened);
  thumbnailWorker_.post(wanted_);
  return true;
}

void LogReader::readTimes(LogOverview& overview) {
  const double count = static_cast<double>(overview.streams.size());
  double done = 0;
  for (auto& stream : overview.streams) {
    if (!report(overview, done++ / count)) return;
    stream.density = MessageDensity(log_->times(stream.path));
  }
  overview.stage = Stage::kTexts;
  overview.progress = 0;
  publish(overview);
}

void LogReader::readBookmarks() {
  auto bookmarks = logplayer::Bookmarks::open(file_, [this](double) { return !stop_.stop_requested(); });
  if (stop_.stop_requested()) return;
  const std::lock_guard lock(mutex_);
  bookmarks_.emplace(std::move(bookmarks));
}

void LogReader::readTexts(LogOverview& overview) {
  std::vector<std::string> streams;
  std::uint64_t messages = 0, seen = 0;
  auto texts = std::make_shared<std::vector<LogEntry>>();
  for (const auto& stream : overview.streams) {
    if (stream.type != "foxglove.Log") continue;
    streams.push_back(stream.path);
    messages += stream.count;
  }
  if (!streams.empty()) {
    logplayer::LogFile::Cursor cursor(log_, streams);
    while (const auto message = cursor.next()) {
      if (!report(overview, static_cast<double>(++seen) / static_cast<double>(std::max(seen, messages))))
        return;
      const auto* log = dynamic_cast<const foxglove::Log*>(message->value.get());
      if (log == nullptr) continue;
      if (texts->size() < kMaxTexts) texts->push_back(loggedEntry(*message, *log));
      if (log->level() < foxglove::Log::WARNING) continue;
      if (overview.said.size() < kMaxSaid) {
        overview.said.push_back(loggedEntry(*message, *log));
      } else {
        ++overview.saidLeftOut;
      }
    }
  }
  overview.texts = std::move(texts);
  overview.stage = Stage::kSizes;
  overview.progress = 0;
  publish(overview);
}

void LogReader::countSizes(LogOverview& overview) {
  const auto counted = log_->countBytes([&](double share) { return report(overview, share); });
  if (stop_.stop_requested()) return;
  for (const auto& stream : counted) {
    for (auto& shown : overview.streams) {
      if (shown.path == stream.path) shown.bytes = stream.bytes;
    }
  }
  // Some damage is found only by reading everything.
  overview.damage = QString::fromStdString(log_->damageText());
  overview.stage = Stage::kDone;
  overview.progress = 1;
  publish(overview);
}

void LogReader::wantThumbnails(const std::string& stream, std::vector<Instant> times, int height) {
  const std::lock_guard lock(mutex_);
  if (stream != wanted_.stream) thumbnails_.clear();
  wanted_ = {stream, std::move(times), height};
  if (log_) thumbnailWorker_.post(wanted_);
}

std::vector<LogThumbnail> LogReader::takeThumbnails() {
  const std::lock_guard lock(mutex_);
  return std::exchange(thumbnails_, {});
}

void LogReader::readThumbnails(const Wanted& wanted, const std::stop_token& stop) {
  for (const Instant time : wanted.times) {
    if (stop.stop_requested()) return;
    QImage image = thumbnail(wanted.stream, time, wanted.height);
    const std::lock_guard lock(mutex_);
    if (wanted.stream == wanted_.stream) thumbnails_.push_back({time, std::move(image)});
  }
}

QImage LogReader::thumbnail(const std::string& stream, Instant time, int height) {
  const auto message = log_->latest(stream, time);
  return message ? thumbnailOf(message->value, height) : QImage();
}

}  // namespace widgets
