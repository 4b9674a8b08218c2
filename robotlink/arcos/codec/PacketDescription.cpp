// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/PacketDescription.h"

#include <charconv>
#include <cstdio>
#include <string_view>

#include "robotlink/arcos/codec/ArcosCommandCatalog.h"
#include "robotlink/arcos/codec/ConfigurationFields.h"
#include "robotlink/arcos/codec/ServerPacketFields.h"
#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/codec/SimulatorCommands.h"
#include "robotlink/base/TextParts.h"

namespace robotlink::arcos {
namespace {

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[64];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// The next part of a list, without blanks before it.
std::string_view takeItem(std::string_view& text, char separator) {
  std::string_view part = takePart(text, separator);
  part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
  return part;
}

/// "motors on, , sonar" and 5: "0x05 motors on, sonar".
std::string flagNames(std::uint64_t bits, std::size_t bytes, std::string_view names) {
  std::string text =
      formatted("0x%0*llx", static_cast<int>(2 * bytes), static_cast<unsigned long long>(bits));
  const char* separator = " ";
  for (; !names.empty(); bits >>= 1U) {
    const std::string_view name = takeItem(names, ',');
    if ((bits & 1U) && !name.empty()) text += std::exchange(separator, ", ") + std::string(name);
  }
  return text;
}

/// "-127 none; 3 three" and 3: "three"; nothing if the value has no name.
std::optional<std::string> nameOfValue(std::int64_t value, std::string_view names) {
  while (!names.empty()) {
    std::string_view name = takeItem(names, ';');
    if (takeItem(name, ' ') == std::to_string(value)) return std::string(name);
  }
  return std::nullopt;
}

/// "0.1 V" as 0.1 and "V", "1/4096 turn" as 360/4096 and "deg", "mm" as 1 and "mm".
std::pair<double, std::string> factorOf(std::string_view unit) {
  double factor = 0;
  const char* end = unit.data() + unit.size();
  auto [next, problem] = std::from_chars(unit.data(), end, factor);
  if (problem != std::errc() || next == end) return {1, std::string(unit)};
  if (*next == '/') {
    double divisor = 1;
    next = std::from_chars(next + 1, end, divisor).ptr;
    factor /= divisor;
  }
  const std::string_view rest(next, static_cast<std::size_t>(end - next));
  if (rest == " turn") return {factor * 360, "deg"};
  return {factor, std::string(rest.substr(std::min<std::size_t>(1, rest.size())))};
}

std::string printable(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<std::uint8_t>(c);
    result +=
        byte >= 0x20 && byte < 0x7F ? std::string(1, c) : formatted("\\x%02x", static_cast<unsigned>(byte));
  }
  return result + '"';
}

/// The visitor (see WireFields.h) that lists fields with readable values.
class FieldLister {
 public:
  explicit FieldLister(std::vector<PacketField>& fields) : fields_(fields) {}

  template <std::integral T>
  void operator()(const char* name, const T& value, const char* unit = "") {
    if (value == 0 && std::string_view(name) == "reserved") return;
    std::string_view names(unit);
    std::string_view text = takeItem(names, ';');
    if (const auto meaning = nameOfValue(static_cast<std::int64_t>(value), names)) {
      add(name, *meaning, "");
    } else if (text.starts_with("bits")) {
      takeItem(text, ':');
      add(name, flagNames(static_cast<std::make_unsigned_t<T>>(value), sizeof(T), text), "");
    } else {
      auto [factor, unitName] = factorOf(text);
      add(name, factor == 1 ? std::to_string(value) : formatted("%.10g", static_cast<double>(value) * factor),
          std::move(unitName));
    }
  }
  void operator()(const char* name, const std::string& value, const char* = "") {
    add(name, printable(value), "");
  }
  template <typename T>
  void operator()(const char* name, const std::optional<T>& value, const char* unit = "") {
    if (value) (*this)(name, *value, unit);
  }
  template <typename T>
  void key(const char*, const T& value) {
    prefix_ = listName_ + " " + std::to_string(value);
  }
  template <std::unsigned_integral Count, typename T>
  void size(const char* name, const std::vector<T>& list) {
    add(name, std::to_string(list.size()), "");
  }
  void enter(const char* list, std::size_t index) {
    listName_ = list;
    prefix_ = listName_ + " " + std::to_string(index);
  }
  void leave() { prefix_.clear(); }
  void rest(const Bytes& bytes) {
    if (!bytes.empty()) add("bytes", toHex(bytes), "");
  }

 private:
  void add(const std::string& name, std::string value, std::string unit) {
    const char* space = prefix_.empty() || name.empty() ? "" : " ";
    fields_.push_back({prefix_ + space + name, std::move(value), std::move(unit)});
  }

  std::vector<PacketField>& fields_;
  std::string listName_;
  // The name of the list's element that is being visited.
  std::string prefix_;
};

/// Lists only the fields that a configuration has.
struct PrefixLister {
  FieldLister& lister;
  int left;
  template <typename T>
  void operator()(const char* name, const T& value, const char* unit = "") {
    if (left-- > 0) lister(name, value, unit);
  }
};

void list(const RawPacket& raw, FieldLister& lister) {
  lister.rest(raw.packet.data);
}
void list(const Configuration& configuration, FieldLister& lister) {
  PrefixLister prefix{lister, configuration.fieldCount};
  visitConfigurationFields(configuration, prefix);
  lister.rest(configuration.rest);
}
void list(const BatteryPacket& battery, FieldLister& lister) {
  lister.size<std::uint8_t>("batteries", battery.batteries);
  for (std::size_t i = 0; i < battery.batteries.size(); ++i) {
    lister.enter("battery", i);
    visitFields(battery.batteries[i], lister);
    lister.rest(battery.batteries[i].more);
    lister.leave();
  }
  lister.rest(battery.rest);
}
template <typename T>
void list(const T& packet, FieldLister& lister) {
  visitFields(packet, lister);
}

void listPair(const Command& command, const CommandInfo& info, FieldLister& lister) {
  const BytePair pair = split(integerArgument(command));
  if (command.id == static_cast<std::uint8_t>(CommandId::kVel2)) {
    lister("left", pair.high, info.unit);
    lister("right", pair.low, info.unit);
  } else {
    lister("high byte", static_cast<std::uint8_t>(pair.high), "bits");
    lister("low byte", static_cast<std::uint8_t>(pair.low), "bits");
  }
}

/// Lists the fields of a command with a layout of its own; returns false if it has none.
bool listSimulatorCommand(const Command& command, FieldLister& lister) {
  if (command.id == static_cast<std::uint8_t>(CommandId::kSimSetPose)) {
    const auto pose = truePoseOf(command);
    if (!pose) return false;
    lister("true x", pose->xMm, "mm");
    lister("true y", pose->yMm, "mm");
    lister("true heading", pose->headingDeg, "deg");
    return true;
  }
  if (command.id != static_cast<std::uint8_t>(CommandId::kSimControl)) return false;
  const auto control = simulatorControlOf(command);
  if (!control) return false;
  lister("operation", control->operation);
  if (!control->file.empty()) lister("file", control->file);
  return true;
}

void listCommand(const Command& command, const CommandInfo* info, FieldLister& lister) {
  if (listSimulatorCommand(command, lister)) return;
  if (const int* value = std::get_if<int>(&command.argument)) {
    if (info && info->argument == ArgumentType::kBytePair) {
      listPair(command, *info, lister);
    } else {
      lister("argument", *value, info ? info->unit : "");
    }
  }
  if (const auto* text = std::get_if<std::string>(&command.argument)) lister("argument", *text);
  lister.rest(command.extra);
}

PacketDescription describeCommand(const Packet& packet) {
  const CommandInfo* info = findCommand(packet.id);
  PacketDescription description{nameOf(packet.id), info ? info->summary : "", {}, {}};
  // Before a connection these ids are the handshake's; the packet itself does not say which of the two it is.
  if (packet.id < 3 && packet.data.empty()) description.name += " or SYNC" + std::to_string(packet.id);
  FieldLister lister(description.fields);
  if (const auto command = toCommand(packet)) {
    listCommand(*command, info, lister);
  } else {
    description.problem = command.error().text;
    lister.rest(packet.data);
  }
  return description;
}

}  // namespace

PacketDescription describe(const Packet& packet, Direction direction) {
  if (direction == Direction::kFromClient) return describeCommand(packet);
  PacketDescription description{nameOfServerPacket(packet.id), {}, {}, {}};
  FieldLister lister(description.fields);
  if (const auto decoded = decodeServerPacket(packet)) {
    std::visit([&](const auto& value) { list(value, lister); }, *decoded);
  } else {
    description.problem = decoded.error().text;
    lister.rest(packet.data);
  }
  return description;
}

std::string PacketDescription::line(std::size_t length) const {
  std::string text = name;
  const bool isArgument = fields.size() == 1 && fields[0].name == "argument";
  if (!fields.empty() && !isArgument) text += ':';
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (text.size() > length) return text + ", ...";
    const PacketField& field = fields[i];
    text += i == 0 ? " " : ", ";
    if (!isArgument) text += field.name + " ";
    text += field.unit.empty() ? field.value : field.value + " " + field.unit;
  }
  return problem.empty() ? text : text + " (" + problem + ")";
}

}  // namespace robotlink::arcos
