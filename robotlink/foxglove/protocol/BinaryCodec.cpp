// SPDX-License-Identifier: GPL-3.0-or-later
// The binary half of MessageCodec.h: messages of the WebSocket protocol as bytes.
#include <cmath>

#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/base/bytes/ByteWriter.h"
#include "robotlink/foxglove/protocol/Fields.h"
#include "robotlink/foxglove/protocol/FrameCodec.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket {
namespace {

std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class BinaryWriter {
 public:
  template <FixedWidth Number>
  void number(Number value) {
    writer_.put(value);
  }
  void time(Instant value) { number(wireTime(value)); }
  void speed(float value) { number(value); }
  void flag(const char*, bool value) { number(static_cast<std::uint8_t>(value)); }
  template <typename Choice>
  void choice(const char*, Choice value, Choice) {
    number(static_cast<std::uint8_t>(value));
  }
  void option(const char* name, const std::optional<Instant>& value) {
    flag(name, value.has_value());
    time(value.value_or(Instant()));
  }
  void text(std::string_view value) { writer_.put(value); }
  void outcome(const std::string& error) {
    flag("status", !error.empty());
    text(error);
  }
  void rest(std::string_view value) { writer_.put(bytesOf(value)); }

  std::string bytes() const { return {bytes_.begin(), bytes_.end()}; }

 private:
  std::vector<std::uint8_t> bytes_;
  ByteWriter writer_{bytes_};
};

/// Keeps the first problem; what follows it is not used.
class BinaryReader {
 public:
  explicit BinaryReader(std::string_view bytes) : reader_(bytesOf(bytes)) {}

  template <FixedWidth Number>
  void number(Number& value) {
    value = reader_.take<Number>();
  }
  void time(Instant& value) {
    const auto count = reader_.take<std::uint64_t>();
    if (count > INT64_MAX) blame("its time is later than the year 2262");
    value = Instant(Duration(static_cast<std::int64_t>(count & INT64_MAX)));
  }
  void speed(float& value) {
    number(value);
    if (!std::isfinite(value)) blame("its speed is not a number");
  }
  void flag(const char* name, bool& value) {
    const auto byte = reader_.take<std::uint8_t>();
    if (byte > 1) blame("its " + std::string(name) + " is " + std::to_string(byte) + ", but must be 0 or 1");
    value = byte == 1;
  }
  template <typename Choice>
  void choice(const char* name, Choice& value, Choice last) {
    const auto byte = reader_.take<std::uint8_t>();
    const auto max = static_cast<std::uint8_t>(last);
    if (byte > max)
      blame("its " + std::string(name) + " is " + std::to_string(byte) + ", but must be at most " +
            std::to_string(max));
    value = static_cast<Choice>(byte > max ? max : byte);
  }
  void option(const char* name, std::optional<Instant>& value) {
    bool isThere = false;
    Instant instant;
    flag(name, isThere);
    if (isThere) {
      time(instant);
    } else {
      reader_.take<std::uint64_t>();
    }
    if (isThere) value = instant;
  }
  void text(std::string& value) {
    const std::string_view taken = reader_.takeText();
    if (taken.size() > kMaxName)
      return blame("a text in it is longer than " + std::to_string(kMaxName) + " bytes");
    value = taken;
  }
  void outcome(std::string& error) {
    bool failed = false;
    flag("status", failed);
    text(error);
    if (failed && error.empty()) error = "no reason was given";
    if (!failed) error.clear();
  }
  void rest(std::string_view& value) {
    const auto taken = reader_.take(reader_.rest().size());
    value = {reinterpret_cast<const char*>(taken.data()), taken.size()};
  }

  std::string problem() const {
    if (!reader_.good()) return "it is shorter than its fields and the lengths in it";
    if (problem_.empty() && !reader_.complete())
      return "it has " + std::to_string(reader_.rest().size()) + " bytes too many";
    return problem_;
  }

 private:
  void blame(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
  }

  ByteReader reader_;
  std::string problem_;
};

template <typename Variant>
std::string bytesOf(const Variant& message) {
  BinaryWriter writer;
  std::visit(
      [&]<typename One>(const One& one) {
        if constexpr (IsBinary<One>) {
          writer.number(One::kOpcode);
          fields(writer, one);
        }
      },
      message);
  return writer.bytes();
}

/// Reads the bytes as this message, if they have its opcode.
template <typename Message, typename Variant>
bool tryDecode(std::uint8_t opcode, std::string_view bytes, Result<Variant>& result) {
  if constexpr (IsBinary<Message>) {
    if (opcode != Message::kOpcode) return false;
    Message message;
    BinaryReader reader(bytes.substr(1));
    fields(reader, message);
    if (const std::string problem = reader.problem(); !problem.empty())
      result = failure("foxglove.binary", "the binary message with opcode " + std::to_string(opcode) +
                                              " cannot be read: " + problem);
    else
      result = std::move(message);
    return true;
  }
  return false;
}

template <typename... Messages>
Result<std::variant<Messages...>> decodeAny(std::string_view bytes, const std::variant<Messages...>*) {
  if (bytes.empty())
    return failure("foxglove.binary", "a binary message is empty: it must begin with its opcode");
  const auto opcode = static_cast<std::uint8_t>(bytes.front());
  Result<std::variant<Messages...>> result;
  if (!(tryDecode<Messages>(opcode, bytes, result) || ...))
    return failure("foxglove.binary", "there is no binary message with opcode " + std::to_string(opcode));
  return result;
}

}  // namespace

std::string encodeBinary(const ServerMessage& message) {
  return bytesOf(message);
}

std::string encodeBinary(const ClientMessage& message) {
  return bytesOf(message);
}

Result<ServerMessage> decodeServerBinary(std::string_view bytes) {
  return decodeAny(bytes, static_cast<const ServerMessage*>(nullptr));
}

Result<ClientMessage> decodeClientBinary(std::string_view bytes) {
  return decodeAny(bytes, static_cast<const ClientMessage*>(nullptr));
}

}  // namespace robotlink::websocket
