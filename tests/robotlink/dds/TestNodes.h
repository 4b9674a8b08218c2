// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <memory>

#include "robotlink/dds/Node.h"

namespace robotlink::test {

/// A DDS domain of the test's own, so that tests that run at the same time do not meet.
inline std::uint32_t testDomain() {
  return 1 + static_cast<std::uint32_t>(::getpid()) % 200;
}

inline std::shared_ptr<dds::Node> openTestNode() {
  auto node = dds::Node::open({.domain = testDomain(), .address = {}, .peers = {}, .multicast = false});
  return node ? *node : nullptr;
}

}  // namespace robotlink::test
