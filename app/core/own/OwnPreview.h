// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/core/program/HostedProgram.h"
#include "robotcontrol/ProgramWire.pb.h"

namespace app {

/// A preview of a remote program; without effect once the program does not answer.
class OwnPreview final : public ProgramPreview {
 public:
  /// Asks the program; null if it does not answer.
  using Ask = std::function<const robotcontrol::WireAnswer*(const robotcontrol::WireOrder& order)>;
  /// `refusal` is why the program takes no requests; empty if it does.
  OwnPreview(Ask ask, std::function<std::string()> refusal);

  std::string add(const robotcontrol::Request& request) override;
  bool answer(const robotcontrol::Request& request) override;
  std::shared_ptr<const robotlink::SharedDebugQueue> takeQueue(robotlink::Instant now) override;

 private:
  std::string asked(const robotcontrol::Request& request, bool withResult);
  void refuse(const robotcontrol::Request& request, const std::string& why);

  const Ask ask_;
  const std::function<std::string()> refusal_;
  std::shared_ptr<robotlink::SharedDebugQueue> refused_;
};

}  // namespace app
