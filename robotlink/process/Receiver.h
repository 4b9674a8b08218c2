// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "robotlink/process/Link.h"

namespace robotlink {

class Process;

/// Whether an end of a link holds its process back from phase 2.
enum class Blocking : bool { kNo, kYes };

/// The receiving end of a link, whatever the package's type. It owns one package: the newest that was taken.
///
/// A blocking receiver is satisfied by a package that came since the last phase 2. A non-blocking one keeps its package
/// and knows whether it is new. Lives as long as its process; used by its process's thread, connected before that runs.
class AnyReceiver {
 public:
  AnyReceiver(Process& process, std::string package, Blocking blocking);
  AnyReceiver(const AnyReceiver&) = delete;
  AnyReceiver& operator=(const AnyReceiver&) = delete;

  const std::string& package() const { return package_; }
  Process& process() const { return process_; }
  bool blocking() const { return blocking_ == Blocking::kYes; }
  bool connected() const { return link_ != nullptr; }
  const std::string& peer() const { return peer_; }

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

  Process& process_;
  std::string package_;
  std::string peer_;
  Blocking blocking_;
  std::shared_ptr<Link> link_;
  PackagePtr value_;
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
