// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ParameterText.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

namespace robotlink {
namespace {

namespace pb = google::protobuf;
using pb::FieldDescriptor;
using pb::Message;
using Places = pb::TextFormat::ParseInfoTree;

constexpr std::string_view kTextBlanks = " \t\r";
constexpr std::string_view kSeparators = ";, \t\r\n";

class Collector final : public pb::io::ErrorCollector {
 public:
  explicit Collector(std::string file) : file_(std::move(file)) {}
  void AddError(int line, pb::io::ColumnNumber column, const std::string& message) override {
    errors_.push_back({"parameters.text", message, {message}, {file_, line + 1, column + 1}});
  }
  void AddWarning(int line, pb::io::ColumnNumber column, const std::string& message) override {
    AddError(line, column, message);
  }
  const Errors& errors() const { return errors_; }

 private:
  std::string file_;
  Errors errors_;
};

/// A message with one field of another one.
std::unique_ptr<Message> onlyField(const Message& message, const FieldDescriptor* wanted) {
  std::unique_ptr<Message> copy(message.New());
  copy->CopyFrom(message);
  std::vector<const FieldDescriptor*> fields;
  copy->GetReflection()->ListFields(*copy, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field != wanted) copy->GetReflection()->ClearField(copy.get(), field);
  }
  return copy;
}

bool isSame(const Message& one, const Message& other, const FieldDescriptor* field) {
  return pb::util::MessageDifferencer::Equals(*onlyField(one, field), *onlyField(other, field));
}

std::string print(const Message& message, bool inOneLine) {
  pb::TextFormat::Printer printer;
  printer.SetUseShortRepeatedPrimitives(true);
  printer.SetSingleLineMode(inOneLine);
  std::string text;
  printer.PrintToString(message, &text);
  return text;
}

/// A part of a text, from a byte to one behind it.
struct Span {
  std::size_t begin = 0, end = 0;
};

/// Collects replacements of parts of a text, and makes them all at once.
class TextEdits {
 public:
  explicit TextEdits(const std::string& text) : text_(text) {
    lineStarts_.push_back(0);
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (text[at] == '\n') lineStarts_.push_back(at + 1);
    }
  }

  Span spanOf(const pb::TextFormat::ParseLocationRange& range) const {
    Span span{offsetOf(range.start), offsetOf(range.end)};
    while (span.end > span.begin && kSeparators.find(text_[span.end - 1]) != std::string_view::npos)
      --span.end;
    return span;
  }
  /// The value in "name: value".
  Span valueIn(Span field) const {
    std::size_t at = std::min(text_.find(':', field.begin), field.end) + 1;
    while (at < field.end && (text_[at] == '#' || text_[at] == '\n' || isBlank(at)))
      at = text_[at] == '#' ? std::min(text_.find('\n', at), field.end) : at + 1;
    return {std::min(at, field.end), field.end};
  }
  void replace(Span span, std::string by) { edits_.push_back({span, std::move(by)}); }
  /// Removes a field, and its line if nothing else is in it.
  void remove(Span span) {
    std::size_t begin = span.begin, end = span.end;
    while (end < text_.size() && (isBlank(end) || text_[end] == ';' || text_[end] == ',')) ++end;
    while (begin > 0 && isBlank(begin - 1)) --begin;
    const bool hasLine =
        (begin == 0 || text_[begin - 1] == '\n') && (end == text_.size() || text_[end] == '\n');
    if (hasLine) span = {begin, std::min(end + 1, text_.size())};
    replace(span, "");
  }
  /// Adds a field to the end of the message whose field has this place; of the whole text if there is none.
  void append(const Message& field, const Span* owner) {
    if (owner == nullptr) return replace({text_.size(), text_.size()}, print(field, false));
    const std::size_t close = owner->end - 1;
    std::size_t begin = close;
    while (begin > 0 && isBlank(begin - 1)) --begin;
    if (begin > 0 && text_[begin - 1] != '\n') {
      const std::string line = print(field, true);
      return replace({close, close}, (begin == close ? " " : "") + line + (line.ends_with(' ') ? "" : " "));
    }
    const std::string indentation = text_.substr(begin, close - begin) + "  ";
    std::string lines = indentation + print(field, false);
    lines.pop_back();
    for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 1 + indentation.size())
      lines.insert(at + 1, indentation);
    replace({begin, begin}, lines + "\n");
  }
  std::string applied() {
    std::ranges::stable_sort(edits_, {}, [](const Edit& edit) { return edit.span.begin; });
    std::string result;
    std::size_t at = 0;
    for (const Edit& edit : edits_) {
      result.append(text_, at, edit.span.begin - at);
      const bool needsLine = edit.span.begin == text_.size() && !result.empty() && result.back() != '\n';
      result += (needsLine ? "\n" : "") + edit.by;
      at = edit.span.end;
    }
    return result.append(text_, at);
  }

 private:
  struct Edit {
    Span span;
    std::string by;
  };
  bool isBlank(std::size_t at) const { return kTextBlanks.find(text_[at]) != std::string_view::npos; }
  /// The tokenizer counts columns with tabs of eight.
  std::size_t offsetOf(const pb::TextFormat::ParseLocation& place) const {
    constexpr int kTab = 8;
    std::size_t at =
        lineStarts_[std::min<std::size_t>(static_cast<std::size_t>(place.line), lineStarts_.size() - 1)];
    for (int column = 0; column < place.column && at < text_.size(); ++at)
      column += text_[at] == '\t' ? kTab - column % kTab : 1;
    return at;
  }

  const std::string& text_;
  std::vector<std::size_t> lineStarts_;
  std::vector<Edit> edits_;
};

std::vector<Span> spansOf(const TextEdits& edits, const Places& places, const FieldDescriptor* field) {
  std::vector<Span> spans;
  for (int i = 0;; ++i) {
    const auto range = places.GetLocationRange(field, field->is_repeated() ? i : -1);
    if (range.start.line < 0) break;
    spans.push_back(edits.spanOf(range));
    if (!field->is_repeated()) break;
  }
  return spans;
}

/// Edits one message of the text; `there` is the message in the text, and is updated.
void editMessage(TextEdits& edits, const Places& places, Message& there, const Message& before,
                 const Message& after, const Span* owner);

/// Edits the messages of a field one by one; false if the text does not have them all.
bool editNested(TextEdits& edits, const Places& places, const std::vector<Span>& spans, Message& there,
                const Message& before, const Message& after, const FieldDescriptor* field) {
  if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE || field->is_map() || spans.empty()) return false;
  const auto& reflection = *there.GetReflection();
  if (!field->is_repeated()) {
    if (!reflection.HasField(after, field)) return false;
    editMessage(edits, *places.GetTreeForNested(field, -1), *reflection.MutableMessage(&there, field),
                reflection.GetMessage(before, field), reflection.GetMessage(after, field), &spans.front());
    return true;
  }
  const int size = reflection.FieldSize(after, field);
  if (size != reflection.FieldSize(there, field) || size != reflection.FieldSize(before, field) ||
      static_cast<std::size_t>(size) != spans.size())
    return false;
  for (int i = 0; i < size; ++i)
    editMessage(edits, *places.GetTreeForNested(field, i),
                *reflection.MutableRepeatedMessage(&there, field, i),
                reflection.GetRepeatedMessage(before, field, i),
                reflection.GetRepeatedMessage(after, field, i), &spans[static_cast<std::size_t>(i)]);
  return true;
}

void editMessage(TextEdits& edits, const Places& places, Message& there, const Message& before,
                 const Message& after, const Span* owner) {
  const auto& reflection = *there.GetReflection();
  for (int i = 0; i < after.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor* field = after.GetDescriptor()->field(i);
    if (isSame(before, after, field)) continue;
    const std::vector<Span> spans = spansOf(edits, places, field);
    if (editNested(edits, places, spans, there, before, after, field)) continue;
    const auto wanted = onlyField(after, field);
    reflection.ClearField(&there, field);
    there.MergeFrom(*wanted);
    const bool isScalar = !field->is_repeated() && field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE;
    const bool isKept = isScalar && (!field->has_presence() || reflection.HasField(after, field));
    if (isKept && !spans.empty()) {
      std::string value;
      pb::TextFormat::PrintFieldValueToString(after, field, -1, &value);
      edits.replace(edits.valueIn(spans.front()), value);
      continue;
    }
    for (const Span& span : spans) edits.remove(span);
    if (wanted->ByteSizeLong() > 0) edits.append(*wanted, owner);
  }
}

}  // namespace

tl::expected<void, Errors> readParameterText(const std::string& text, const std::string& file,
                                             Message& message, Places* places) {
  Collector collector(file);
  pb::TextFormat::Parser parser;
  parser.RecordErrorsTo(&collector);
  parser.WriteLocationsTo(places);
  const bool isRead = parser.ParseFromString(text, &message);
  if (!collector.errors().empty()) return tl::unexpected(collector.errors());
  if (!isRead)
    return tl::unexpected(Errors{{"parameters.value", "not valid Protobuf text", {}, {file, 0, 0}}});
  return {};
}

void clearControls(Message& message) {
  constexpr char kControlType[] = "robotcontrol.BehaviorControl";
  const auto& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE || field->is_repeated()) continue;
    if (field->message_type()->full_name() == kControlType) {
      reflection.ClearField(&message, field);
    } else {
      clearControls(*reflection.MutableMessage(&message, field));
    }
  }
}

namespace {

std::unique_ptr<Message> withoutControls(const Message& message) {
  std::unique_ptr<Message> copy(message.New());
  copy->CopyFrom(message);
  clearControls(*copy);
  return copy;
}

}  // namespace

tl::expected<std::string, Errors> editedParameterText(const std::string& text, const std::string& file,
                                                      const Message& before, const Message& after) {
  Places places;
  const std::unique_ptr<Message> there(after.New()), result(after.New());
  if (auto isRead = readParameterText(text, file, *there, &places); !isRead)
    return tl::unexpected(isRead.error());
  TextEdits edits(text);
  editMessage(edits, places, *there, *withoutControls(before), *withoutControls(after), nullptr);
  const std::string edited = edits.applied();
  if (readParameterText(edited, file, *result) && pb::util::MessageDifferencer::Equals(*there, *result))
    return edited;
  return tl::unexpected(
      Errors{{"parameters.edit",
              "its values cannot be changed one by one; save the parameters to another file",
              {},
              {file, 0, 0}}});
}

std::string parameterText(const Message& message) {
  return print(*withoutControls(message), false);
}

}  // namespace robotlink
