// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/far/NetworkNamespace.h"

#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace app::test {
namespace {

int networkOfThisThread() {
  return ::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC);
}

void enter(int descriptor) {
  // Whatever follows would be in the wrong network.
  if (::setns(descriptor, CLONE_NEWNET) != 0) std::abort();
}

}  // namespace

robotlink::Result<std::unique_ptr<NetworkNamespace>> NetworkNamespace::make() {
  const int before = networkOfThisThread();
  if (before < 0 || ::unshare(CLONE_NEWNET) != 0) {
    const std::string reason = std::strerror(errno);
    if (before >= 0) ::close(before);
    return robotlink::failure("test.network", "network namespaces are not permitted here (" + reason +
                                                  "); run the test as root, or by unshare --map-root-user");
  }
  auto made = std::unique_ptr<NetworkNamespace>(new NetworkNamespace(networkOfThisThread()));
  enter(before);
  ::close(before);
  if (auto up = made->ip("link set lo up"); !up) return tl::unexpected(up.error());
  return made;
}

NetworkNamespace::~NetworkNamespace() {
  ::close(descriptor_);
}

robotlink::Result<void> NetworkNamespace::ip(const std::string& arguments) const {
  const Stay stay(*this);
  const std::string command = "PATH=$PATH:/sbin:/usr/sbin ip " + arguments;
  if (std::system(command.c_str()) == 0) return {};
  return robotlink::failure("test.network",
                            "networks cannot be set up here: 'ip " + arguments + "' (iproute2) failed");
}

NetworkNamespace::Stay::Stay(const NetworkNamespace& network) : before_(networkOfThisThread()) {
  enter(network.descriptor());
}

NetworkNamespace::Stay::~Stay() {
  enter(before_);
  ::close(before_);
}

}  // namespace app::test
