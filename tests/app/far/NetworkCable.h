// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "tests/app/far/NetworkNamespace.h"

namespace app::test {

/// A cable between two networks (a pair of virtual Ethernet interfaces), which can be unplugged. The networks
/// must outlive it, and it vanishes with them.
class NetworkCable {
 public:
  struct End {
    const NetworkNamespace& network;
    /// "10.77.0.1"; the first three numbers are those of the other end.
    std::string address;
    /// The name of the interface, unique in its network.
    std::string interface;
  };
  static robotlink::Result<std::unique_ptr<NetworkCable>> make(const End& one, const End& other);

  /// Pulls it out, until it is called with false. Connections over it are not told.
  void unplug(bool unplugged) const;

 private:
  explicit NetworkCable(End one) : one_(std::move(one)) {}

  End one_;
};

}  // namespace app::test
