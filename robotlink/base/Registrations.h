// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace robotlink {

/// Solutions, views, platforms, log formats and all other entries of registries are registered by one
/// thread: before main() starts, and while plug-ins are loaded. Then the registries are sealed, before
/// anything is opened, and are read-only for all threads.
class Registrations {
 public:
  /// Makes further registrations a programming error.
  static void seal();
  static bool areSealed();
  /// Reports a registration that cannot be made. Ends the program with the text, but while a plug-in is
  /// loaded the plug-in fails instead; then the caller registers nothing.
  static void refuse(const std::string& text);
};

/// The registrations of one plug-in. While it exists, failed registrations are noted instead of ending
/// the program. Unless they are kept, all registrations since its construction are undone by its destructor.
/// One at a time.
class RegistrationTrial {
 public:
  RegistrationTrial();
  ~RegistrationTrial();
  RegistrationTrial(const RegistrationTrial&) = delete;
  RegistrationTrial& operator=(const RegistrationTrial&) = delete;

  /// Why registrations were refused, in sentences; empty if none was.
  static const std::string& problem();
  void keep() { isKept_ = true; }

 private:
  bool isKept_ = false;
};

/// A registry as trials see it. It exists until the program ends.
class RegistryBase {
 public:
  RegistryBase(const RegistryBase&) = delete;
  RegistryBase& operator=(const RegistryBase&) = delete;

 protected:
  RegistryBase();
  ~RegistryBase() = default;
  /// Whether something may be registered: nothing is wrong with it, and registrations are not sealed.
  /// Refuses it if not.
  static bool accepts(const std::string& what, const std::string& problem);

 private:
  friend class RegistrationTrial;
  virtual void rememberEntries() = 0;
  virtual void restoreEntries() = 0;
};

/// The entries of one kind, in an order that does not depend on the order in which files are linked. To be
/// made by the first call of a function that has it as its static variable, since registrations at namespace
/// scope come in any order.
template <typename Entry>
class Registry final : public RegistryBase {
 public:
  using Order = bool (*)(const Entry& a, const Entry& b);
  /// `before` is null for entries that stay in the order of their registration.
  explicit Registry(Order before = nullptr) : before_(before) {}

  const std::vector<Entry>& all() const { return entries_; }
  /// Adds an entry behind those that are equal to it. Returns false if it is refused: `problem` is what is
  /// wrong with it, if anything is, and `name` says what it is: "view \"image\"".
  bool add(Entry entry, const std::string& name, const std::string& problem) {
    if (!accepts(name, problem)) return false;
    const auto place = before_ == nullptr
                           ? entries_.end()
                           : std::upper_bound(entries_.begin(), entries_.end(), entry, before_);
    entries_.insert(place, std::move(entry));
    return true;
  }

 private:
  void rememberEntries() override { remembered_ = entries_; }
  void restoreEntries() override { entries_ = std::move(remembered_); }

  Order before_;
  std::vector<Entry> entries_;
  /// The entries at the beginning of the trial.
  std::vector<Entry> remembered_;
};

}  // namespace robotlink
