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

/// The sending end of links, whatever the package's type. It owns one package at a time: told to send, it
/// delivers to each receiver as soon as that has asked for one; a newer package replaces one that was not
/// delivered.
///
/// A blocking sender is unsatisfied only while a package that it was told to send is undelivered to any
/// connected receiver. Taps see every package, at once, in the sender's thread, and never hold anything back;
/// they must not connect or tap. Lives as long as its process and is used by its process's thread; may be
/// connected and tapped by any thread at any time.
class AnySender {
 public:
  using Tap = std::function<void(const PackagePtr&)>;

  AnySender(EndOwner& process, std::string package, Blocking blocking);
  ~AnySender();
  AnySender(const AnySender&) = delete;
  AnySender& operator=(const AnySender&) = delete;

  const std::string& package() const { return package_; }
  EndOwner& process() const { return process_; }
  bool blocking() const { return blocking_ == Blocking::kYes; }
  /// Somebody receives it.
  bool connected() const;
  /// The type of the packages that were sent, "robotcontrol.BallModel"; empty before the first.
  std::string typeName() const;

  /// Forgets links that were closed.
  void connect(std::shared_ptr<Link> link);
  void addTap(Tap tap);

  /// May be called more than once a frame, at any time in phase 2; what is not delivered is, later, when
  /// receivers ask.
  void send(const PackagePtr& package);
  /// Nothing that was told to send is undelivered: each receiver has got the last package.
  bool delivered() const;

  std::uint64_t sent() const { return sent_.load(std::memory_order_relaxed); }

 private:
  friend class Process;
  bool satisfied() const { return !blocking() || delivered(); }
  void close();

  EndOwner& process_;
  std::string package_;
  Blocking blocking_;
  mutable std::mutex mutex_;  // protects links_ and taps_
  std::vector<std::shared_ptr<Link>> links_;
  std::vector<Tap> taps_;
  std::atomic<const google::protobuf::Descriptor*> type_{nullptr};
  std::atomic<std::uint64_t> sent_{0};
};

/// A sender of packages of type T.
template <typename T>
class Sender : public AnySender {
 public:
  using AnySender::AnySender;
  void send(std::shared_ptr<const T> package) { AnySender::send(PackagePtr(std::move(package))); }
};

/// Links two ends in one program; one line a link. The names of both packages are free, their types agree.
template <typename T>
void connect(Sender<T>& sender, Receiver<T>& receiver);
/// The same for ends whose types were checked otherwise.
void connectUnchecked(AnySender& sender, AnyReceiver& receiver);

template <typename T>
void connect(Sender<T>& sender, Receiver<T>& receiver) {
  connectUnchecked(sender, receiver);
}

}  // namespace robotlink
