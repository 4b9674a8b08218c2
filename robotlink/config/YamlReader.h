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

/// A node of a YAML document: a scalar, a list, a map, or nothing (the result of a failed or optional
/// look-up; reading it yields defaults and no further error). A failed read is recorded in the document with
/// file, line and column and yields T{} or an empty list, so that a reader runs to its end and reports all
/// errors at once.
///
/// T is std::string, double, int, std::int64_t, bool, or std::vector of the first three. Numbers are finite.
/// It is a handle of two pointers; the YamlReader must outlive it.
class YamlNode {
 public:
  YamlNode() = default;
  YamlNode(YamlDocument* document, const YamlValue* value) : document_(document), value_(value) {}

  bool empty() const { return value_ == nullptr; }
  bool isMap() const;
  bool isList() const;
  /// The place of the value in the file; of an empty node the unknown place.
  FilePosition where() const;

  /// The value of a required key; an error is recorded if it is missing. Looking a key up makes it a known
  /// one.
  YamlNode child(std::string_view key) const;
  /// The value of a key, or an empty node.
  YamlNode optionalChild(std::string_view key) const;
  /// All entries of a map whose keys are data rather than fixed words, in the file's order. All of them
  /// become known.
  std::vector<std::pair<std::string, YamlNode>> entries() const;
  /// The elements of a list; anything else is an error.
  std::vector<YamlNode> items() const;

  /// Converts the node; T{} for an empty node and, after recording an error, for a value of another type.
  /// Quoted scalars are texts, never numbers or bools.
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
  /// A required number in [minimum, maximum]; `minimum` if it is outside, which is an error.
  double numberIn(std::string_view key, double minimum, double maximum) const;
  /// The same for whole numbers; 2.5 is an error.
  int wholeNumberIn(std::string_view key, int minimum, int maximum) const;
  /// A list of exactly `count` numbers, filled with 0 where there are fewer, which is an error.
  std::vector<double> numbers(std::string_view key, std::size_t count) const;

  /// Records that this value is wrong, for a reason that only the caller knows. An empty node records
  /// nothing.
  void fail(std::string id, std::string text, std::vector<std::string> arguments = {}) const;

 private:
  template <typename T>
  T within(std::string_view key, T minimum, T maximum) const;

  /// Null for an empty node.
  YamlDocument* document_ = nullptr;
  const YamlValue* value_ = nullptr;
};

/// Reads a YAML 1.2 file strictly: a missing key, a wrong type, an unknown or repeated key is an error with
/// its place. Read everything through root(), then call finish(). Not thread-safe. Nodes stay valid when a
/// reader is moved.
class YamlReader {
 public:
  /// Fails only if the text is not YAML at all, or is too large or nested too deeply. `file` is the name that
  /// errors carry.
  static Result<YamlReader> parse(std::string_view text, std::string file);
  /// Parses a file; fails also if it cannot be read.
  static Result<YamlReader> load(const std::filesystem::path& file);
  ~YamlReader();
  YamlReader(YamlReader&&) noexcept;
  YamlReader& operator=(YamlReader&&) noexcept;

  YamlNode root() const;
  /// Returns all errors in the file's order: the recorded ones, and one for every key that was never looked
  /// up. Call it once, at the end.
  tl::expected<void, Errors> finish();

 private:
  explicit YamlReader(std::unique_ptr<YamlDocument> document);
  std::unique_ptr<YamlDocument> document_;
};

}  // namespace robotlink
