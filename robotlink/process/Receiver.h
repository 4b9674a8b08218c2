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

/// Whether an end of a link holds its process back from phase 2.
enum class Blocking : bool { kNo, kYes };

/// The receiving end of a link, whatever the package's type. It owns one package: the newest that was taken.
///
/// A blocking receiver is satisfied by a package that came since the last phase 2. A non-blocking one keeps
/// its package and knows whether it is new. Lives as long as its process and is used by its process's thread;
/// may be connected, also anew, by any thread at any time, and tells its names and counters to any.
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
  /// The process that sends; empty if there is none.
  std::string peer() const;
  /// The type of the packages that came, "robotcontrol.BallModel"; empty before the first.
  std::string typeName() const;

  /// Closes the link that there was; the value stays. Null: there is none from now on.
  void connect(std::shared_ptr<Link> link, std::string peer);
  /// The newest package; null before the first.
  const PackagePtr& value() const { return value_; }
  /// value() came for this frame.
  bool isNew() const { return isNew_; }

  std::uint64_t taken() const { return taken_.load(std::memory_order_relaxed); }
  std::uint64_t missed() const;

 private:
  friend class Process;
  void take();        // phase 1
  void beginFrame();  // start of phase 2
  bool satisfied() const { return !blocking() || arrived_; }
  void close();
  std::string waitsFor() const;

  EndOwner& process_;
  std::string package_;
  Blocking blocking_;
  mutable std::mutex mutex_;  // protects peer_, link_ and missedBefore_
  std::string peer_;
  std::shared_ptr<Link> link_;
  std::uint64_t missedBefore_ = 0;  // on links that were replaced
  PackagePtr value_;
  std::atomic<const google::protobuf::Descriptor*> type_{nullptr};
  bool arrived_ = false;
  bool isNew_ = false;
  std::atomic<std::uint64_t> taken_{0};
  std::atomic<std::uint64_t> unused_{0};  // taken, but replaced before phase 2
};

/// A receiver of packages of type T.
template <typename T>
class Receiver : public AnyReceiver {
 public:
  using AnyReceiver::AnyReceiver;
  /// Null before the first package. Links are made between ends of one type, which is why the cast holds.
  const T* get() const { return static_cast<const T*>(value().get()); }
};

}  // namespace robotlink
