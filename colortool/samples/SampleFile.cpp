// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/SampleFile.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <type_traits>
#include <utility>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/TextParts.h"

namespace colortool {
namespace {

using Json = nlohmann::ordered_json;
using robotlink::Result;

constexpr char kFormat[] = "robotcontrol samples";
constexpr int kVersion = 1;
constexpr std::size_t kMaxBytes = std::size_t{512} << 20U;
constexpr int kMaxSide = 1 << 16;
constexpr std::size_t kMaxProblems = 100;
constexpr std::array<const char*, 3> kMethodNames = {"votes", "gaussians", "support_vectors"};

void appendHex(std::string& text, std::uint8_t byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  text += kDigits[byte >> 4U];
  text += kDigits[byte & 15U];
}

/// Thrown only within this file when a line is invalid; the text becomes an error with the line number.
struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Parses groups of three bytes, two hexadecimal digits each.
std::vector<std::array<std::uint8_t, 3>> triplesOf(const std::string& hex, const char* what) {
  const auto digit = [&](char c) -> unsigned {
    if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
    if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a') + 10;
    throw Wrong(std::string(what) + " are written with the digits 0 to 9 and a to f, not '" + c + "'");
  };
  if (hex.size() % 6 != 0) throw Wrong(std::string(what) + " have six digits each");
  std::vector<std::array<std::uint8_t, 3>> triples(hex.size() / 6);
  for (std::size_t i = 0; i < hex.size(); i += 2)
    triples[i / 6][i / 2 % 3] = static_cast<std::uint8_t>(digit(hex[i]) << 4U | digit(hex[i + 1]));
  return triples;
}

/// The value of an integer, if it is in range.
template <typename T>
T whole(const Json& value, const std::string& name) {
  if (value.is_number_unsigned()) {
    if (const auto number = value.get<std::uint64_t>(); std::in_range<T>(number))
      return static_cast<T>(number);
  } else if (value.is_number_integer()) {
    if (const auto number = value.get<std::int64_t>(); std::in_range<T>(number))
      return static_cast<T>(number);
  }
  throw Wrong("\"" + name + "\" is not a whole number, or too large");
}

template <typename T>
struct ListOf;
template <typename T>
struct ListOf<std::vector<T>> {
  static std::vector<T> sized(std::size_t count, const std::string&) { return std::vector<T>(count); }
};
template <typename T, std::size_t kCount>
struct ListOf<std::array<T, kCount>> {
  static std::array<T, kCount> sized(std::size_t count, const std::string& name) {
    if (count != kCount) throw Wrong("\"" + name + "\" does not have " + std::to_string(kCount) + " numbers");
    return {};
  }
};

/// The value, if it has the right type: the library converts numbers that do not fit, and throws for other
/// types.
template <typename T>
T checked(const Json& value, const std::string& name) {
  if constexpr (std::is_same_v<T, std::string>) {
    if (!value.is_string()) throw Wrong("\"" + name + "\" is not a text in quotes");
    return value.get<std::string>();
  } else if constexpr (std::is_same_v<T, bool>) {
    if (!value.is_boolean()) throw Wrong("\"" + name + "\" is neither true nor false");
    return value.get<bool>();
  } else if constexpr (std::is_floating_point_v<T>) {
    if (!value.is_number()) throw Wrong("\"" + name + "\" is not a number");
    return value.get<T>();
  } else if constexpr (std::is_integral_v<T>) {
    return whole<T>(value, name);
  } else {
    if (!value.is_array()) throw Wrong("\"" + name + "\" is not a list of numbers");
    T list = ListOf<T>::sized(value.size(), name);
    std::ranges::transform(value, list.begin(), [&](const Json& element) {
      return checked<typename T::value_type>(element, name);
    });
    return list;
  }
}

const Json& part(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) throw Wrong("there is no \"" + std::string(name) + "\"");
  return *found;
}

/// A member with further members; an empty one if it is missing.
const Json& optionalPart(const Json& object, const char* name) {
  static const Json none = Json::object();
  const auto found = object.find(name);
  if (found == object.end()) return none;
  if (!found->is_object()) throw Wrong("\"" + std::string(name) + "\" is not an object in braces");
  return *found;
}

template <typename T>
T member(const Json& object, const char* name) {
  return checked<T>(part(object, name), name);
}

/// Leaves `value` unchanged if there is no such member.
template <typename T>
void optional(const Json& object, const char* name, T& value) {
  if (const auto found = object.find(name); found != object.end()) value = checked<T>(*found, name);
}

int side(const Json& object, const char* name) {
  const int value = member<int>(object, name);
  if (value < 1 || value > kMaxSide) throw Wrong(std::string(name) + " is not that of an image");
  return value;
}

// The functions for writing and reading each kind of line are next to each other.

Json written(const TrainingSettings& s) {
  return {{"settings",
           {{"method", kMethodNames.at(static_cast<std::size_t>(s.method))},
            {"votes",
             {{"radius", s.votes.radius},
              {"brightness_weight", s.votes.brightnessWeight},
              {"rejection", s.votes.rejection},
              {"background_weight", s.votes.backgroundWeight},
              {"shading", s.votes.shading},
              {"gray_guard", s.votes.grayGuard}}},
            {"gaussians", {{"most_squared_distance", s.gaussians.mostSquaredDistance}}},
            {"support_vectors",
             {{"cost", s.supportVectors.cost},
              {"gamma", s.supportVectors.gamma},
              {"most_distance", s.supportVectors.mostDistance}}},
            {"clean_up",
             {{"remove_unsupported", s.cleanUp.removeUnsupported}, {"fill_holes", s.cleanUp.fillHoles}}},
            {"correct_vignetting", s.correctVignetting},
            {"correct_cameras", s.correctCameras}}}};
}

TrainingSettings readSettings(const Json& line) {
  const Json& object = optionalPart(line, "settings");
  TrainingSettings s;
  std::string method = kMethodNames[0];
  optional(object, "method", method);
  const auto known = std::ranges::find(kMethodNames, method);
  if (known == kMethodNames.end()) throw Wrong("there is no method \"" + method + "\"");
  s.method = static_cast<TrainingMethod>(known - kMethodNames.begin());
  const Json &votes = optionalPart(object, "votes"), &gaussians = optionalPart(object, "gaussians"),
             &vectors = optionalPart(object, "support_vectors"), &cleanUp = optionalPart(object, "clean_up");
  optional(votes, "radius", s.votes.radius);
  optional(votes, "brightness_weight", s.votes.brightnessWeight);
  optional(votes, "rejection", s.votes.rejection);
  optional(votes, "background_weight", s.votes.backgroundWeight);
  optional(votes, "shading", s.votes.shading);
  optional(votes, "gray_guard", s.votes.grayGuard);
  optional(gaussians, "most_squared_distance", s.gaussians.mostSquaredDistance);
  optional(vectors, "cost", s.supportVectors.cost);
  optional(vectors, "gamma", s.supportVectors.gamma);
  optional(vectors, "most_distance", s.supportVectors.mostDistance);
  if (!(s.supportVectors.cost > 0) || !(s.supportVectors.gamma > 0))
    throw Wrong("cost and gamma are more than 0");
  optional(cleanUp, "remove_unsupported", s.cleanUp.removeUnsupported);
  optional(cleanUp, "fill_holes", s.cleanUp.fillHoles);
  optional(object, "correct_vignetting", s.correctVignetting);
  optional(object, "correct_cameras", s.correctCameras);
  return s;
}

Json written(const CameraCorrection& c) {
  const Vignetting& lens = c.correction.vignetting;
  Json gains = Json::array(), offsets = Json::array();
  for (const ChannelLine& channel : c.correction.channels) {
    gains.push_back(channel.gain);
    offsets.push_back(channel.offset);
  }
  return {{"correction", c.camera}, {"luma", lens.luma}, {"blue", lens.blue},
          {"red", lens.red},        {"gains", gains},    {"offsets", offsets}};
}

CameraCorrection readCorrection(const Json& line) {
  CameraCorrection c{member<std::string>(line, "correction"), {}};
  Vignetting& lens = c.correction.vignetting;
  lens.luma = member<std::array<double, 2>>(line, "luma");
  lens.blue = member<std::array<double, 2>>(line, "blue");
  lens.red = member<std::array<double, 2>>(line, "red");
  const auto gains = member<std::array<double, 3>>(line, "gains"),
             offsets = member<std::array<double, 3>>(line, "offsets");
  for (std::size_t i = 0; i < gains.size(); ++i) c.correction.channels[i] = {gains[i], offsets[i]};
  return c;
}

Json written(const SampleImage& image) {
  return {{"image", image.id},          {"name", image.name},   {"camera", image.camera},
          {"lighting", image.lighting}, {"width", image.width}, {"height", image.height}};
}

SampleImage readImage(const Json& line) {
  return {member<std::uint64_t>(line, "image"),
          member<std::string>(line, "name"),
          member<std::string>(line, "camera"),
          member<std::string>(line, "lighting"),
          side(line, "width"),
          side(line, "height")};
}

Json written(const Stroke& stroke, const ColorClasses& classes) {
  std::vector<int> runs;
  for (const PixelRun& run : stroke.area) runs.insert(runs.end(), {run.y, run.begin, run.end});
  std::string colors, thumbnail;
  for (const robotlink::YCbCr& color : stroke.colors) {
    for (const std::uint8_t value : {color.y, color.cb, color.cr}) appendHex(colors, value);
  }
  for (const robotlink::Rgb& pixel : stroke.thumbnail.pixels) {
    for (const std::uint8_t value : {pixel.r, pixel.g, pixel.b}) appendHex(thumbnail, value);
  }
  const bool background = stroke.colorClass == ColorClasses::kNone;
  Json line = {{"stroke", stroke.id},
               {"image", stroke.image},
               {"class", background ? "" : classes.name(stroke.colorClass)},
               {"must_not_be", stroke.mustNotBe},
               {"weight", stroke.weight},
               {"tool", stroke.tool},
               {"runs", runs},
               {"colors", colors}};
  if (!stroke.thumbnail.pixels.empty())
    line["thumbnail"] = {
        {"width", stroke.thumbnail.width}, {"height", stroke.thumbnail.height}, {"rgb", thumbnail}};
  return line;
}

PixelArea readArea(const Json& line, const SampleImage& image) {
  const auto numbers = member<std::vector<int>>(line, "runs");
  if (numbers.size() % 3 != 0) throw Wrong("runs have three numbers each");
  PixelArea area;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    area.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  if (area.empty() || !isValid(area, image.width, image.height))
    throw Wrong("the runs are not pixels of image " + std::to_string(image.id) + ", row by row");
  return area;
}

Thumbnail readThumbnail(const Json& object) {
  Thumbnail thumbnail{side(object, "width"), side(object, "height"), {}};
  for (const auto& [r, g, b] : triplesOf(member<std::string>(object, "rgb"), "the thumbnail's pixels"))
    thumbnail.pixels.push_back({r, g, b});
  if (thumbnail.width > Thumbnail::kMaxSide || thumbnail.height > Thumbnail::kMaxSide ||
      thumbnail.pixels.size() !=
          static_cast<std::size_t>(thumbnail.width) * static_cast<std::size_t>(thumbnail.height))
    throw Wrong("the thumbnail's pixels do not fit its size");
  return thumbnail;
}

Stroke readStroke(const Json& line, const Samples& samples) {
  Stroke stroke;
  stroke.id = member<std::uint64_t>(line, "stroke");
  stroke.image = member<std::uint64_t>(line, "image");
  const SampleImage* image = samples.image(stroke.image);
  if (image == nullptr) throw Wrong("there is no image " + std::to_string(stroke.image) + " before it");
  const auto name = member<std::string>(line, "class");
  stroke.colorClass = name.empty() ? ColorClasses::kNone : samples.classes.index(name);
  if (!name.empty() && stroke.colorClass == ColorClasses::kNone)
    throw Wrong("there is no class \"" + name + "\" before it");
  optional(line, "must_not_be", stroke.mustNotBe);
  optional(line, "weight", stroke.weight);
  if (!(stroke.weight >= Stroke::kMinWeight && stroke.weight <= Stroke::kMaxWeight))
    throw Wrong("its weight is not between 0.1 and 10");
  optional(line, "tool", stroke.tool);
  stroke.area = readArea(line, *image);
  for (const auto& [y, cb, cr] : triplesOf(member<std::string>(line, "colors"), "colors"))
    stroke.colors.push_back({y, cb, cr});
  if (stroke.colors.size() != pixelCount(stroke.area))
    throw Wrong("it has " + std::to_string(stroke.colors.size()) + " colors for " +
                std::to_string(pixelCount(stroke.area)) + " pixels");
  if (line.contains("thumbnail")) stroke.thumbnail = readThumbnail(optionalPart(line, "thumbnail"));
  return stroke;
}

NamedColor readClass(const Json& line) {
  NamedColor named{member<std::string>(line, "class"), {}};
  const auto color = member<std::string>(line, "color");
  if (named.name.empty() || color.empty() || color.front() != '#')
    throw Wrong("a class has a name and a color like \"#ff6900\"");
  const auto triples = triplesOf(color.substr(1), "colors");
  if (triples.size() != 1) throw Wrong("a class has a name and a color like \"#ff6900\"");
  named.rgb = {triples[0][0], triples[0][1], triples[0][2]};
  return named;
}

/// Collects the contents of all lines.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  /// The first line identifies the file format.
  Result<void> begin(std::string_view line) {
    const Json head = Json::parse(line, nullptr, false);
    const auto format = head.is_object() ? head.find("format") : head.end();
    if (format == head.end() || *format != kFormat)
      return robotlink::failure("samples.format",
                                "this is not a samples file: its first line does not say so", {file_, 1, 0});
    const auto version = head.find("version");
    if (version == head.end() || !version->is_number_integer() || *version < 1)
      return robotlink::failure("samples.version",
                                "its first line does not say which version of the format it has; it should "
                                "end in \"version\": 1",
                                {file_, 1, 0});
    if (*version > kVersion)
      return robotlink::failure(
          "samples.version",
          "it is of version " + version->dump() + ", which this program does not know; use a newer one",
          {file_, 1, 0});
    return {};
  }

  void take(std::string_view line, int number) {
    try {
      const Json object = Json::parse(line);
      if (!object.is_object()) throw Wrong("a line holds one JSON object");
      take(object);
    } catch (const Json::parse_error& error) {
      problem(number, "this is not JSON", static_cast<int>(error.byte));
    } catch (const Json::exception&) {
      problem(number, "a number is too large", 0);
    } catch (const Wrong& wrong) {
      problem(number, wrong.what(), 0);
    }
  }

  ReadSamples finish() {
    Samples& samples = read_.samples;
    std::ranges::stable_sort(samples.strokes, {}, [](const StrokePtr& stroke) { return stroke->id; });
    std::erase_if(samples.images, [&](const SampleImage& image) {
      return std::ranges::none_of(samples.strokes,
                                  [&](const StrokePtr& stroke) { return stroke->image == image.id; });
    });
    return std::move(read_);
  }

 private:
  void take(const Json& object) {
    Samples& samples = read_.samples;
    if (object.contains("stroke")) {
      auto stroke = std::make_shared<Stroke>(readStroke(object, samples));
      if (!strokeIds_.insert(stroke->id).second)
        throw Wrong("there is a stroke " + std::to_string(stroke->id) + " before it");
      samples.strokes.push_back(std::move(stroke));
    } else if (object.contains("image")) {
      SampleImage image = readImage(object);
      if (samples.image(image.id) != nullptr)
        throw Wrong("there is an image " + std::to_string(image.id) + " before it");
      samples.images.push_back(std::move(image));
    } else if (object.contains("class")) {
      NamedColor named = readClass(object);
      if (samples.classes.index(named.name) != ColorClasses::kNone || named.name == samples.classes.name(0))
        throw Wrong("there is a class \"" + named.name + "\" before it");
      if (classes_.size() == static_cast<std::size_t>(ColorClasses::kMax))
        throw Wrong("there are too many of them");
      classes_.push_back(std::move(named));
      samples.classes = ColorClasses(classes_);
    } else if (object.contains("settings")) {
      samples.settings = readSettings(object);
    } else if (object.contains("correction")) {
      samples.corrections.push_back(readCorrection(object));
    }
  }

  void problem(int line, const std::string& what, int column) {
    if (read_.problems.size() < kMaxProblems)
      read_.problems.push_back({"samples.line", "this line is skipped: " + what, {}, {file_, line, column}});
  }

  std::string file_;
  ReadSamples read_;
  std::vector<NamedColor> classes_;
  std::set<std::uint64_t> strokeIds_;
};

}  // namespace

Result<ReadSamples> parseSamples(std::string_view text, const std::string& file) {
  Reader reader(file);
  int number = 0;
  while (!text.empty() || number == 0) {
    const std::string_view line = robotlink::takeLine(text);
    if (++number == 1) {
      if (auto begun = reader.begin(line); !begun) return tl::unexpected(begun.error());
    } else if (line.find_first_not_of(" \t\r") != std::string_view::npos) {
      reader.take(line, number);
    }
  }
  return reader.finish();
}

Result<ReadSamples> loadSamples(const std::filesystem::path& file) {
  const auto text = robotlink::readFile(file, kMaxBytes);
  if (!text) return tl::unexpected(text.error());
  return parseSamples(*text, file.string());
}

std::string samplesText(const Samples& samples) {
  std::string text = Json{{"format", kFormat}, {"version", kVersion}}.dump() + "\n";
  // Names come from the user: invalid UTF-8 is replaced.
  const auto add = [&](const Json& line) {
    text += line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  };
  for (int i = 1; i < samples.classes.size(); ++i) {
    std::string color = "#";
    const robotlink::Rgb rgb = samples.classes.shownColor(i);
    for (const std::uint8_t value : {rgb.r, rgb.g, rgb.b}) appendHex(color, value);
    add({{"class", samples.classes.name(i)}, {"color", color}});
  }
  add(written(samples.settings));
  for (const CameraCorrection& correction : samples.corrections) add(written(correction));
  for (const SampleImage& image : samples.images) add(written(image));
  for (const StrokePtr& stroke : samples.strokes) add(written(*stroke, samples.classes));
  return text;
}

Result<void> saveSamples(const Samples& samples, const std::filesystem::path& file) {
  return robotlink::writeFileAtomically(file, samplesText(samples));
}

}  // namespace colortool
