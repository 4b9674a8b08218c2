// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/dds/Node.h"

namespace google::protobuf {
class Descriptor;
}

namespace robotlink::dds {

/// The configuration that both ends of a link between programs share. A plain value.
struct EndSetup {
  std::shared_ptr<Node> node;
  /// The name of the package: "models/ball".
  std::string package;
  /// The topic; both ends have the same, and no other link has it.
  std::string topic;
  /// This program, and this end's process in it, for users: "planning/path".
  std::string program;
  std::string process;
  /// The clock of this program; must outlive the end.
  const Clock* clock = nullptr;
  /// Computes the fingerprints of types; tests replace it.
  std::function<std::uint64_t(const google::protobuf::Descriptor& type)> fingerprint;
  /// Gets sentences for the user, in threads of DDS; must not block.
  std::function<void(const std::string& text)> report;
};

}  // namespace robotlink::dds
