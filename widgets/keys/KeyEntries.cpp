// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/keys/KeyEntries.h"

#include <QCoreApplication>
#include <map>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {
namespace {

void addUnique(QStringList& list, const std::string& text) {
  const QString value = QString::fromStdString(text);
  if (!list.contains(value)) list.append(value);
}

void merge(KeyEntry& entry, const robotcontrol::KeyTable::Key& key) {
  if (entry.name.empty() || (key.in_use() && !entry.inUse)) entry.value = keyValue(key.mode());
  entry.name = key.name();
  entry.help = QString::fromStdString(key.help());
  entry.inUse = entry.inUse || key.in_use();
  for (const std::string& solution : key.solutions()) addUnique(entry.solutions, solution);
}

struct KeyValueText {
  Q_DECLARE_TR_FUNCTIONS(KeyValue)
};

}  // namespace

bool hasNumber(KeyValue::Kind kind) {
  return kind > KeyValue::Kind::kAlways;
}

QString kindName(KeyValue::Kind kind) {
  switch (kind) {
    case KeyValue::Kind::kOff:
      return KeyValueText::tr("off");
    case KeyValue::Kind::kAlways:
      return KeyValueText::tr("always");
    case KeyValue::Kind::kTimes:
      return KeyValueText::tr("n times");
    case KeyValue::Kind::kEveryNth:
      return KeyValueText::tr("every n-th");
    case KeyValue::Kind::kEveryMs:
      return KeyValueText::tr("every n ms");
  }
  return {};
}

QString keyValueText(const KeyValue& value) {
  switch (value.kind) {
    case KeyValue::Kind::kTimes:
      return KeyValueText::tr("%1 left").arg(value.n);
    case KeyValue::Kind::kEveryNth:
      return QString::number(value.n);
    case KeyValue::Kind::kEveryMs:
      return KeyValueText::tr("%1 ms").arg(value.n);
    default:
      return {};
  }
}

KeyValue keyValue(const robotcontrol::KeyMode& mode) {
  return {static_cast<KeyValue::Kind>(std::min(4, std::max(0, static_cast<int>(mode.kind())))), mode.n()};
}

void assign(robotcontrol::KeyMode& to, const KeyValue& from) {
  to.set_kind(static_cast<robotcontrol::KeyMode::Kind>(from.kind));
  to.set_n(hasNumber(from.kind) ? from.n : 0);
}

std::vector<KeyEntry> mergeKeys(const std::vector<const robotlink::StreamMessage*>& tables) {
  std::map<std::string, KeyEntry> entries;
  for (const auto* message : tables) {
    if (message == nullptr) continue;
    const auto* table = dynamic_cast<const robotcontrol::KeyTable*>(message->value.get());
    if (table == nullptr) continue;
    for (const auto& key : table->keys()) merge(entries[key.name()], key);
  }
  std::vector<KeyEntry> result;
  result.reserve(entries.size());
  for (auto& [name, entry] : entries) result.push_back(std::move(entry));
  return result;
}

void addClients(std::vector<KeyEntry>& entries,
                const std::vector<const robotlink::StreamMessage*>& subscribers) {
  std::map<std::string, QStringList> clients;
  for (const auto* message : subscribers) {
    if (message == nullptr) continue;
    const auto* table = dynamic_cast<const robotcontrol::KeySubscribers*>(message->value.get());
    if (table == nullptr) continue;
    for (const auto& key : table->keys()) {
      for (const std::string& client : key.clients()) addUnique(clients[key.name()], client);
    }
  }
  for (KeyEntry& entry : entries) {
    const auto found = clients.find(entry.name);
    if (found != clients.end()) entry.clients = found->second;
  }
}

}  // namespace widgets
