// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/fuzz/FuzzTarget.h"

// Runs fuzzing targets without libFuzzer: one of the program's over its seeds as they are, then over random
// mutations of them. Every input depends on its number alone, so that one that crashed can be run again.
//
//   PROGRAM NAME [--seconds N | --inputs N]   mutate for so long, or so often (1000 inputs by default)
//   PROGRAM NAME --seconds N FROM             the same from the input with this number on
//   PROGRAM NAME --only N                     run the input with this number alone
//   PROGRAM NAME --write-seeds FOLDER         write the seeds as files, for libFuzzer
//   PROGRAM NAME FILE...                      run files, such as those that libFuzzer left
//   PROGRAM --list                            list the names of the targets
//
// The seeds are those of the target and, if it has one, those of its corpus: corpus/NAME.txt in this folder
// has inputs that libFuzzer found to be worth keeping, in hexadecimal digits, one a line (packaging/fuzz.sh
// --keep).
namespace {

using Random = std::mt19937_64;

volatile std::sig_atomic_t runningInput = -1;

/// No input takes so much time of the processor, s; where one does, it hangs. The same as in
/// packaging/fuzz.sh.
constexpr int kHangs = 30;

/// Says which input it was and dies of the signal after all.
void tellInput(int signal) {
  char text[96];
  const int length = std::snprintf(text, sizeof text, "signal %d in input %d: run it again with --only %d\n",
                                   signal, static_cast<int>(runningInput), static_cast<int>(runningInput));
  static_cast<void>(!::write(STDERR_FILENO, text, static_cast<std::size_t>(length)));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::size_t pick(Random& random, std::size_t count) {
  return count == 0 ? 0 : random() % count;
}

/// Numbers at which lengths and counts break.
std::uint64_t awkwardNumber(Random& random) {
  static constexpr std::uint64_t kNumbers[] = {0,          1,           2,         0x7F,        0x80,
                                               0xFF,       0x7FFF,      0xFFFF,    0x7FFFFFFF,  0x80000000,
                                               0xFFFFFFFF, 1ULL << 40U, INT64_MAX, 1ULL << 63U, UINT64_MAX};
  return kNumbers[pick(random, std::size(kNumbers))];
}

void overwrite(std::string& input, std::size_t at, const void* bytes, std::size_t count) {
  if (at < input.size()) std::memcpy(input.data() + at, bytes, std::min(count, input.size() - at));
}

/// What readers of text take for numbers, texts, lists or none of these.
const char* awkwardWord(Random& random) {
  static constexpr const char* kWords[] = {"0",
                                           "-1",
                                           "7",
                                           "0.5",
                                           "-0.0",
                                           "1e300",
                                           "1e-320",
                                           "1e999",
                                           "-1e999",
                                           "2147483648",
                                           "-9223372036854775808",
                                           "18446744073709551615",
                                           "99999999999999999999",
                                           "true",
                                           "null",
                                           "NaN",
                                           ".inf",
                                           "\"\"",
                                           "\"x\"",
                                           "\"\\u0000\"",
                                           "[]",
                                           "[1]",
                                           "[[], {}]",
                                           "{}",
                                           "{\"a\": 1}",
                                           "~",
                                           "*a",
                                           "&a",
                                           "x",
                                           ""};
  return kWords[pick(random, std::size(kWords))];
}

/// Replaces a number, a word or a text in quotes by one of another type.
void exchangeWord(std::string& input, std::size_t at, Random& random) {
  const auto inWord = [&](std::size_t i) {
    const auto c = static_cast<unsigned char>(input[i]);
    return std::isalnum(c) != 0 || c == '-' || c == '.' || c == '_' || c == '"';
  };
  while (at < input.size() && !inWord(at)) ++at;
  if (at >= input.size()) return;
  std::size_t begin = at, end = at;
  while (begin > 0 && inWord(begin - 1)) --begin;
  while (end < input.size() && inWord(end)) ++end;
  input.replace(begin, end - begin, awkwardWord(random));
}

void mutate(std::string& input, const std::vector<std::string>& seeds, Random& random) {
  const std::size_t at = pick(random, input.size());
  const std::size_t count = 1 + pick(random, pick(random, 2) == 0 ? 8 : 200);
  switch (random() % 10) {
    case 0:
      if (!input.empty()) input[at] = static_cast<char>(input[at] ^ (1 << (random() % 8)));
      break;
    case 1:
      if (!input.empty()) input[at] = static_cast<char>(random());
      break;
    case 2: {
      const std::uint64_t number = awkwardNumber(random);
      overwrite(input, at, &number, std::size_t{1} << (random() % 4));
      break;
    }
    case 3:
      input.erase(at, count);
      break;
    case 4:
      input.insert(at, std::string(count, static_cast<char>(random())));
      break;
    case 5:
      input.insert(pick(random, input.size()), input.substr(at, count));
      break;
    case 6:
      input.resize(at);
      break;
    case 7:
    case 8:
      exchangeWord(input, at, random);
      break;
    default: {
      const std::string& other = seeds[pick(random, seeds.size())];
      const std::size_t from = pick(random, other.size());
      input.replace(at, count, other.substr(from, 1 + pick(random, 400)));
    }
  }
}

std::string inputOf(const FuzzTarget& target, std::uint64_t number, const std::vector<std::string>& seeds) {
  if (number < seeds.size()) return seeds[number];
  Random random(number);
  std::string input = seeds[pick(random, seeds.size())];
  // Three of four by the target's own mutations, if it has them.
  if (target.mutate != nullptr && pick(random, 4) > 0)
    return target.mutate(input, static_cast<unsigned>(random()));
  for (std::size_t i = 1 + pick(random, 4); i > 0; --i) mutate(input, seeds, random);
  return input;
}

/// The bytes of a line of hexadecimal digits.
std::string corpusInput(const std::string& line) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < line.size(); i += 2)
    bytes += static_cast<char>(std::stoi(line.substr(i, 2), nullptr, 16));
  return bytes;
}

/// The seeds of the target, then those of its corpus.
std::vector<std::string> allSeeds(const FuzzTarget& target) {
  std::vector<std::string> seeds = target.seeds();
  std::ifstream corpus(std::string(ROBOTCONTROL_SOURCE_DIR "/tests/fuzz/corpus/") + target.name + ".txt");
  for (std::string line; std::getline(corpus, line);) seeds.push_back(corpusInput(line));
  return seeds;
}

void run(const FuzzTarget& target, const std::string& input) {
  // Its own memory, exactly as large, so that the address sanitizer sees what is read behind it.
  const std::vector<std::uint8_t> bytes(input.begin(), input.end());
  const itimerval limit{{0, 0}, {kHangs, 0}};
  ::setitimer(ITIMER_PROF, &limit, nullptr);
  target.run(bytes.data(), bytes.size());
}

int runMany(const FuzzTarget& target, double seconds, std::uint64_t inputs, std::uint64_t first = 0) {
  const std::vector<std::string> seeds = allSeeds(target);
  if (seeds.empty()) {
    std::fputs("there are no seeds\n", stderr);
    return 1;
  }
  const auto start = std::chrono::steady_clock::now();
  std::uint64_t number = first;
  for (;; ++number) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    if (seconds > 0 ? passed.count() >= seconds : number >= inputs) break;
    runningInput = static_cast<std::sig_atomic_t>(number);
    run(target, inputOf(target, number, seeds));
  }
  std::printf("%llu inputs from %zu seeds: none did harm\n", static_cast<unsigned long long>(number),
              seeds.size());
  return number > seeds.size() ? 0 : 1;
}

int writeSeeds(const FuzzTarget& target, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : allSeeds(target)) {
    std::ofstream file(folder / ("seed-" + std::to_string(number++)), std::ios::binary);
    file.write(seed.data(), static_cast<std::streamsize>(seed.size()));
    if (!file) return 1;
  }
  return 0;
}

int runAsTold(const FuzzTarget& target, const std::vector<std::string>& words) {
  if (words.empty()) return runMany(target, 0, 1000);
  if (words.size() == 2 && words[0] == "--seconds") return runMany(target, std::atof(words[1].c_str()), 0);
  if (words.size() == 3 && words[0] == "--seconds")
    return runMany(target, std::atof(words[1].c_str()), 0, std::strtoull(words[2].c_str(), nullptr, 10));
  if (words.size() == 2 && words[0] == "--inputs")
    return runMany(target, 0, std::strtoull(words[1].c_str(), nullptr, 10));
  if (words.size() == 2 && words[0] == "--write-seeds") return writeSeeds(target, words[1]);
  if (words.size() == 2 && words[0] == "--only") {
    run(target, inputOf(target, std::strtoull(words[1].c_str(), nullptr, 10), allSeeds(target)));
    return 0;
  }
  for (const std::string& name : words) {
    std::ifstream file(name, std::ios::binary);
    if (!file) {
      std::fprintf(stderr, "cannot read %s\n", name.c_str());
      return 2;
    }
    run(target, {std::istreambuf_iterator<char>(file), {}});
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGPROF})
    std::signal(signal, &tellInput);
  const std::vector<std::string> words(arguments + 1, arguments + count);
  const std::string first = words.empty() ? "" : words[0];
  for (const FuzzTarget& target : fuzzTargets()) {
    if (first == "--list") {
      std::puts(target.name);
    } else if (first == target.name) {
      const int result = runAsTold(target, {words.begin() + 1, words.end()});
      if (target.end != nullptr) target.end();
      return result;
    }
  }
  if (first == "--list") return 0;
  std::fprintf(stderr, "there is no target '%s'; --list lists them\n", first.c_str());
  return 2;
}
