// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/RecordingFetch.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/core/platform/JsonOutput.h"
#include "app/core/recordings/RecordingFolder.h"
#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/Source.h"
#include "robotlink/foxglove/client/Client.h"

namespace app {
namespace {

using nlohmann::json;
using robotlink::failure;
using robotlink::Result;
using Clock = std::chrono::steady_clock;

/// Small enough that others get through between two of them on a slow line.
constexpr std::uint64_t kPieceBytes = 64U << 10U;
/// This many pieces are requested at once, so that a long round trip costs little.
constexpr std::size_t kPiecesUnderWay = 4;
/// In seconds since 1970, as Instants can have them.
constexpr double kMaxModified = 9e9;
/// The pause before a call is repeated.
constexpr std::chrono::milliseconds kPause{200};

bool isOfLine(const robotlink::Error& error) {
  return error.id != robotlink::websocket::kServiceFailure;
}

tl::unexpected<robotlink::Error> strange(const std::string& service) {
  return failure("recordings.answer", "the robot's answer to " + service + " is not understood");
}

tl::unexpected<robotlink::Error> canceled() {
  return failure("canceled", "canceled");
}

template <typename Number>
std::optional<Number> numberIn(const json& object, const char* member) {
  const auto found = object.find(member);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  if (!std::is_floating_point_v<Number> && !found->is_number_unsigned()) return std::nullopt;
  return found->get<Number>();
}

}  // namespace

/// The file that grows, with the checksum of what it has.
struct RecordingFetch::Part {
  static Result<Part> open(std::filesystem::path path) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0)
      return failure("file.io", std::string("cannot be written: ") + std::strerror(errno),
                     {path.string(), 0, 0});
    return Part(std::move(path), descriptor);
  }
  Part(std::filesystem::path file, int opened) : path(std::move(file)), descriptor(opened) {}
  Part(Part&& other) noexcept
      : path(std::move(other.path)), descriptor(std::exchange(other.descriptor, -1)), is(other.is) {}
  Part& operator=(Part&&) = delete;
  ~Part() {
    if (descriptor >= 0) ::close(descriptor);
  }

  tl::unexpected<robotlink::Error> problem() const {
    return failure("file.io",
                   std::string("cannot be written: ") + std::strerror(errno) +
                       "; what was downloaded is kept, and the next try resumes there",
                   {path.string(), 0, 0});
  }
  Result<void> append(std::string_view bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t written =
          ::pwrite(descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(is.bytes + done));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return problem();
      done += static_cast<std::size_t>(written);
    }
    is.crc =
        logplayer::mcap::crc32({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, is.crc);
    is.bytes += bytes.size();
    return {};
  }
  /// Computes the checksum of what is there.
  void look() {
    const auto source = logplayer::mcap::Source::open(path);
    is = {};
    while (source && is.bytes < source->bytes()) {
      const auto piece = source->read(is.bytes, 1U << 20U);
      if (piece.empty()) break;
      is.crc = logplayer::mcap::crc32(piece, is.crc);
      is.bytes += piece.size();
    }
  }
  Result<void> clear() {
    is = {};
    if (::ftruncate(descriptor, 0) != 0) return problem();
    return {};
  }

  std::filesystem::path path;
  int descriptor;
  Checksum is;
};

// ---- Calls

RecordingFetch::RecordingFetch(Call call, std::chrono::milliseconds patience)
    : call_(std::move(call)), patience_(patience) {}

RecordingFetch::Answer RecordingFetch::ask(const std::string& service, const std::string& argument,
                                           const Progress& progress, double share) {
  const auto end = Clock::now() + patience_;
  const auto proceed = [&] { return !progress || progress(share); };
  while (true) {
    auto answer = PendingAnswer(call_, service, argument).wait(proceed);
    if (!answer) return canceled();
    if (*answer || !isOfLine(answer->error()) || Clock::now() > end) return *answer;
    std::this_thread::sleep_for(kPause);
    if (!proceed()) return canceled();
  }
}

Result<std::vector<RecordingFetch::Entry>> RecordingFetch::list(const Progress& progress) {
  constexpr char kService[] = "recordings/list";
  const Answer answer = ask(kService, "{}", progress, 0);
  if (!answer) return tl::unexpected(answer.error());
  const auto object = json::parse(*answer, nullptr, false);
  const auto all = object.is_object() ? object.find("recordings") : object.end();
  if (!object.is_object() || all == object.end() || !all->is_array()) return strange(kService);
  std::vector<Entry> entries;
  for (const json& entry : *all) {
    if (!entry.is_object()) return strange(kService);
    const auto name = entry.find("name");
    const auto recording = entry.find("recording");
    const auto bytes = numberIn<std::uint64_t>(entry, "bytes");
    if (name == entry.end() || !name->is_string() || !bytes) return strange(kService);
    const auto& file = name->get_ref<const std::string&>();
    // A robot does not choose where its recordings are written here.
    if (!RecordingFolder::isName(file)) continue;
    const double modified = std::clamp(numberIn<double>(entry, "modified").value_or(0), 0.0, kMaxModified);
    entries.push_back({file, *bytes, modified, recording != entry.end() && *recording == json(true),
                       entry.value("whole", json(true)) != json(false)});
  }
  return entries;
}

Result<RecordingFetch::Checksum> RecordingFetch::check(const std::string& name, std::uint64_t bytes,
                                                       const Progress& progress, double share) {
  constexpr char kService[] = "recordings/check";
  const Answer answer = ask(kService, jsonMessage(json{{"name", name}, {"bytes", bytes}}), progress, share);
  if (!answer) return tl::unexpected(answer.error());
  const auto object = json::parse(*answer, nullptr, false);
  if (!object.is_object()) return strange(kService);
  const auto checked = numberIn<std::uint64_t>(object, "bytes");
  const auto crc = numberIn<std::uint32_t>(object, "crc32");
  if (!checked || !crc) return strange(kService);
  return Checksum{*checked, *crc};
}

Result<void> RecordingFetch::resume(const std::string& name, Part& part, const Progress& progress) {
  part.look();
  if (part.is.bytes == 0) return {};
  const auto theirs = check(name, part.is.bytes, progress, 0);
  if (!theirs) return tl::unexpected(theirs.error());
  const bool same = theirs->bytes == part.is.bytes && theirs->crc == part.is.crc;
  return same ? Result<void>() : part.clear();
}

Result<void> RecordingFetch::read(const std::string& name, Part& part, std::uint64_t bytes,
                                  const Progress& progress) {
  const auto share = [&] { return static_cast<double>(part.is.bytes) / static_cast<double>(bytes); };
  const auto proceed = [&] { return !progress || progress(share()); };
  std::deque<PendingAnswer> underWay;
  std::uint64_t asked = part.is.bytes;
  auto end = Clock::now() + patience_;
  while (part.is.bytes < bytes) {
    for (; asked < bytes && underWay.size() < kPiecesUnderWay; asked += kPieceBytes) {
      const std::uint64_t size = std::min(kPieceBytes, bytes - asked);
      underWay.emplace_back(call_, "recordings/read",
                            jsonMessage(json{{"name", name}, {"offset", asked}, {"bytes", size}}));
    }
    const auto answer = underWay.front().wait(proceed);
    if (!answer || !proceed()) return canceled();
    underWay.pop_front();
    if (*answer) {
      const std::uint64_t expected = std::min(kPieceBytes, bytes - part.is.bytes);
      if ((*answer)->size() != expected) return strange("recordings/read");
      if (const auto written = part.append(**answer); !written) return written;
      end = Clock::now() + patience_;
      continue;
    }
    if (!isOfLine(answer->error()) || Clock::now() > end) return tl::unexpected(answer->error());
    // The other requested pieces are lost, too.
    underWay.clear();
    asked = part.is.bytes;
    std::this_thread::sleep_for(kPause);
  }
  return {};
}

Result<RecordingFetch::Fetched> RecordingFetch::fetch(const std::string& name,
                                                      const std::filesystem::path& file, bool replaces,
                                                      const Progress& progress) {
  std::error_code error;
  if (!replaces && std::filesystem::exists(file, error))
    return failure("file.exists", "exists already; choose another name, or replace it with --force",
                   {file.string(), 0, 0});
  const auto now = check(name, 0, progress, 0);
  if (!now) return tl::unexpected(now.error());
  const auto entries = list(progress);
  if (!entries) return tl::unexpected(entries.error());
  const auto entry = std::ranges::find(*entries, name, &Entry::name);
  if (entry == entries->end()) return strange("recordings/list");
  auto part = Part::open(file.string() + ".part");
  if (!part) return tl::unexpected(part.error());
  if (const auto resumed = resume(name, *part, progress); !resumed) return tl::unexpected(resumed.error());
  const Fetched fetched{std::max(entry->bytes, part->is.bytes), part->is.bytes};
  if (const auto done = read(name, *part, fetched.bytes, progress); !done)
    return tl::unexpected(done.error());
  const auto theirs = check(name, fetched.bytes, progress, 1);
  if (!theirs) return tl::unexpected(theirs.error());
  if (theirs->bytes != part->is.bytes || theirs->crc != part->is.crc) {
    static_cast<void>(part->clear());
    return failure("recordings.changed",
                   "the recording '" + name + "' was changed while it was fetched; fetch it again", {},
                   {name});
  }
  if (::fsync(part->descriptor) != 0) return part->problem();
  std::filesystem::rename(part->path, file, error);
  if (error) return failure("file.io", "cannot be written: " + error.message(), {file.string(), 0, 0});
  return fetched;
}

Result<void> RecordingFetch::start(const Progress& progress) {
  const Answer answer = ask("recordings/start", "{}", progress, 0);
  if (!answer) return tl::unexpected(answer.error());
  return {};
}

Result<void> RecordingFetch::stop(const Progress& progress) {
  const Answer answer = ask("recordings/stop", "{}", progress, 0);
  if (!answer) return tl::unexpected(answer.error());
  return {};
}

Result<void> RecordingFetch::remove(const std::string& name, const Progress& progress) {
  const Answer answer = ask("recordings/delete", jsonMessage(json{{"name", name}}), progress, 0);
  if (!answer) return tl::unexpected(answer.error());
  return {};
}

RecordingFetch::Call callsOf(robotlink::websocket::Client& client) {
  return [&client](const std::string& service, const std::string& argument,
                   std::function<void(RecordingFetch::Answer)> handler) {
    using Answered = robotlink::websocket::Client::Answer;
    client.call({service, "json", argument}, [handler = std::move(handler)](Result<Answered> answer) {
      handler(answer ? RecordingFetch::Answer(std::move(answer->data)) : tl::unexpected(answer.error()));
    });
  };
}

}  // namespace app
