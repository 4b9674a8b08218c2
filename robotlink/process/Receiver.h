// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "robotlink/process/EndOwner.h"
#include "robotlink/process/Link.h"

namespace google::protobuf {
class Descriptor;
}

namespace robotlink {

/// Whether an end of a link keeps its process from entering phase 2.
enum class Blocking : bool { kNo, kYes };

/// The receiving end of a link, whatever the package's type. It holds one package: the newest that was taken.
///
/// A blocking receiver is satisfied by a package that arrived since the last phase 2. A non-blocking one
/// keeps its package and knows whether it is new. It lives as long as its process and is used by the
/// process's thread; any thread may connect it, even repeatedly, and read its names and counters.
class AnyReceiver {
 public:
  AnyReceiver(EndOwner& process, std::string package, Blocking blocking);
  ~AnyReceiver();
  AnyReceiver(const AnyReceiver&) = delete;
  AnyReceiver& operator=(const AnyReceiver&) = delete;

  const std::string& package() const { return package_; }
  EndOwner& process() const { return process_; }
  bool blocking() const { return blocking_ == Blocking::kYes; }
  bool connected() const;
  /// The name of the sending process; empty if there is none.
  std::string peer() const;
  /// The type of the received packages, "robotcontrol.BallModel"; empty before the first.
  std::string typeName() const;
  /// How many senders in other programs it has had; it grows when their program was started again.
  std::uint64_t generation() const;

  /// Replaces the link and closes the old one; the last package stays. Null disconnects.
  void connect(std::shared_ptr<Link> link, std::string peer);
  /// The newest package; null before the first. It stays valid until the next frame begins.
  const PackagePtr& value() const { return value_; }
  /// Whether value() arrived for the current frame.
  bool isNew() const { return isNew_; }

  /// The number of packages received.
  std::uint64_t taken() const { return taken_.load(std::memory_order_relaxed); }
  /// The number of packages lost: replaced by newer ones on the link, or before a phase 2 saw them.
  std::uint64_t missed() const;

  /// Whether its process has another value in place of the packages that arrive, for those who show the
  /// process.
  bool held() const { return held_.load(std::memory_order_relaxed); }
  void setHeld(bool held) { held_.store(held, std::memory_order_relaxed); }

 private:
  friend class Process;
  /// Phase 1: takes packages from the link.
  void take();
  /// At the start of phase 2: sets isNew().
  void beginFrame();
  bool satisfied() const { return !blocking() || arrived_; }
  void close();
  std::string waitsFor() const;

  EndOwner& process_;
  std::string package_;
  Blocking blocking_;
  /// Protects peer_, link_ and missedBefore_.
  mutable std::mutex mutex_;
  std::string peer_;
  std::shared_ptr<Link> link_;
  /// Packages missed on links that were replaced.
  std::uint64_t missedBefore_ = 0;
  // The following are used only by the process's thread, except for the atomics.
  PackagePtr value_;
  std::atomic<const google::protobuf::Descriptor*> type_{nullptr};
  /// A package arrived since the last phase 2.
  bool arrived_ = false;
  bool isNew_ = false;
  std::atomic<std::uint64_t> taken_{0};
  /// Taken, but replaced before phase 2.
  std::atomic<std::uint64_t> unused_{0};
  std::atomic<bool> held_{false};
};

/// A receiver of packages of type T.
template <typename T>
class Receiver : public AnyReceiver {
 public:
  using AnyReceiver::AnyReceiver;
  /// Null before the first package. The cast is safe because connect() links only ends of the same type.
  const T* get() const { return static_cast<const T*>(value().get()); }
};

}  // namespace robotlink
