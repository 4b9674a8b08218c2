// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

/// A new temporary folder for the files of a test, removed with all its contents by the destructor.
class TestFolder {
 public:
  /// In memory, where that can be: thousands of small files take long on a disk.
  enum class Where : std::uint8_t { kDisk, kMemory };

  explicit TestFolder(Where where = Where::kDisk) {
    std::error_code ignored;
    const std::filesystem::path memory = "/dev/shm";
    const bool inMemory = where == Where::kMemory && std::filesystem::is_directory(memory, ignored);
    const auto parent = inMemory ? memory : std::filesystem::temp_directory_path();
    std::string name = (parent / "robotcontrol-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Writes a file, creating its folders; returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const auto file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  /// The names of all files in the folder, sorted.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }
  /// The same names, separated by spaces.
  std::string contents() const {
    std::string text;
    for (const std::string& name : files()) text += (text.empty() ? "" : " ") + name;
    return text;
  }

 private:
  std::filesystem::path path_;
};
