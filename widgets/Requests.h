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

namespace widgets {

/// Sends requests for a view and tells how they ended as long as the view lives. Include in sources only: it
/// shows protobuf.
///
/// `onResult` gets whether it was accepted and, if not, why.
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
