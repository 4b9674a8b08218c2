// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

struct YamlDocument;
struct YamlValue;

/// A place in a YAML document that is being read: a scalar, a list, a map, or nothing (after a failed or
/// optional look-up; reading it yields defaults and no further error). Every failed read is noted in the
/// document with file, line and column, and yields T{} or an empty list; so a reader runs to its end and
/// reports all errors at once.
///
/// T is one of std::string, double, int, std::int64_t, bool, and std::vector of the first three. Numbers are
/// finite. A handle of two pointers; the YamlReader must outlive it.
class YamlNode {
 public:
  YamlNode() = default;
  YamlNode(YamlDocument* document, const YamlValue* value) : document_(document), value_(value) {}

  bool empty() const { return value_ == nullptr; }
  bool isMap() const;
  bool isList() const;
  FilePosition where() const;

  /// The value of a key that must be there. Asking for a key makes it a known one.
  YamlNode child(std::string_view key) const;
  /// The value of a key, or nothing.
  YamlNode optionalChild(std::string_view key) const;
  /// All entries of a map whose keys are data, in the file's order; all its keys become known.
  std::vector<std::pair<std::string, YamlNode>> entries() const;
  /// The elements of a list.
  std::vector<YamlNode> items() const;

  template <typename T>
  T as() const;
  template <typename T>
  T required(std::string_view key) const {
    return child(key).as<T>();
  }
  template <typename T>
  T optional(std::string_view key, T fallback) const {
    const YamlNode node = optionalChild(key);
    return node.empty() ? fallback : node.as<T>();
  }
  /// A required number within [minimum, maximum].
  double numberIn(std::string_view key, double minimum, double maximum) const;
  /// Exactly `count` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count) const;

  /// Notes that what stands here is wrong, for a reason that only the caller knows.
  void fail(std::string id, std::string text, std::vector<std::string> arguments = {}) const;

 private:
  YamlDocument* document_ = nullptr;
  const YamlValue* value_ = nullptr;
};

/// Reads a YAML 1.2 file with checks: what is missing, of another type, unknown or double is an error with
/// its place. Read everything through root(), then call finish(). Not thread-safe.
class YamlReader {
 public:
  /// `file` is the name that errors carry. Fails only if the text is no YAML at all.
  static Result<YamlReader> parse(std::string_view text, std::string file);
  static Result<YamlReader> load(const std::filesystem::path& file);
  ~YamlReader();
  YamlReader(YamlReader&&) noexcept;
  YamlReader& operator=(YamlReader&&) noexcept;

  YamlNode root() const;
  /// What was wrong, in the file's order: noted errors, and every key that nobody asked for.
  tl::expected<void, Errors> finish();

 private:
  explicit YamlReader(std::unique_ptr<YamlDocument> document);
  std::unique_ptr<YamlDocument> document_;
};

}  // namespace robotlink
