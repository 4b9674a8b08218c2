// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Rewind.h"

#include <algorithm>

#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/base/bytes/ByteWriter.h"

namespace simcore {
namespace {

/// Reads a command, after its step.
Rewind::Command readCommand(robotlink::ByteReader& reader) {
  Rewind::Command command;
  command.kind = static_cast<CommandKind>(reader.take<std::uint8_t>());
  command.index = reader.take<std::uint32_t>();
  command.values.resize(reader.take<std::uint16_t>());
  for (double& value : command.values) value = reader.take<double>();
  command.text = reader.takeText();
  return command;
}

}  // namespace

void Rewind::add(std::uint64_t step, std::vector<std::uint8_t> state) {
  // The last segment is complete: release the memory that bytes() does not count.
  if (!segments_.empty()) segments_.back().commands.shrink_to_fit();
  state.shrink_to_fit();
  segments_.push_back({step, std::move(state), {}});
  bytes_ += segments_.back().bytes();
  giveUpOldest();
}

void Rewind::note(std::uint64_t step, CommandKind kind, std::size_t index, std::span<const double> values,
                  const std::string& text) {
  if (segments_.empty()) return;
  Segment& last = segments_.back();
  const std::size_t before = last.commands.size();
  robotlink::ByteWriter writer(last.commands);
  writer.put(static_cast<std::uint32_t>(step - last.step));
  writer.put(static_cast<std::uint8_t>(kind));
  writer.put(static_cast<std::uint32_t>(index));
  writer.put(static_cast<std::uint16_t>(values.size()));
  for (const double value : values) writer.put(value);
  writer.put(std::string_view(text));
  bytes_ += last.commands.size() - before;
  giveUpOldest();
}

void Rewind::giveUpOldest() {
  while (bytes_ > maxBytes_ && !segments_.empty()) {
    bytes_ -= segments_.front().bytes();
    segments_.pop_front();
  }
}

void Rewind::clear() {
  segments_.clear();
  bytes_ = 0;
}

std::optional<std::uint64_t> Rewind::oldest() const {
  return segments_.empty() ? std::nullopt : std::optional(segments_.front().step);
}

Rewind::Segment& Rewind::segmentOf(std::uint64_t step) {
  const auto after = std::ranges::upper_bound(segments_, step, {}, &Segment::step);
  return *std::prev(after);
}

std::uint64_t Rewind::stateBefore(std::uint64_t step) const {
  const auto after = std::ranges::upper_bound(segments_, step, {}, &Segment::step);
  return std::prev(after)->step;
}

const std::vector<std::uint8_t>& Rewind::stateAt(std::uint64_t step) const {
  return std::ranges::lower_bound(segments_, step, {}, &Segment::step)->state;
}

void Rewind::replay(std::uint64_t from, std::uint64_t step,
                    const std::function<void(const Command&)>& apply) {
  Segment& segment = segmentOf(from);
  if (step == from) segment.next = 0;
  while (segment.next < segment.commands.size()) {
    robotlink::ByteReader reader(std::span(segment.commands).subspan(segment.next));
    const std::size_t whole = reader.rest().size();
    if (segment.step + reader.take<std::uint32_t>() > step) return;
    apply(readCommand(reader));
    segment.next += whole - reader.rest().size();
  }
}

void Rewind::forgetAfter(std::uint64_t step) {
  while (!segments_.empty() && segments_.back().step > step) {
    bytes_ -= segments_.back().bytes();
    segments_.pop_back();
  }
  if (segments_.empty()) return;
  // Commands from this step on have not been repeated.
  Segment& last = segments_.back();
  const std::size_t kept = last.step == step ? 0 : last.next;
  bytes_ -= last.commands.size() - kept;
  last.commands.resize(kept);
}

}  // namespace simcore
