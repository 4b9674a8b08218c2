// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <dds/dds.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "DdsPackage.h"
#include "robotlink/base/Error.h"

namespace robotlink::dds {

/// The network-wide identifier of a DDS reader or writer.
using Guid = std::array<std::uint8_t, 16>;
Guid guidOf(dds_entity_t entity);

/// A sample as Cyclone DDS reads it, with the memory of its fields; used again for the next one.
struct Sample {
  Sample() = default;
  ~Sample();
  Sample(const Sample&) = delete;
  Sample& operator=(const Sample&) = delete;

  robotlink_wire_Package package{};
};

/// A reader, writer or topic that is deleted with its owner. Deleting waits for calls of its listener.
class Entity {
 public:
  Entity() = default;
  explicit Entity(dds_entity_t handle) : handle_(handle) {}
  ~Entity() { reset(); }
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept;

  dds_entity_t get() const { return handle_; }
  bool valid() const { return handle_ > 0; }
  /// Stops the calls of the entity's listener; waits for those in progress.
  void silence();
  void reset();

 private:
  dds_entity_t handle_ = 0;
};

/// How the samples of a topic are passed on; all of them reliably.
enum class History : std::uint8_t {
  /// Only the newest sample counts.
  kNewest,
  /// Readers get all; those that come later get the newest of each writer.
  kLatched
};

/// The two ends of topics. Names may have all characters of names of packages and processes. Fails with the
/// text of Cyclone DDS.
Result<Entity> openReader(dds_entity_t participant, const std::string& topic, History history);
Result<Entity> openWriter(dds_entity_t participant, const std::string& topic, History history);

/// Writes a sample; its strings and bytes are only read. Returns whether it was accepted.
struct Outgoing {
  const std::string& name;
  const std::string& type;
  const std::string& sender;
  std::uint64_t fingerprint = 0;
  std::uint64_t number = 0;
  std::int64_t time = 0;
  std::uint8_t kind = 0;
  const void* data = nullptr;
  std::size_t size = 0;
};
bool write(dds_entity_t writer, const Outgoing& outgoing);

/// Takes the next sample of a reader; nothing if there is none. Samples that only tell that a writer has gone
/// are left out. The result is the handle of the writer.
std::optional<std::uint64_t> take(dds_entity_t reader, Sample& into);

/// The answer of a receiving end to the sending end: always its whole state.
struct Answer {
  enum class State : std::uint8_t { kOpen = 1, kClosed = 2, kRefused = 3 };
  State state = State::kOpen;
  /// The writer that it listens to, and its own reader.
  Guid writer{};
  Guid reader{};
  /// The number of the last package that its process has taken.
  std::uint64_t taken = 0;
};
/// Null unless the sample is an answer.
std::optional<Answer> answerIn(const robotlink_wire_Package& sample);
bool writeAnswer(dds_entity_t writer, const std::string& package, const std::string& receiver,
                 const Answer& answer);

}  // namespace robotlink::dds
