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

namespace widgets {

/// When a debug key is active; the kinds are those of robotcontrol.KeyMode, in its order.
struct KeyValue {
  enum class Kind : std::uint8_t { kOff, kAlways, kTimes, kEveryNth, kEveryMs };
  Kind kind = Kind::kOff;
  unsigned n = 0;  ///< times, or milliseconds of the platform's clock
  bool operator==(const KeyValue&) const = default;
};

bool hasNumber(KeyValue::Kind kind);
/// What a mode is called in lists, and with its number: "every 10th", "3 times left".
QString kindName(KeyValue::Kind kind);
QString numberText(const KeyValue& value);
KeyValue keyValue(const robotcontrol::KeyMode& mode);
void assign(robotcontrol::KeyMode& to, const KeyValue& from);

/// A debug key of one robot, as all of its processes together tell.
struct KeyEntry {
  std::string name;
  QString help;
  KeyValue value;
  bool inUse = false;     ///< a running solution asks for it
  QStringList solutions;  ///< "ball-percept/scan-lines"
};

/// The keys of all these messages that are KeyTables (null ones are skipped), by name. The mode is that of a
/// table in which the key is in use, if there is one.
std::vector<KeyEntry> mergeKeys(const std::vector<const robotlink::StreamMessage*>& tables);

}  // namespace widgets
