// SPDX-License-Identifier: GPL-3.0-or-later
// The table of requests and those who fulfill them belong together.
#include <gtest/gtest.h>

#include "app/core/program/RobotHost.h"
#include "app/platforms/replay/ReplayFeed.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/TaskProcess.h"
#include "robotlink/debugging/program/DebugProcess.h"
#include "robotlink/debugging/program/RequestPreview.h"

using robotcontrol::Request;
using robotlink::RequestDoer;
using robotlink::RequestKind;

namespace {

/// A request of a kind without any details.
Request requestOf(const RequestKind& kind) {
  Request request;
  const auto* field = Request::descriptor()->FindFieldByNumber(kind.what);
  Request::GetReflection()->MutableMessage(&request, field);
  EXPECT_EQ(request.what_case(), kind.what);
  return request;
}

/// Whether the one that the table names has a handler.
bool isFulfilled(const RequestKind& kind) {
  const Request request = requestOf(kind);
  switch (kind.doer) {
    case RequestDoer::kNobody:
      return false;
    case RequestDoer::kTask:
      return robotlink::TaskProcess::fulfills(request) && robotlink::RequestPreview::handles(request);
    case RequestDoer::kDebugProcess:
      return robotlink::DebugProcess::fulfills(request);
    case RequestDoer::kPlatform:
      return app::RobotHost::fulfills(request);
    case RequestDoer::kSimulation:
      return app::SimulationFeed::fulfills(request);
    case RequestDoer::kReplay:
      return app::ReplayFeed::fulfills(request);
    case RequestDoer::kRecording:
      // app::Recording has one function for all that it is asked for.
      return kind.what == Request::kControlRecording;
  }
  return false;
}

}  // namespace

TEST(RequestFulfillers, everyKindOfRequestHasAHandlerWhereTheTableSaysSo) {
  for (const RequestKind& kind : robotlink::requestKinds()) EXPECT_TRUE(isFulfilled(kind)) << kind.words;
}

TEST(RequestFulfillers, nobodyHasHandlersForRequestsOfOthers) {
  for (const RequestKind& kind : robotlink::requestKinds()) {
    const Request request = requestOf(kind);
    EXPECT_EQ(app::RobotHost::fulfills(request), kind.doer == RequestDoer::kPlatform) << kind.words;
    EXPECT_EQ(app::SimulationFeed::fulfills(request), kind.doer == RequestDoer::kSimulation) << kind.words;
    EXPECT_EQ(app::ReplayFeed::fulfills(request), kind.doer == RequestDoer::kReplay) << kind.words;
    EXPECT_EQ(robotlink::DebugProcess::fulfills(request), kind.doer == RequestDoer::kDebugProcess)
        << kind.words;
    EXPECT_LE(robotlink::TaskProcess::fulfills(request), kind.isOfProgram()) << kind.words;
    EXPECT_LE(robotlink::RequestPreview::handles(request), kind.isOfProgram()) << kind.words;
  }
}
