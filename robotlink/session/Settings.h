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

/// What views and windows remember from one start to the next: values under names like "views/image-1/zoom".
/// A text file with a version (JSON), written whole or not at all. Values of another type than asked for
/// count as absent.
///
/// A file that cannot be read is kept aside as <file>.broken, so that nothing a user made is lost, and
/// everything has its default. One thread.
class Settings {
 public:
  using Value = std::variant<bool, double, std::string, std::vector<std::string>>;

  explicit Settings(std::filesystem::path file) : file_(std::move(file)) {}

  /// Reads the file; fails, with the reason and where the file went, if there is one that cannot be used.
  /// None: empty.
  Result<void> load();
  /// Nothing is written if nothing has changed since load() or save().
  Result<void> save();

  bool flag(const std::string& name, bool fallback) const;
  double number(const std::string& name, double fallback) const;
  std::string text(const std::string& name, const std::string& fallback) const;
  std::vector<std::string> list(const std::string& name, const std::vector<std::string>& fallback = {}) const;

  void set(const std::string& name, Value value);
  void set(const std::string& name, const char* text) { set(name, Value(std::string(text))); }
  /// Numbers that are not finite are forgotten instead.
  template <typename T>
  requires std::is_arithmetic_v<T>
  void set(const std::string& name, T value) {
    if constexpr (std::is_same_v<T, bool>) {
      set(name, Value(value));
    } else {
      setNumber(name, static_cast<double>(value));
    }
  }
  /// Forgets a name and all below it ("views/image-1" and "views/image-1/...").
  void remove(const std::string& name);
  const std::map<std::string, Value>& all() const { return values_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  template <typename T>
  const T* find(const std::string& name) const;
  void setNumber(const std::string& name, double number);

  std::filesystem::path file_;
  std::map<std::string, Value> values_;
  bool changed_ = false;
};

}  // namespace robotlink
