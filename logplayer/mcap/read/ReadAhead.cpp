// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/ReadAhead.h"

#include <algorithm>

#include "robotlink/base/Worker.h"

namespace logplayer::mcap {
namespace {

// Handing over a smaller section takes longer than loading it.
constexpr std::uint64_t kWorthIt = 128U << 10U;

}  // namespace

/// A thread and the section that it loads.
struct ReadAhead::Place {
  Place(const Source& source, std::size_t maxRecordBytes) : loader(source, maxRecordBytes) {}

  /// The section, until it is taken.
  std::optional<std::size_t> number;
  // The following belong to the thread while it has a job.
  ChunkLoader loader;
  Buffer records;
  Outcome outcome;
  Listing listing;
  robotlink::Worker<Section> thread{[this](const Section& section, const auto&) {
    outcome = loader.load(section, records);
    listing.overview.reset();
    if (outcome && listing.channels) listing.list(records);
  }};
};

ReadAhead::ReadAhead(const Source& source, std::size_t maxRecordBytes, std::size_t maxBytes)
    : source_(source), maxRecordBytes_(maxRecordBytes), maxBytes_(maxBytes) {}
ReadAhead::~ReadAhead() = default;

void ReadAhead::begin(std::size_t number, const Section& section, std::shared_ptr<const ChannelSet> listed) {
  const ChunkInfo& info = section.info;
  if (info.uncompressedBytes < kWorthIt || std::max(info.uncompressedBytes, info.length) > maxBytes_ ||
      find(number) != nullptr) {
    return;
  }
  auto& place = places_[next_ % kSections];
  if (!place) place = std::make_unique<Place>(source_, maxRecordBytes_);
  if (!place->thread.idle()) return;
  // The memory may be that of a section too large for this. It is allocated here, since what the same thread
  // allocates and frees is reused, rather than returned to the system.
  Buffer& records = place->records;
  if (records.capacity() < info.uncompressedBytes || records.capacity() > maxBytes_) {
    records = Buffer();
    records.reserve(static_cast<std::size_t>(info.uncompressedBytes));
  }
  place->number = number;
  place->listing.channels = std::move(listed);
  place->thread.post(section);
  ++next_;
}

std::optional<ReadAhead::Outcome> ReadAhead::take(std::size_t number, Buffer& records, Listing* listing) {
  Place* place = find(number);
  if (place == nullptr) return std::nullopt;
  place->number.reset();
  place->thread.finish();
  std::swap(records, place->records);
  if (listing != nullptr && listing->channels == place->listing.channels) std::swap(*listing, place->listing);
  return std::move(place->outcome);
}

void ReadAhead::forget() {
  for (const auto& place : places_) {
    if (place) place->number.reset();
  }
}

ReadAhead::Place* ReadAhead::find(std::size_t number) {
  for (const auto& place : places_) {
    if (place && place->number == number) return place.get();
  }
  return nullptr;
}

}  // namespace logplayer::mcap
