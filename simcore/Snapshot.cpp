// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Snapshot.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Random.h"
#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/base/bytes/ByteWriter.h"

namespace simcore {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic{'R', 'C', 'S', 'N', 'A', 'P', '\r', '\n'};
constexpr std::size_t kMaxParts = 100;

/// Detects damage; not safe against deliberate manipulation, with which reading the state must cope.
std::uint64_t checksumOf(std::span<const std::uint8_t> bytes) {
  std::uint64_t sum = bytes.size();
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8)
    sum = robotlink::mixBits(sum ^ robotlink::loadNumber<std::uint64_t>(bytes.data() + at));
  for (; at < bytes.size(); ++at) sum = robotlink::mixBits(sum ^ bytes[at]);
  return sum;
}

void putBytes(robotlink::ByteWriter& writer, const std::vector<std::uint8_t>& bytes) {
  writer.put(static_cast<std::uint64_t>(bytes.size()));
  writer.put(std::span<const std::uint8_t>(bytes));
}

std::vector<std::uint8_t> takeBytes(robotlink::ByteReader& reader) {
  const auto bytes = reader.take(reader.take<std::uint64_t>());
  return {bytes.begin(), bytes.end()};
}

auto damaged(const std::string& name) {
  return robotlink::failure("snapshot.damaged", name + " is damaged: take the snapshot again", {}, {name});
}

}  // namespace

std::size_t Snapshot::bytes() const {
  std::size_t sum = sizeof *this + scene.size() + state.size();
  for (const auto& [name, part] : parts) sum += name.size() + part.size();
  return sum;
}

std::vector<std::uint8_t> Snapshot::encode() const {
  std::vector<std::uint8_t> out;
  robotlink::ByteWriter writer(out);
  writer.put(std::span<const std::uint8_t>(kMagic));
  writer.put(kVersion);
  writer.put(std::string_view(scene));
  writer.put(fingerprint);
  writer.put(step);
  putBytes(writer, state);
  writer.put(static_cast<std::uint32_t>(parts.size()));
  for (const auto& [name, part] : parts) {
    writer.put(std::string_view(name));
    putBytes(writer, part);
  }
  writer.put(checksumOf(out));
  return out;
}

robotlink::Result<Snapshot> Snapshot::decode(std::span<const std::uint8_t> bytes, const std::string& name) {
  robotlink::ByteReader reader(bytes);
  if (const auto magic = reader.take(kMagic.size()); !std::ranges::equal(magic, kMagic)) {
    return robotlink::failure("snapshot.format", name + " is not a snapshot of a simulation", {}, {name});
  }
  if (const auto version = reader.take<std::uint32_t>(); reader.good() && version != kVersion) {
    return robotlink::failure("snapshot.version",
                              name + " is a snapshot of version " + std::to_string(version) +
                                  ", this program reads version " + std::to_string(kVersion) +
                                  ": use the program that wrote it, or take the snapshot again",
                              {}, {name});
  }
  constexpr std::size_t kSum = sizeof(std::uint64_t);
  if (bytes.size() < kMagic.size() + kSum) return damaged(name);
  const auto body = bytes.first(bytes.size() - kSum);
  if (robotlink::loadNumber<std::uint64_t>(bytes.data() + body.size()) != checksumOf(body))
    return damaged(name);
  Snapshot snapshot;
  snapshot.isForeign = true;
  snapshot.scene = reader.takeText();
  snapshot.fingerprint = reader.take<std::uint64_t>();
  snapshot.step = reader.take<std::uint64_t>();
  snapshot.state = takeBytes(reader);
  const auto count = reader.take<std::uint32_t>();
  if (count > kMaxParts) return damaged(name);
  for (std::uint32_t i = 0; i < count && reader.good(); ++i) {
    std::string part(reader.takeText());
    snapshot.parts[std::move(part)] = takeBytes(reader);
  }
  reader.take(kSum);
  if (!reader.complete()) return damaged(name);
  return snapshot;
}

robotlink::Result<void> Snapshot::write(const std::filesystem::path& file) const {
  const std::vector<std::uint8_t> bytes = encode();
  return robotlink::writeFileAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

robotlink::Result<Snapshot> Snapshot::read(const std::filesystem::path& file) {
  const auto text = robotlink::readFile(file, kMaxBytes);
  if (!text) return tl::unexpected(text.error());
  return decode({reinterpret_cast<const std::uint8_t*>(text->data()), text->size()}, file.string());
}

}  // namespace simcore
