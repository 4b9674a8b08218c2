// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <string>
#include <utility>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"

// Functions that send requests from a view. Include this in sources only, since it exposes protobuf. GUI
// thread only.
namespace widgets {

/// Sends a request to a robot. `onResult` is called in the GUI thread with whether the request was accepted
/// and, if not, why; the call is dropped if `owner` has been destroyed by then. Without `onResult` the
/// session's refusal handler reports a refusal.
inline void ask(robotlink::Session& session, const std::string& robot, robotcontrol::Request request,
                QObject* owner = nullptr, std::function<void(bool, const QString&)> onResult = {}) {
  request.set_robot(robot);
  if (!onResult) {
    session.request(std::move(request));
    return;
  }
  session.request(std::move(request), [guard = QPointer<QObject>(owner), done = std::move(onResult)](
                                          const robotcontrol::RequestResult& result) {
    if (guard) done(result.accepted(), QString::fromStdString(result.reason()));
  });
}

}  // namespace widgets
