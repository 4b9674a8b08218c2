// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/YamlReader.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <unordered_set>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/ParsedNumber.h"

namespace robotlink {

/// A copy of the parsed tree, so that yaml-cpp's header stays in this file.
struct YamlValue {
  enum class Kind : std::uint8_t { kNull, kScalar, kList, kMap };
  struct Entry;

  Kind kind = Kind::kNull;
  std::string text;
  bool quoted = false;
  FilePosition where;
  std::vector<YamlValue> items;
  std::vector<Entry> entries;
};

struct YamlValue::Entry {
  std::string key;
  FilePosition where;
  YamlValue value;
  // The key has been looked up; unknown keys are errors.
  mutable bool known = false;
};

struct YamlDocument {
  YamlValue root;
  Errors errors;
};

namespace {

using Kind = YamlValue::Kind;

// Aliases are copied where they are used, so a small file can expand to a huge tree.
constexpr int kMaxValues = 200'000;
constexpr int kMaxDepth = 100;

struct Converter {
  std::string file;
  Errors errors;
  int values = 0;

  FilePosition position(const YAML::Mark& mark) const {
    return mark.is_null() ? FilePosition{file, 0, 0} : FilePosition{file, mark.line + 1, mark.column + 1};
  }

  YamlValue convert(const YAML::Node& node, int depth) {
    YamlValue value;
    value.where = position(node.Mark());
    if (++values > kMaxValues || depth > kMaxDepth)
      throw YAML::Exception(node.Mark(), "too large or too deeply nested");
    if (node.IsScalar()) {
      value.kind = Kind::kScalar;
      value.text = node.Scalar();
      value.quoted = node.Tag() == "!";
    } else if (node.IsSequence()) {
      value.kind = Kind::kList;
      for (const YAML::Node& item : node) value.items.push_back(convert(item, depth + 1));
    } else if (node.IsMap()) {
      value.kind = Kind::kMap;
      std::unordered_set<std::string> names;
      for (const auto& entry : node) {
        const bool isNew = !entry.first.IsScalar() || names.insert(entry.first.Scalar()).second;
        convertEntry(value, entry.first, isNew ? std::optional(entry.second) : std::nullopt, depth);
      }
    }
    return value;
  }

  // An empty `node` means that the key occurs in the map for the second time.
  void convertEntry(YamlValue& map, const YAML::Node& key, const std::optional<YAML::Node>& node, int depth) {
    const FilePosition where = position(key.Mark());
    if (!key.IsScalar()) {
      errors.push_back({"yaml.key", "a key must be a plain word", {}, where});
      return;
    }
    const std::string& name = key.Scalar();
    if (!node) {
      errors.push_back({"yaml.duplicate-key", "'" + name + "' appears here twice", {name}, where});
      return;
    }
    map.entries.push_back({name, where, convert(*node, depth + 1)});
  }
};

void collectUnknownKeys(const YamlValue& value, Errors& errors) {
  for (const YamlValue& item : value.items) collectUnknownKeys(item, errors);
  for (const YamlValue::Entry& entry : value.entries) {
    if (entry.known) {
      collectUnknownKeys(entry.value, errors);
    } else {
      errors.push_back({"yaml.unknown-key", "unknown key '" + entry.key + "'", {entry.key}, entry.where});
    }
  }
}

// Scalar<T>::read() returns the value, or nothing; kExpected names the type in the error message.
template <typename T>
struct Scalar;

template <>
struct Scalar<std::string> {
  static constexpr const char* kExpected = "a text";
  static std::optional<std::string> read(const YamlValue& value) { return value.text; }
};

template <>
struct Scalar<double> {
  static constexpr const char* kExpected = "a finite number";
  static std::optional<double> read(const YamlValue& value) {
    const auto number = value.quoted ? std::nullopt : parsedNumberWithSign<double>(value.text);
    return number && std::isfinite(*number) ? number : std::nullopt;
  }
};

template <typename Integer>
struct IntegerScalar {
  static constexpr const char* kExpected = "a whole number";
  static std::optional<Integer> read(const YamlValue& value) {
    return value.quoted ? std::nullopt : parsedNumberWithSign<Integer>(value.text);
  }
};
template <>
struct Scalar<int> : IntegerScalar<int> {};
template <>
struct Scalar<std::int64_t> : IntegerScalar<std::int64_t> {};

template <>
struct Scalar<bool> {
  static constexpr const char* kExpected = "'true' or 'false'";
  static std::optional<bool> read(const YamlValue& value) {
    if (value.quoted || (value.text != "true" && value.text != "false")) return std::nullopt;
    return value.text == "true";
  }
};

template <typename T>
struct IsList : std::false_type {};
template <typename T>
struct IsList<std::vector<T>> : std::true_type {};

}  // namespace

bool YamlNode::isMap() const {
  return value_ != nullptr && value_->kind == Kind::kMap;
}
bool YamlNode::isList() const {
  return value_ != nullptr && value_->kind == Kind::kList;
}
FilePosition YamlNode::where() const {
  return value_ != nullptr ? value_->where : FilePosition{};
}

void YamlNode::fail(std::string id, std::string text, std::vector<std::string> arguments) const {
  if (value_ != nullptr)
    document_->errors.push_back({std::move(id), std::move(text), std::move(arguments), where()});
}

YamlNode YamlNode::optionalChild(std::string_view key) const {
  if (value_ == nullptr) return {};
  if (!isMap()) {
    fail("yaml.type", "expected a map with the key '" + std::string(key) + "'", {std::string(key)});
    return {};
  }
  const auto found = std::ranges::find(value_->entries, key, &YamlValue::Entry::key);
  if (found == value_->entries.end()) return {};
  found->known = true;
  return {document_, &found->value};
}

YamlNode YamlNode::child(std::string_view key) const {
  const YamlNode node = optionalChild(key);
  if (node.empty() && isMap()) {
    fail("yaml.missing-key", "the key '" + std::string(key) + "' is missing here", {std::string(key)});
  }
  return node;
}

std::vector<std::pair<std::string, YamlNode>> YamlNode::entries() const {
  std::vector<std::pair<std::string, YamlNode>> result;
  if (value_ == nullptr) return result;
  if (!isMap()) fail("yaml.type", "here should be a map");
  for (const YamlValue::Entry& entry : value_->entries) {
    entry.known = true;
    result.emplace_back(entry.key, YamlNode(document_, &entry.value));
  }
  return result;
}

std::vector<YamlNode> YamlNode::items() const {
  std::vector<YamlNode> result;
  if (value_ == nullptr) return result;
  if (!isList()) fail("yaml.type", "here should be a list");
  for (const YamlValue& item : value_->items) result.emplace_back(document_, &item);
  return result;
}

template <typename T>
T YamlNode::as() const {
  T result{};
  if constexpr (IsList<T>::value) {
    for (const YamlNode& item : items()) result.push_back(item.as<typename T::value_type>());
  } else if (value_ != nullptr) {
    const auto read = value_->kind == Kind::kScalar ? Scalar<T>::read(*value_) : std::nullopt;
    if (read) return *read;
    const std::string found = value_->kind == Kind::kScalar ? ", not '" + value_->text + "'" : "";
    fail("yaml.type", "here should be " + std::string(Scalar<T>::kExpected) + found, {value_->text});
  }
  return result;
}

template std::string YamlNode::as() const;
template double YamlNode::as() const;
template int YamlNode::as() const;
template std::int64_t YamlNode::as() const;
template bool YamlNode::as() const;
template std::vector<std::string> YamlNode::as() const;
template std::vector<double> YamlNode::as() const;
template std::vector<int> YamlNode::as() const;

template <typename T>
T YamlNode::within(std::string_view key, T minimum, T maximum) const {
  const YamlNode node = child(key);
  if (node.empty()) return {};
  const std::size_t errors = document_->errors.size();
  const T number = node.as<T>();
  const bool isNumber = document_->errors.size() == errors;
  if (!isNumber) return minimum;
  if (number >= minimum && number <= maximum) return number;
  const auto shown = [](T value) { return YAML::Dump(YAML::Node(value)); };
  node.fail("yaml.range",
            "'" + std::string(key) + "' must be between " + shown(minimum) + " and " + shown(maximum),
            {std::string(key)});
  return minimum;
}

double YamlNode::numberIn(std::string_view key, double minimum, double maximum) const {
  return within(key, minimum, maximum);
}

int YamlNode::wholeNumberIn(std::string_view key, int minimum, int maximum) const {
  return within(key, minimum, maximum);
}

std::vector<double> YamlNode::numbers(std::string_view key, std::size_t count) const {
  const YamlNode node = child(key);
  auto result = node.as<std::vector<double>>();
  if (node.isList() && result.size() != count) {
    node.fail("yaml.length", "'" + std::string(key) + "' must have " + std::to_string(count) + " numbers",
              {std::string(key)});
  }
  result.resize(count);
  return result;
}

YamlReader::YamlReader(std::unique_ptr<YamlDocument> document) : document_(std::move(document)) {}
YamlReader::~YamlReader() = default;
YamlReader::YamlReader(YamlReader&&) noexcept = default;
YamlReader& YamlReader::operator=(YamlReader&&) noexcept = default;

Result<YamlReader> YamlReader::parse(std::string_view text, std::string file) {
  Converter converter{.file = std::move(file), .errors = {}};
  try {
    auto document = std::make_unique<YamlDocument>();
    document->root = converter.convert(YAML::Load(std::string(text)), 0);
    document->errors = std::move(converter.errors);
    return YamlReader(std::move(document));
  } catch (const YAML::Exception& exception) {
    return failure("yaml.syntax", "not valid YAML: " + exception.msg, converter.position(exception.mark));
  }
}

Result<YamlReader> YamlReader::load(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  return parse(*text, file.string());
}

YamlNode YamlReader::root() const {
  return {document_.get(), &document_->root};
}

tl::expected<void, Errors> YamlReader::finish() {
  collectUnknownKeys(document_->root, document_->errors);
  if (document_->errors.empty()) return {};
  std::ranges::stable_sort(document_->errors, {}, [](const Error& error) {
    return std::tuple(error.where.line, error.where.column);
  });
  return tl::unexpected(std::move(document_->errors));
}

}  // namespace robotlink
