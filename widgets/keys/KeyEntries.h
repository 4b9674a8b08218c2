// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <vector>

namespace robotcontrol {
class KeyMode;
}
namespace robotlink {
struct StreamMessage;
}

// Debug keys as values for the GUI, converted from and to protobuf messages.
namespace widgets {

/// The mode of a debug key, that is, when it is active. The kinds are in the order of robotcontrol.KeyMode.
struct KeyValue {
  /// kOff, kAlways: no number.
  /// kTimes: n more times, then off.
  /// kEveryNth: every n-th time.
  /// kEveryMs: at most once in n milliseconds of the platform's clock.
  enum class Kind : std::uint8_t { kOff, kAlways, kTimes, kEveryNth, kEveryMs };
  Kind kind = Kind::kOff;
  /// The number; for kTimes what is left of it.
  unsigned n = 0;
  bool operator==(const KeyValue&) const = default;
};

/// Whether modes of this kind have a number.
bool hasNumber(KeyValue::Kind kind);
/// "off", "every n-th": translated, for lists.
QString kindName(KeyValue::Kind kind);
/// "10", "3 left", "100 ms"; empty for modes without a number.
QString keyValueText(const KeyValue& value);
/// Unknown kinds of newer programs become kEveryMs.
KeyValue keyValue(const robotcontrol::KeyMode& mode);
/// Writes the mode into the message; the number of modes without one is 0.
void assign(robotcontrol::KeyMode& to, const KeyValue& from);

/// A debug key of one robot, merged over all its processes.
struct KeyEntry {
  std::string name;
  QString help;
  KeyValue value;
  /// Whether a running solution queries it.
  bool inUse = false;
  /// Solutions that query it: "ball-percept/scan-lines".
  QStringList solutions;
  /// Clients of a link that subscribe to what it publishes: "RobotControl at 10.0.0.7:5123".
  QStringList clients = {};
};

/// The keys in all messages that are KeyTables, by name; null messages are skipped. If several tables contain
/// a key its mode is that of one in which it is in use.
std::vector<KeyEntry> mergeKeys(const std::vector<const robotlink::StreamMessage*>& tables);
/// Notes in the entries which clients ask for them, by messages that are KeySubscribers.
void addClients(std::vector<KeyEntry>& entries,
                const std::vector<const robotlink::StreamMessage*>& subscribers);

}  // namespace widgets
