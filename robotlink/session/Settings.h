// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

/// The settings that views and windows keep between runs: values under names such as "views/image-1/zoom". A
/// JSON text file with a version, written as a whole or not at all. A value of another type than requested
/// counts as absent.
///
/// A file that cannot be read is renamed to <file>.broken, so that nothing a user made is lost, and
/// everything has its default value. One thread.
class Settings {
 public:
  using Value = std::variant<bool, double, std::string, std::vector<std::string>>;

  explicit Settings(std::filesystem::path file) : file_(std::move(file)) {}

  /// Reads the file. A missing file means no settings. Fails if the file cannot be used; the error says why
  /// and where the file was moved.
  Result<void> load();
  /// Writes the file if something has changed since load() or save().
  Result<void> save();

  /// `fallback` is returned if the name is absent or has another type.
  double number(const std::string& name, double fallback) const;
  std::string text(const std::string& name, const std::string& fallback) const;

  void set(const std::string& name, Value value);
  void set(const std::string& name, const char* text) { set(name, Value(std::string(text))); }
  /// A number that is not finite removes the setting.
  template <typename T>
  requires std::is_arithmetic_v<T>
  void set(const std::string& name, T value) {
    if constexpr (std::is_same_v<T, bool>) {
      set(name, Value(value));
    } else {
      setNumber(name, static_cast<double>(value));
    }
  }
  /// Removes a name and all names below it ("views/image-1" and "views/image-1/...").
  void remove(const std::string& name);
  const std::map<std::string, Value>& all() const { return values_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  template <typename T>
  const T* find(const std::string& name) const;
  void setNumber(const std::string& name, double number);

  std::filesystem::path file_;
  std::map<std::string, Value> values_;
  /// Set by set() and remove(), reset by load() and save().
  bool changed_ = false;
};

}  // namespace robotlink
