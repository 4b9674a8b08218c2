// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/streams/StreamAskers.h"

#include <QCoreApplication>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/keys/KeyEntries.h"

namespace widgets {

StreamAskers::StreamAskers(robotlink::Session& session) : session_(session) {
  for (const std::string& robot : session.robots()) addKeys(robot);
  const auto* recording = session.store().latestAs<robotcontrol::RecordingStatus>(
      robotlink::streams::kRecording, session.timeline().newest());
  if (recording != nullptr && recording->recording()) recorded_.emplace(recording->selection());
}

void StreamAskers::addKeys(const std::string& robot) {
  const auto newest = session_.timeline().newest();
  const auto& store = session_.store();
  const auto* table = store.latestAs<robotcontrol::KeyTable>(robot + '/' + robotlink::streams::kKeys, newest);
  if (table == nullptr) return;
  std::map<std::string, QStringList> clients;
  if (const auto* subscribers = store.latestAs<robotcontrol::KeySubscribers>(
          robot + '/' + robotlink::streams::kSubscribers, newest)) {
    for (const auto& key : subscribers->keys()) {
      for (const std::string& client : key.clients()) clients[key.name()] << QString::fromStdString(client);
    }
  }
  for (const auto& key : table->keys()) {
    if (key.stream().empty()) continue;
    const KeyValue value = keyValue(key.mode());
    const QString number = keyValueText(value);
    QString text = QString::fromStdString(key.name()) + QStringLiteral(": ") + kindName(value.kind);
    if (!number.isEmpty()) text += QStringLiteral(" (%1)").arg(number);
    keys_[robot + '/' + key.stream()] = {text, clients[key.name()]};
  }
}

StreamAsked StreamAskers::of(const robotlink::StreamStore::Stream& stream) const {
  StreamAsked asked;
  for (const std::string& name : session_.readers().of(stream)) asked.views << QString::fromStdString(name);
  if (recorded_ && recorded_->contains(stream.path))
    asked.views << QCoreApplication::translate("StreamAskers", "Recording");
  for (std::string path = stream.path; !path.empty();) {
    if (const auto found = keys_.find(path); found != keys_.end()) {
      asked.key = found->second.text;
      asked.clients = found->second.clients;
      break;
    }
    const std::size_t slash = path.rfind('/');
    path.resize(slash == std::string::npos ? 0 : slash);
  }
  return asked;
}

}  // namespace widgets
