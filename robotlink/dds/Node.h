// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink::dds {

/// The DDS domain and network interface of a program. A plain value.
struct NodeOptions {
  /// Programs see only those of the same domain, 0 to 230.
  std::uint32_t domain = 0;
  /// The IP address of the network interface; empty: the loopback interface.
  std::string address;
  /// The machines where other programs are looked for, by IP address or name; this machine always is.
  std::vector<std::string> peers;
  /// Whether other programs are also found by multicast, which needs no peers. Not on the loopback interface.
  bool multicast = false;
};

/// A participant in DDS, on one network interface only, with settings of its own: the environment variable
/// CYCLONEDDS_URI is ignored. A program may have several, which find each other as if they were in different
/// programs. A peer that ends without a farewell is given up after a second. Any thread.
class Node {
 public:
  /// Fails if there is no such interface or the domain has no free port.
  static Result<std::shared_ptr<Node>> open(const NodeOptions& options);
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// The handle of the participant, for the other classes of this folder.
  std::int32_t participant() const { return participant_; }
  /// The address of the node's network interface; empty: the loopback interface.
  const std::string& address() const { return address_; }

 private:
  Node(std::int32_t domain, std::int32_t participant, std::string address)
      : domain_(domain), participant_(participant), address_(std::move(address)) {}

  const std::int32_t domain_;
  const std::int32_t participant_;
  const std::string address_;
};

}  // namespace robotlink::dds
