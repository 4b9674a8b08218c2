// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <string>

#include "logplayer/base/RecordedStreams.h"
#include "robotlink/session/StreamStore.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// The views and clients that asked for a stream.
struct StreamAsked {
  /// The views of this window that read it, and the recording that writes it; and the clients that subscribe
  /// to it over a link.
  QStringList views, clients;
  /// The debug key that publishes it, with its mode: "package/models/ball: always"; empty: it is always
  /// published, or the key is unknown.
  QString key;
  bool isRead() const { return !views.isEmpty() || !clients.isEmpty(); }
  bool operator==(const StreamAsked&) const = default;
};

/// Finds out who asked for the streams of a session: by StreamReaders, and by the robots' tables of debug
/// keys and of subscribers. Made again whenever it is needed. GUI thread; the session must outlive it.
class StreamAskers {
 public:
  explicit StreamAskers(robotlink::Session& session);
  StreamAsked of(const robotlink::StreamStore::Stream& stream) const;

 private:
  struct Key {
    QString text;
    QStringList clients;
  };
  void addKeys(const std::string& robot);

  robotlink::Session& session_;
  /// Keyed by the paths of what they publish. A key also publishes what is below its path.
  std::map<std::string, Key> keys_;
  /// The streams that are recorded now.
  std::optional<logplayer::RecordedStreams> recorded_;
};

}  // namespace widgets
