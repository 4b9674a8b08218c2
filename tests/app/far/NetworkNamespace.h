// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "robotlink/base/Error.h"

namespace app::test {

/// A network of its own on this machine, a network namespace of Linux: programs in it reach only what cables
/// (NetworkCable) lead to. It has no name, so it vanishes with this object and the last program in it. Takes
/// root, if only by `unshare --map-root-user`, and iproute2.
class NetworkNamespace {
 public:
  /// Fails, with the reason, where the system does not permit it.
  static robotlink::Result<std::unique_ptr<NetworkNamespace>> make();
  ~NetworkNamespace();
  NetworkNamespace(const NetworkNamespace&) = delete;
  NetworkNamespace& operator=(const NetworkNamespace&) = delete;

  /// A file descriptor that stands for it, for StartedProgram::Options::network.
  int descriptor() const { return descriptor_; }
  /// Runs `ip` in it: "link set lo up". Fails with the command if that fails.
  robotlink::Result<void> ip(const std::string& arguments) const;

  /// While it exists, the thread that made it is in this network, with all threads that it starts meanwhile.
  class Stay {
   public:
    explicit Stay(const NetworkNamespace& network);
    ~Stay();
    Stay(const Stay&) = delete;
    Stay& operator=(const Stay&) = delete;

   private:
    int before_;
  };

 private:
  explicit NetworkNamespace(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace app::test
