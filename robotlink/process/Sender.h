// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "robotlink/process/Receiver.h"

namespace robotlink {

/// The sending end of links, whatever the package's type. Each link holds the packages that its receiver has
/// not taken yet; a newer package replaces one that was not delivered.
///
/// A blocking sender is unsatisfied while a package is undelivered to a connected receiver. Taps see every
/// package immediately, in the sender's thread, and never block; they must not connect or tap. It lives as
/// long as its process and is used by the process's thread; any thread may connect and tap it at any time.
class AnySender {
 public:
  /// A function that sees each package that is sent; for debugging and recording.
  using Tap = std::function<void(const PackagePtr&)>;

  AnySender(EndOwner& process, std::string package, Blocking blocking);
  ~AnySender();
  AnySender(const AnySender&) = delete;
  AnySender& operator=(const AnySender&) = delete;

  const std::string& package() const { return package_; }
  EndOwner& process() const { return process_; }
  bool blocking() const { return blocking_ == Blocking::kYes; }
  /// Whether at least one link is open.
  bool connected() const;
  /// The type of the sent packages, "robotcontrol.BallModel"; empty before the first.
  std::string typeName() const;

  /// Adds a link; drops links that were closed permanently.
  void connect(std::shared_ptr<Link> link);
  void addTap(Tap tap);

  /// May be called more than once a frame, at any time in phase 2. What cannot be delivered now is delivered
  /// later, when receivers are ready.
  void send(const PackagePtr& package);
  /// True if every receiver has got the last package.
  bool delivered() const;

  /// The last package, whether there is a receiver or not; null before the first. Any thread.
  PackagePtr newest() const;

  std::uint64_t sent() const { return sent_.load(std::memory_order_relaxed); }

  /// Whether its process has another value in place of the packages that are sent, for those who show the
  /// process.
  bool held() const { return held_.load(std::memory_order_relaxed); }
  void setHeld(bool held) { held_.store(held, std::memory_order_relaxed); }

 private:
  friend class Process;
  bool satisfied() const { return !blocking() || delivered(); }
  void close();

  EndOwner& process_;
  std::string package_;
  Blocking blocking_;
  /// Protects links_, taps_ and newest_.
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<Link>> links_;
  std::vector<Tap> taps_;
  PackagePtr newest_;
  std::atomic<const google::protobuf::Descriptor*> type_{nullptr};
  std::atomic<std::uint64_t> sent_{0};
  std::atomic<bool> held_{false};
};

/// A sender of packages of type T.
template <typename T>
class Sender : public AnySender {
 public:
  using AnySender::AnySender;
  void send(std::shared_ptr<const T> package) { AnySender::send(PackagePtr(std::move(package))); }
};

/// Links two ends of one program. The names of their packages may differ; the types must agree.
template <typename T>
void connect(Sender<T>& sender, Receiver<T>& receiver);
/// Links two ends whose types were checked in another way.
void connectUnchecked(AnySender& sender, AnyReceiver& receiver);

template <typename T>
void connect(Sender<T>& sender, Receiver<T>& receiver) {
  connectUnchecked(sender, receiver);
}

}  // namespace robotlink
