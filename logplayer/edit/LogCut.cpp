// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/LogCut.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <tuple>

#include "logplayer/base/MessageChange.h"
#include "logplayer/base/OutputFile.h"
#include "logplayer/bookmarks/BookmarkStorage.h"
#include "logplayer/edit/LogJoin.h"
#include "logplayer/edit/LogSource.h"
#include "logplayer/edit/MessageCopier.h"
#include "logplayer/mcap/write/Writer.h"
#include "robotlink/debugging/Streams.h"

namespace logplayer {
namespace {

using robotlink::Duration;
using robotlink::Instant;
using robotlink::Result;

constexpr double kOpeningShareOfCut = 0.2;  // of the progress, as most logs need no scan
constexpr std::uint64_t kUnitsPerProgress = 256;
constexpr std::size_t kCacheBytes = 64U << 20U;  // for all inputs together

tl::unexpected<robotlink::Error> givenUp() {
  return robotlink::failure("log.given-up", "canceled; nothing was written");
}

struct Input {
  explicit Input(LogSource opened) : source(std::move(opened)) {}

  LogSource source;
  Duration offset{0};
  std::map<std::string, std::string> names;  // new names of robots, by the old ones
  std::optional<LogSeam> seam;               // with the previous part
  std::optional<MessageCopier> copier;
  std::optional<LogUnit> unit;  // the next unit to write
  bool begun = false;           // whether reading has begun

  /// The time of the next unit, or a lower bound of it; only for inputs that have not ended.
  Instant nextTime() { return (begun ? unit->time : source.reader().statistics().messageStart) + offset; }
};

/// Performs one call of rewriteLogs().
class Rewriting {
 public:
  explicit Rewriting(const RewriteOptions& options) : options_(options) {}
  Result<RewriteReport> run(const std::filesystem::path& to);

 private:
  Result<void> openInputs();
  Result<void> join();
  Result<void> write(const std::filesystem::path& to);
  void nameRobots(Input& input);
  void choose(Input& input);
  Result<void> writeHeld();
  Input* nextInput();
  Result<void> writeUnits();
  Result<void> writeUnit(Input& input, const LogUnit& unit);
  static bool isRepeated(Input& input, const mcap::Message& message);
  Result<void> writeRest();
  Result<void> writeAttachments(Input& input);
  Result<void> writeAllBookmarks();
  Result<void> writeOrigin(const Input& input);
  bool anythingThere() const;
  tl::unexpected<robotlink::Error> nothingLeft() const;
  bool reportProgress();
  void conclude();

  const RewriteOptions& options_;
  std::vector<std::unique_ptr<Input>> inputs_;
  std::set<std::tuple<std::string, Instant, std::size_t>>
      attachments_;                              // name, time and hash of the attachments written
  std::string whyBeside_;                        // why the logs are not concatenated
  std::set<std::string> robots_, worldStreams_;  // of all inputs so far
  std::unique_ptr<mcap::Writer> writer_;
  RewriteReport report_;
};

Result<RewriteReport> Rewriting::run(const std::filesystem::path& to) {
  if (options_.from && options_.to && *options_.to < *options_.from) {
    return robotlink::failure("log.range", "the range ends before it begins");
  }
  auto output = OutputFile::create(to, options_.overwrite);
  if (!output) return tl::unexpected(output.error());
  if (const auto opened = openInputs(); !opened) return tl::unexpected(opened.error());
  if (const auto written = write(output->temporary()); !written)
    return tl::unexpected(output->named(written.error()));
  conclude();
  if (const auto named = output->commit(); !named) return tl::unexpected(named.error());
  return std::move(report_);
}

Result<void> Rewriting::write(const std::filesystem::path& to) {
  mcap::Writer::Options options;
  options.compression = options_.compression;
  options.chunkBytes = options_.chunkBytes;
  options.library = "robotcontrol";
  auto writer = mcap::Writer::create(to, options);
  if (!writer) return tl::unexpected(writer.error());
  writer_ = std::move(*writer);
  for (const auto& input : inputs_) {
    input->copier.emplace(input->source.reader(), *writer_, input->offset,
                          MessageChange(input->offset, input->names));
  }
  for (const auto step : {&Rewriting::writeHeld, &Rewriting::writeUnits, &Rewriting::writeRest}) {
    if (const auto done = (this->*step)(); !done) return tl::unexpected(done.error());
  }
  return writer_->close();
}

Result<void> Rewriting::openInputs() {
  const auto count = static_cast<double>(options_.inputs.size());
  for (const RewriteInput& wanted : options_.inputs) {
    const double before = static_cast<double>(inputs_.size()) / count;
    const auto progress = [&](double share) {
      return !options_.progress || options_.progress(kOpeningShareOfCut * (before + share / count));
    };
    auto source = LogSource::open(wanted.file, progress, kCacheBytes / options_.inputs.size());
    if (!source) return tl::unexpected(source.error());
    auto input = std::make_unique<Input>(std::move(*source));
    input->offset = wanted.offset;
    const auto& statistics = input->source.reader().statistics();
    if (statistics.messageCount > 0 &&
        (statistics.messageStart + wanted.offset).time_since_epoch().count() < 0) {
      return robotlink::failure("log.offset",
                                "with an offset of " + std::to_string(robotlink::seconds(wanted.offset)) +
                                    " s it would begin before time 0; shift the other logs forward instead",
                                {wanted.file.string(), 0, 0});
    }
    inputs_.push_back(std::move(input));
  }
  if (const auto joined = join(); !joined) return joined;
  for (const auto& input : inputs_) {
    if (!report_.concatenated) nameRobots(*input);
    choose(*input);
  }
  return {};
}

/// Decides whether the inputs are parts of one log, and sorts them by time.
Result<void> Rewriting::join() {
  const bool moved = std::any_of(inputs_.begin(), inputs_.end(),
                                 [](const auto& input) { return input->offset.count() != 0; });
  if (inputs_.size() < 2 || options_.joining == Joining::kSeparate) return {};
  if (moved && options_.joining == Joining::kAutomatic) return {};  // parts of one log have the same clock
  const auto part = [](Input& input) { return LogPart{input.source, input.offset}; };
  std::vector<Input*> parts;
  for (const auto& input : inputs_) {
    if (input->source.reader().statistics().messageCount > 0) parts.push_back(input.get());
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [&](Input* a, Input* b) { return part(*a).begin() < part(*b).begin(); });
  std::string why;
  for (std::size_t i = 1; i < parts.size() && why.empty(); ++i)
    why = whyNotJoined(part(*parts[i - 1]), part(*parts[i]));
  if (why.empty()) {
    report_.concatenated = true;
    for (std::size_t i = 1; i < parts.size(); ++i)
      parts[i]->seam.emplace(part(*parts[i - 1]), part(*parts[i]));
    std::stable_sort(inputs_.begin(), inputs_.end(),
                     [&](const auto& a, const auto& b) { return part(*a).begin() < part(*b).begin(); });
  } else if (options_.joining == Joining::kConcatenate) {
    return robotlink::failure("log.join", "the logs cannot be joined one after another: " + why,
                              {parts.back()->source.file().string(), 0, 0});
  } else {
    whyBeside_ = why;
  }
  return {};
}

void Rewriting::nameRobots(Input& input) {
  auto& names = input.names;
  for (const std::string& robot : input.source.robots()) {
    std::string name = robot;
    for (int number = 2; robots_.contains(name); ++number) name = robot + "-" + std::to_string(number);
    if (name == robot) continue;
    names[robot] = name;
    report_.renamed[input.source.file().filename().string() + ": " + robot] = name;
  }
  for (const std::string& robot : input.source.robots())
    robots_.insert(names.contains(robot) ? names[robot] : robot);
}

// Streams without a robot are copied from one input only; otherwise a robot would be at two places at the
// same time.
void Rewriting::choose(Input& input) {
  StreamFilter streams = options_.streams;
  std::set<std::string> own;
  std::string left;
  for (const auto& [id, channel] : input.source.reader().channels()) {
    const std::string& path = channel.topic;
    if (path.find('/') != std::string::npos || path == robotlink::streams::kBookmarks) continue;
    if (worldStreams_.contains(path) && !report_.concatenated) {
      if (streams.has(path)) left += (left.empty() ? "" : ", ") + path;
      streams.exclude.push_back(path);
    } else {
      own.insert(path);
    }
  }
  worldStreams_.merge(own);
  if (!left.empty()) {
    report_.notes.push_back(input.source.file().string() + ": " + left +
                            " left out, because an earlier log has them");
  }
  const auto moved = [&](std::optional<Instant> time) {
    return time ? std::optional(*time - input.offset) : time;
  };
  input.source.choose(moved(options_.from), moved(options_.to), streams);
}

// Writes the latched messages before the first frame, at the start of the new log; publish_time is the
// original time.
Result<void> Rewriting::writeHeld() {
  writer_->beginGroup();
  for (const auto& input : inputs_) {
    for (const auto& data : input->source.held()) {
      mcap::Message message = data.message;
      message.logTime = *options_.from - input->offset;
      message.sequence = 0;
      if (const auto written = input->copier->copy(message); !written) return written;
    }
  }
  return writer_->endGroup();
}

/// The input with the next unit; null at the end. An input is opened for reading when its time comes, so that
/// consecutive logs are not in memory at the same time.
Input* Rewriting::nextInput() {
  while (true) {
    Input* first = nullptr;
    for (const auto& input : inputs_) {
      if ((input->unit || !input->begun) && (!first || input->nextTime() < first->nextTime()))
        first = input.get();
    }
    if (!first || first->begun) return first;
    first->begun = true;
    first->unit = first->source.next();
  }
}

Result<void> Rewriting::writeUnits() {
  for (std::uint64_t count = 0;; ++count) {
    Input* const first = nextInput();
    if (!first) return count > 0 || !anythingThere() ? Result<void>() : nothingLeft();
    if (const auto written = writeUnit(*first, *first->unit); !written) return written;
    first->unit = first->source.next();
    if (count % kUnitsPerProgress == 0 && !reportProgress()) return givenUp();
  }
}

bool Rewriting::anythingThere() const {
  return std::any_of(inputs_.begin(), inputs_.end(),
                     [](const auto& input) { return input->source.reader().statistics().messageCount > 0; });
}

tl::unexpected<robotlink::Error> Rewriting::nothingLeft() const {
  const auto& statistics = inputs_.front()->source.reader().statistics();
  const auto text = [&](Instant time) {
    return std::to_string(robotlink::seconds(time + inputs_.front()->offset));
  };
  return robotlink::failure(
      "log.nothing",
      "nothing would be left: no chosen stream has a message in the range; the log goes from " +
          text(statistics.messageStart) + " s to " + text(statistics.messageEnd) + " s",
      {inputs_.front()->source.file().string(), 0, 0});
}

bool Rewriting::isRepeated(Input& input, const mcap::Message& message) {
  if (!input.seam) return false;
  mcap::Reader& reader = input.source.reader();
  const mcap::Channel& channel = reader.channels().at(message.channelId);
  const auto schema = reader.schemas().find(channel.schemaId);
  return input.seam->isRepeated(channel, schema == reader.schemas().end() ? "" : schema->second.name,
                                message);
}

Result<void> Rewriting::writeUnit(Input& input, const LogUnit& unit) {
  writer_->beginGroup();
  bool any = false;
  for (const auto& data : unit.messages) {
    if (isRepeated(input, data.message)) continue;
    any = true;
    if (const auto written = input.copier->copy(data.message); !written) return written;
  }
  if (unit.frame && any) ++report_.frames;
  return writer_->endGroup();
}

/// Messages that two parts of one log contain are written once.
Result<void> Rewriting::writeRest() {
  if (const auto written = writeAllBookmarks(); !written) return written;
  std::vector<mcap::Metadata> known;
  for (const auto& input : inputs_) {
    if (const auto written = writeAttachments(*input); !written) return written;
    for (const mcap::Metadata& metadata : input->source.reader().metadata()) {
      if (std::find(known.begin(), known.end(), metadata) != known.end()) continue;
      known.push_back(metadata);
      if (const auto written = writer_->addMetadata(metadata); !written) return written;
    }
    if (const auto written = writeOrigin(*input); !written) return written;
  }
  return {};
}

Result<void> Rewriting::writeAttachments(Input& input) {
  mcap::Reader& reader = input.source.reader();
  for (const std::string& name : reader.attachmentNames()) {
    const auto attachment = reader.attachment(name);
    if (!attachment) {
      report_.losses.push_back(input.source.file().string() + ": " + attachment.error().text);
      continue;
    }
    const auto hash = std::hash<std::string>{}(attachment->mediaType + "\n" + attachment->data);
    if (!attachments_.insert({name, attachment->createTime, hash}).second) continue;
    if (const auto written = writer_->attach(*attachment); !written) return written;
  }
  return {};
}

Result<void> Rewriting::writeAllBookmarks() {
  const StreamFilter notExcluded{{}, options_.streams.exclude};
  if (!notExcluded.has(robotlink::streams::kBookmarks)) return {};
  BookmarkChanges bookmarks;
  for (const auto& input : inputs_) {
    for (Bookmark bookmark : input->source.bookmarks()) {
      bookmark.from = std::max(bookmark.from + input->offset, options_.from.value_or(Instant::min()));
      bookmark.to = std::min(bookmark.to + input->offset, options_.to.value_or(Instant::max()));
      if (bookmark.to < bookmark.from) continue;  // the bookmark is outside of the range
      const auto same = bookmarks.find(bookmark.id);
      if (report_.concatenated && same != bookmarks.end() && same->second->text == bookmark.text) {
        bookmark.from = std::min(bookmark.from, same->second->from);  // the bookmark was split in two
        bookmark.to = std::max(bookmark.to, same->second->to);
        bookmarks.erase(same);
      }
      while (bookmarks.contains(bookmark.id)) ++bookmark.id;
      bookmarks[bookmark.id] = bookmark;
    }
  }
  report_.bookmarks = bookmarks.size();
  return writeBookmarks(*writer_, bookmarks);
}

Result<void> Rewriting::writeOrigin(const Input& input) {
  mcap::Metadata origin{"robotcontrol.origin", {{"file", input.source.file().filename().string()}}};
  const auto note = [&](const char* name, const std::string& value) { origin.values[name] = value; };
  if (options_.from) note("from_ns", std::to_string(options_.from->time_since_epoch().count()));
  if (options_.to) note("to_ns", std::to_string(options_.to->time_since_epoch().count()));
  if (input.offset.count() != 0) note("offset_ns", std::to_string(input.offset.count()));
  return writer_->addMetadata(origin);
}

bool Rewriting::reportProgress() {
  if (!options_.progress) return true;
  double done = 0;
  for (const auto& input : inputs_) {
    const auto& statistics = input->source.reader().statistics();
    Instant begin = statistics.messageStart, end = statistics.messageEnd;
    if (options_.from) begin = std::max(begin, *options_.from - input->offset);
    if (options_.to) end = std::min(end, *options_.to - input->offset);
    const double length = robotlink::seconds(end - begin);
    const double here = robotlink::seconds(input->source.position() - begin);
    done += (input->begun && !input->unit) || length <= 0 ? 1 : std::clamp(here / length, 0.0, 1.0);
  }
  return options_.progress(kOpeningShareOfCut +
                           (1 - kOpeningShareOfCut) * done / static_cast<double>(inputs_.size()));
}

void Rewriting::conclude() {
  const auto& statistics = writer_->statistics();
  report_.messages = statistics.messageCount;
  report_.begin = statistics.messageStart;
  report_.end = statistics.messageEnd;
  report_.bytes = writer_->bytesWritten();
  const auto append = [](std::vector<std::string>& to, const std::vector<std::string>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  if (!whyBeside_.empty() && !report_.renamed.empty()) {
    report_.notes.push_back("the logs were merged in parallel, because " + whyBeside_);
  }
  for (const auto& input : inputs_) {
    append(report_.notes, input->source.notes());
    if (!input->copier->foreign().empty()) {
      report_.notes.push_back(input->source.file().string() + ": times and names within the messages of " +
                              input->copier->foreign() + " stay as they were, because they are not Protobuf");
    }
    append(report_.losses, input->source.losses());
    if (input->copier->unchanged() == 0) continue;
    report_.losses.push_back(input->source.file().string() + ": " +
                             std::to_string(input->copier->unchanged()) +
                             " messages do not fit their schemas; times and names in them stay as they were");
  }
}

}  // namespace

Result<RewriteReport> rewriteLogs(const RewriteOptions& options, const std::filesystem::path& to) {
  if (options.inputs.empty()) return robotlink::failure("log.inputs", "name at least one log");
  return Rewriting(options).run(to);
}

}  // namespace logplayer
