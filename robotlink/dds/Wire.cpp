// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/Wire.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>

namespace robotlink::dds {
namespace {

/// How long a write may wait for readers that are slow.
constexpr dds_duration_t kMaxBlocking = DDS_MSECS(20);

/// DDS permits letters, digits, '_' and '/'; other characters become "_" with their code, and "_" is
/// doubled.
std::string topicName(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '/') {
      result += c;
    } else if (c == '_') {
      result += "__";
    } else {
      char code[4];
      std::snprintf(code, sizeof code, "_%02x", byte);
      result += code;
    }
  }
  return result;
}

struct QosDeleter {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};

std::unique_ptr<dds_qos_t, QosDeleter> qosOf(History history, bool isReader) {
  std::unique_ptr<dds_qos_t, QosDeleter> qos(dds_create_qos());
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, kMaxBlocking);
  dds_qset_durability(
      qos.get(), history == History::kLatched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  const bool keepsAll = history == History::kLatched && isReader;
  dds_qset_history(qos.get(), keepsAll ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST, keepsAll ? 0 : 1);
  return qos;
}

Result<Entity> opened(dds_entity_t handle, const std::string& topic) {
  if (handle >= 0) return Entity(handle);
  return failure("dds.topic", "DDS refuses the topic " + topic + ": " + dds_strretcode(handle));
}

/// Cyclone DDS declares its strings as mutable, but only reads those that are written.
char* mutableText(const std::string& text) {
  return const_cast<char*>(text.c_str());
}

}  // namespace

Guid guidOf(dds_entity_t entity) {
  Guid result{};
  dds_guid_t guid{};
  if (dds_get_guid(entity, &guid) == DDS_RETCODE_OK) std::copy_n(guid.v, result.size(), result.begin());
  return result;
}

Sample::~Sample() {
  dds_sample_free(&package, &robotlink_wire_Package_desc, DDS_FREE_CONTENTS);
}

Entity& Entity::operator=(Entity&& other) noexcept {
  if (this != &other) {
    reset();
    handle_ = std::exchange(other.handle_, 0);
  }
  return *this;
}

void Entity::silence() {
  if (valid()) dds_set_listener(handle_, nullptr);
}

void Entity::reset() {
  if (valid()) dds_delete(handle_);
  handle_ = 0;
}

Result<Entity> openReader(dds_entity_t participant, const std::string& topic, History history) {
  auto made = opened(
      dds_create_topic(participant, &robotlink_wire_Package_desc, topicName(topic).c_str(), nullptr, nullptr),
      topic);
  if (!made) return made;
  // The topic is only needed to make the reader, which keeps it.
  return opened(dds_create_reader(participant, made->get(), qosOf(history, true).get(), nullptr), topic);
}

Result<Entity> openWriter(dds_entity_t participant, const std::string& topic, History history) {
  auto made = opened(
      dds_create_topic(participant, &robotlink_wire_Package_desc, topicName(topic).c_str(), nullptr, nullptr),
      topic);
  if (!made) return made;
  return opened(dds_create_writer(participant, made->get(), qosOf(history, false).get(), nullptr), topic);
}

bool write(dds_entity_t writer, const Outgoing& outgoing) {
  robotlink_wire_Package package{};
  package.name = mutableText(outgoing.name);
  package.type = mutableText(outgoing.type);
  package.sender = mutableText(outgoing.sender);
  package.fingerprint = outgoing.fingerprint;
  package.number = outgoing.number;
  package.time = outgoing.time;
  package.kind = outgoing.kind;
  package.data._length = package.data._maximum = static_cast<std::uint32_t>(outgoing.size);
  package.data._buffer = static_cast<std::uint8_t*>(const_cast<void*>(outgoing.data));
  return dds_write(writer, &package) == DDS_RETCODE_OK;
}

std::optional<std::uint64_t> take(dds_entity_t reader, Sample& into) {
  void* samples[1] = {&into.package};
  dds_sample_info_t info{};
  while (dds_take(reader, samples, &info, 1, 1) == 1) {
    if (info.valid_data) return info.publication_handle;
  }
  return std::nullopt;
}

std::optional<Answer> answerIn(const robotlink_wire_Package& sample) {
  Answer answer;
  if (sample.data._length != answer.writer.size() + answer.reader.size()) return std::nullopt;
  if (sample.kind < 1 || sample.kind > 3) return std::nullopt;
  answer.state = static_cast<Answer::State>(sample.kind);
  std::memcpy(answer.writer.data(), sample.data._buffer, answer.writer.size());
  std::memcpy(answer.reader.data(), sample.data._buffer + answer.writer.size(), answer.reader.size());
  answer.taken = sample.number;
  return answer;
}

bool writeAnswer(dds_entity_t writer, const std::string& package, const std::string& receiver,
                 const Answer& answer) {
  std::array<std::uint8_t, 32> data{};
  std::copy(answer.writer.begin(), answer.writer.end(), data.begin());
  std::copy(answer.reader.begin(), answer.reader.end(), data.begin() + 16);
  static const std::string kNone;
  return write(writer, {.name = package,
                        .type = kNone,
                        .sender = receiver,
                        .number = answer.taken,
                        .kind = static_cast<std::uint8_t>(answer.state),
                        .data = data.data(),
                        .size = data.size()});
}

}  // namespace robotlink::dds
