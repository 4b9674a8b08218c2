// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace robotlink::arcos {

/// A telegram of a SICK LMS 2xx laser range finder, on its own serial line; see SICK.md, which also names the
/// public description. A plain value.
struct SickTelegram {
  /// The first byte of the contents: what is asked (0x20), or answered (0x20 + 0x80 = 0xA0).
  std::uint8_t command = 0;
  /// The data after the command, without the status that ends the telegrams of a laser.
  std::vector<std::uint8_t> data;
  /// The status byte; always 0 in telegrams to the laser, which have none.
  std::uint8_t status = 0;

  bool operator==(const SickTelegram&) const = default;
};

/// The longest contents that a laser sends: 401 readings and what is around them.
inline constexpr std::size_t kMaxSickLength = 812;

/// The checksum of a telegram from its first byte: CRC-16 with the polynomial 0x8005, as the description has
/// it.
std::uint16_t sickChecksum(std::span<const std::uint8_t> bytes);
/// The bytes of a telegram to the laser, whose address is 0; from the laser (0x80) with the status at the
/// end.
std::vector<std::uint8_t> sickRequest(const SickTelegram& telegram);
std::vector<std::uint8_t> sickReply(const SickTelegram& telegram);

/// Finds telegrams of a laser in a stream of bytes, whatever else it contains and however it is split.
///
///   parser.push(bytes);
///   while (auto found = parser.next()) { ... }   // empty: it needs more bytes
///
/// Bytes that are no telegram are skipped and counted; after a wrong checksum it continues one byte behind
/// the beginning of what claimed to be a telegram. Not thread-safe.
class SickParser {
 public:
  /// The single bytes by which a laser says whether it has understood a telegram.
  enum class Receipt : std::uint8_t { kTaken, kRefused };
  using Found = std::variant<SickTelegram, Receipt>;
  struct Counters {
    std::uint64_t telegrams = 0, checksumErrors = 0, skippedBytes = 0;
    bool operator==(const Counters&) const = default;
  };
  /// The origin of the telegrams to be found, by which their address is known.
  enum class From : std::uint8_t { kLaser, kHost };
  explicit SickParser(From from = From::kLaser) : from_(from) {}

  void push(std::span<const std::uint8_t> bytes);
  std::optional<Found> next();
  /// Drops all bytes, for a new connection; the counters keep their values.
  void clear();
  const Counters& counters() const { return counters_; }

 private:
  From from_;
  std::vector<std::uint8_t> buffer_;
  /// Start of the unread bytes in buffer_.
  std::size_t begin_ = 0;
  Counters counters_;
};

/// A sweep of the laser. Reading i is at startAngle + i * angleStep in the laser's frame, counterclockwise.
struct SickReadings {
  double startAngle = 0, angleStep = 0;  ///< rad
  /// m; 0 where the laser saw nothing or was dazzled.
  std::vector<double> ranges;
};
/// Reads a telegram with measured values (0xB0) of a laser that covers 180 degrees. `bits` of each value are
/// the distance, which depends on how the laser is set up: 13 for 8 or 80 m, 14 for 16 m, 15 for 32 m. Empty
/// if it is no such telegram, only a part of a scan, or has fewer values than it says.
std::optional<SickReadings> sickReadings(const SickTelegram& telegram, int bits);

}  // namespace robotlink::arcos
