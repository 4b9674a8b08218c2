// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionLibrary.h"

#include <algorithm>
#include <set>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/motions/MotionReader.h"

namespace robotlink {
namespace {

using Entries = std::vector<MotionLibrary::Entry>;

Entries::iterator placeOf(Entries& entries, const std::string& name) {
  return std::ranges::lower_bound(entries, name, {}, &MotionLibrary::Entry::name);
}

/// The name that a text gives its motion; that of the file if it gives none.
std::string nameIn(std::string_view text, const std::filesystem::path& path) {
  std::string name = parseMotion(text, {}).motion.name;
  return name.empty() ? path.stem().string() : name;
}

bool hasStart(const MotionFile& file) {
  return std::ranges::any_of(file.lines, [](const MotionLine& line) {
    const auto* label = std::get_if<MotionLabel>(&line.statement);
    return label != nullptr && label->name == "start";
  });
}

/// Lists all motions in the entry table that it does not list yet.
void completeTable(std::vector<MotionFile>& files) {
  const auto table = std::ranges::find(files, MotionNet::kEntryName, &MotionFile::name);
  if (table == files.end()) return;
  std::set<std::string> listed{MotionNet::kEntryName};
  auto start = table->lines.end();
  for (auto line = table->lines.begin(); line != table->lines.end(); ++line) {
    if (const auto* transition = std::get_if<MotionTransition>(&line->statement))
      listed.insert(transition->request);
    const auto* label = std::get_if<MotionLabel>(&line->statement);
    if (label != nullptr && label->name == "start") start = line + 1;
  }
  if (start == table->lines.end()) return;
  std::vector<MotionLine> added;
  for (const MotionFile& file : files) {
    if (!listed.contains(file.name) && hasStart(file))
      added.push_back({MotionTransition{file.name, file.name, "start"}, {}, 0});
  }
  table->lines.insert(start, added.begin(), added.end());
}

}  // namespace

tl::expected<MotionLibrary, Errors> MotionLibrary::load(const std::filesystem::path& folder) {
  std::error_code error;
  MotionLibrary library;
  Errors errors;
  for (std::filesystem::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    const std::filesystem::path& path = i->path();
    if (fileSuffix(path) != ".mof") continue;
    if (library.entries_.size() >= kMaxMotionFiles) {
      return tl::unexpected(Errors{{"motion.too-many-files",
                                    "a robot has at most " + std::to_string(kMaxMotionFiles) + " motions",
                                    {},
                                    {folder.string(), 0, 0}}});
    }
    auto text = readFile(path, kMaxTextBytes);
    if (text) {
      std::string name = nameIn(*text, path);
      library.entries_.push_back({std::move(name), std::move(*text), path.string(), false});
    } else {
      errors.push_back({"motion.unreadable",
                        "the file cannot be read; check its name, size and permissions",
                        {},
                        {path.string(), 0, 0}});
    }
  }
  if (error)
    errors.push_back(
        {"motion.unreadable", "the folder cannot be read: " + error.message(), {}, {folder.string(), 0, 0}});
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  std::ranges::sort(library.entries_, {}, &Entry::name);
  return library;
}

const MotionLibrary::Entry* MotionLibrary::find(const std::string& name) const {
  const auto found = std::ranges::find(entries_, name, &Entry::name);
  return found == entries_.end() ? nullptr : &*found;
}

void MotionLibrary::replace(const std::string& name, std::string text) {
  const auto place = placeOf(entries_, name);
  const bool isKnown = place != entries_.end() && place->name == name;
  const auto own = std::ranges::find(replaced_, name, &Entry::name);
  if (text.empty()) {
    if (!isKnown || !place->isReplaced) return;
    if (own == replaced_.end()) {
      entries_.erase(place);
    } else {
      *place = *own;
      replaced_.erase(own);
    }
    return;
  }
  if (isKnown && !place->isReplaced) replaced_.push_back(*place);
  Entry entry{name, std::move(text), name + ".mof", true};
  if (isKnown)
    *place = std::move(entry);
  else
    entries_.insert(place, std::move(entry));
}

tl::expected<std::shared_ptr<const MotionNet>, Errors> MotionLibrary::compile(
    const std::vector<std::string>& joints) const {
  std::vector<MotionFile> files;
  Errors errors;
  for (const Entry& entry : entries_) {
    MotionParse parse = parseMotion(entry.text, entry.path, joints);
    errors.insert(errors.end(), parse.errors.begin(), parse.errors.end());
    files.push_back(std::move(parse.motion));
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  completeTable(files);
  return compileMotions(files, joints);
}

tl::expected<std::shared_ptr<const MotionNet>, Errors> loadMotions(const std::filesystem::path& folder,
                                                                   const std::vector<std::string>& joints) {
  return MotionLibrary::load(folder).and_then(
      [&](const MotionLibrary& library) { return library.compile(joints); });
}

}  // namespace robotlink
