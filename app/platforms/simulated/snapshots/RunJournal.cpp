// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/snapshots/RunJournal.h"

#include <algorithm>

#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/base/bytes/ByteWriter.h"

namespace app {
namespace {

bool takeRequest(robotlink::ByteReader& reader, robotcontrol::Request& request) {
  const std::string_view bytes = reader.takeText();
  return reader.good() && request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
}

}  // namespace

void RunJournal::begin(std::uint64_t seed, std::string settings,
                       std::vector<robotcontrol::Request> overrides) {
  *this = {};
  seed_ = seed;
  settings_ = std::move(settings);
  overrides_ = std::move(overrides);
}

void RunJournal::add(std::uint64_t step, const robotcontrol::Request& request) {
  if (!spoiled_.empty()) return;
  bytes_ += sizeof(Entry) + request.ByteSizeLong();
  if (bytes_ > kMaxBytes) return spoil("there were more requests than are kept");
  entries_.push_back({step, request});
}

void RunJournal::spoil(std::string reason) {
  if (!spoiled_.empty()) return;
  spoiled_ = std::move(reason);
  entries_.clear();
}

std::vector<std::uint8_t> RunJournal::encode() const {
  std::vector<std::uint8_t> out;
  robotlink::ByteWriter writer(out);
  writer.put(seed_);
  writer.put(std::string_view(settings_));
  writer.put(std::string_view(spoiled_));
  writer.put(static_cast<std::uint32_t>(overrides_.size()));
  for (const auto& request : overrides_) writer.put(std::string_view(request.SerializeAsString()));
  writer.put(static_cast<std::uint32_t>(entries_.size()));
  for (const Entry& entry : entries_) {
    writer.put(entry.step);
    writer.put(std::string_view(entry.request.SerializeAsString()));
  }
  return out;
}

robotlink::Result<RunJournal> RunJournal::decode(const std::vector<std::uint8_t>& bytes) {
  RunJournal journal;
  robotlink::ByteReader reader(bytes);
  journal.seed_ = reader.take<std::uint64_t>();
  journal.settings_ = reader.takeText();
  journal.spoiled_ = reader.takeText();
  bool good = true;
  const auto overrides = reader.take<std::uint32_t>();
  for (std::uint32_t i = 0; good && i < overrides; ++i)
    good = takeRequest(reader, journal.overrides_.emplace_back());
  const auto entries = good ? reader.take<std::uint32_t>() : 0;
  for (std::uint32_t i = 0; good && i < entries; ++i) {
    Entry& entry = journal.entries_.emplace_back();
    entry.step = reader.take<std::uint64_t>();
    good = takeRequest(reader, entry.request);
  }
  if (!good || !reader.complete() ||
      !std::ranges::is_sorted(journal.entries_, {}, [](const Entry& entry) { return entry.step; }))
    return robotlink::failure("snapshot.damaged", "the requests to the programs cannot be read");
  return journal;
}

}  // namespace app
