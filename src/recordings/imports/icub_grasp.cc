#include "recordings/imports/icub_grasp.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "base/text/number_of_text.h"
#include "somato/core/value.h"

namespace somato {
namespace {

constexpr std::size_t kIcubJoints = 9;
constexpr std::size_t kFingers = 5;
constexpr std::size_t kTaxelsPerFinger = 12;
constexpr std::size_t kLinesPerStep = 2 + kFingers;
constexpr std::string_view kMarker = "-10000";
constexpr std::string_view kBlanks = " \t\r";
const std::vector<std::string> kJointNames{
    "finger_spread", "thumb_opposition", "thumb_proximal", "thumb_distal",   "index_proximal",
    "index_distal",  "middle_proximal",  "middle_distal",  "ring_and_little"};
const std::vector<std::string> kFingerNames{"thumb", "index", "middle", "ring", "little"};

struct Trial {
  std::filesystem::path file;
  std::string object;
  unsigned number = 0;
};

// The lines without their ends; blank ones at the end of the file do not count.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  while (!lines.empty() && lines.back().find_first_not_of(kBlanks) == std::string_view::npos) {
    lines.pop_back();
  }
  return lines;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  std::size_t start = line.find_first_not_of(kBlanks);
  while (start != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, start), line.size());
    fields.push_back(line.substr(start, end - start));
    start = line.find_first_not_of(kBlanks, end);
  }
  return fields;
}

std::optional<float> finite_number(std::string_view field) {
  const auto number = number_of_text<float>(field);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

// The content of a line of a time step, and its number of values.
struct LineContent {
  std::string name;
  std::size_t count;
};

LineContent content_of(std::size_t line_of_step) {
  if (line_of_step == 0) return {"joint angles", kIcubJoints};
  if (line_of_step == 1) return {"finger pressures", kFingers};
  return {"taxels of the " + kFingerNames[line_of_step - 2] + " finger", kTaxelsPerFinger};
}

// Reads one grasp's text; every error has file and line.
class GraspReader {
 public:
  GraspReader(std::string file, std::string_view text)
      : file_(std::move(file)), lines_(lines_of(text)) {}

  Result<std::vector<Channel>> read() const {
    Result<void> checked = check_layout();
    if (!checked) return fail(std::move(checked.error()));
    const std::size_t steps = (lines_.size() - 1) / kLinesPerStep;
    Matrix<float> joints(steps, kIcubJoints);
    Matrix<float> pressures(steps, kFingers);
    Matrix<float> taxels(steps, kFingers * kTaxelsPerFinger);
    for (std::size_t line = 1; line < lines_.size() && checked; ++line) {
      const std::size_t step = (line - 1) / kLinesPerStep;
      const std::size_t part = (line - 1) % kLinesPerStep;
      const std::span<float> row = part == 0   ? joints.row(step)
                                   : part == 1 ? pressures.row(step)
                                               : finger(taxels.row(step), part - 2);
      checked = read_line(line, content_of(part), row);
    }
    if (!checked) return fail(std::move(checked.error()));
    return channels(std::move(joints), std::move(pressures), std::move(taxels));
  }

 private:
  static std::span<float> finger(std::span<float> taxels, std::size_t index) {
    return taxels.subspan(index * kTaxelsPerFinger, kTaxelsPerFinger);
  }

  static std::vector<Channel> channels(Matrix<float> joints, Matrix<float> pressures,
                                       Matrix<float> taxels) {
    std::vector<std::string> taxel_names;
    for (const std::string& name : kFingerNames) {
      for (std::size_t i = 1; i <= kTaxelsPerFinger; ++i) {
        taxel_names.push_back(fmt::format("{}_{}", name, i));
      }
    }
    return {{"joints", "deg", kJointNames, std::move(joints), {}},
            {"finger_pressure", "counts", kFingerNames, std::move(pressures), {}},
            {"taxels", "counts", std::move(taxel_names), std::move(taxels), {}}};
  }

  Result<void> check_layout() const {
    if (lines_.empty()) return bad("the file is empty", 0);
    if (fields_of(lines_[0]) != std::vector<std::string_view>{kMarker}) {
      return bad(fmt::format("the first line must be the marker {}", kMarker), 0);
    }
    if (lines_.size() == 1) return bad("the grasp has no time steps", 0);
    const std::size_t left_over = (lines_.size() - 1) % kLinesPerStep;
    if (left_over == 0) return {};
    return bad(fmt::format("the last time step has {} of {} lines", left_over, kLinesPerStep),
               lines_.size() - 1);
  }

  Result<void> read_line(std::size_t line, const LineContent& content, std::span<float> out) const {
    const std::vector<std::string_view> fields = fields_of(lines_[line]);
    if (fields.size() != content.count) {
      return bad(fmt::format("expected {} {}, found {} fields", content.count, content.name,
                             fields.size()),
                 line);
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::optional<float> number = finite_number(fields[i]);
      if (!number) return not_a_number(line, fields[i]);
      out[i] = *number;
    }
    return {};
  }

  Result<void> not_a_number(std::size_t line, std::string_view field) const {
    constexpr std::size_t kLongest = 40;
    const auto column = field.data() - lines_[line].data() + 1;
    return fail(
        ErrorKind::kData,
        fmt::format("{} is not a finite number", to_toml({std::string(field.substr(0, kLongest))})),
        fmt::format("{}:{}:{}", file_, line + 1, column), "repair or remove the file");
  }

  Result<void> bad(std::string what, std::size_t line) const {
    return fail(ErrorKind::kData, std::move(what), fmt::format("{}:{}", file_, line + 1),
                "repair or remove the file");
  }

  std::string file_;
  std::vector<std::string_view> lines_;
};

// OBJECT_TRIAL.txt, the trial a plain whole number.
Result<Trial> trial_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t underscore = stem.rfind('_');
  Trial trial{file, stem.substr(0, underscore), 0};
  if (underscore != std::string::npos && underscore > 0) {
    std::from_chars(stem.data() + underscore + 1, stem.data() + stem.size(), trial.number);
    if (stem == fmt::format("{}_{}", trial.object, trial.number)) return trial;
  }
  return fail(ErrorKind::kData, "the file name is not OBJECT_TRIAL.txt", file.string(),
              "use a name such as ball_3.txt, or remove it from the folder");
}

Result<std::vector<std::filesystem::path>> text_files(const std::filesystem::path& folder) {
  std::error_code failure;
  std::vector<std::filesystem::path> files;
  std::filesystem::directory_iterator entry(folder, failure);
  for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
    if (entry->path().extension() == ".txt") files.push_back(entry->path());
  }
  if (!failure) return files;
  return fail(ErrorKind::kSystem, fmt::format("the folder cannot be read ({})", failure.message()),
              folder.string(), "use the folder of the data set, or its folder 'trials'");
}

Result<std::vector<Trial>> find_trials(const std::filesystem::path& folder) {
  SOMATO_TRY(const auto files, text_files(folder));
  std::vector<Trial> trials;
  for (const std::filesystem::path& file : files) {
    SOMATO_TRY(Trial trial, trial_of(file));
    trials.push_back(std::move(trial));
  }
  std::sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
    return std::tie(a.object, a.number) < std::tie(b.object, b.number);
  });
  if (!trials.empty()) return trials;
  return fail(ErrorKind::kData, "there are no files OBJECT_TRIAL.txt", folder.string(),
              "use the folder of the data set, or its folder 'trials'");
}

Result<Exploration> read_trial(const Trial& trial) {
  return read_whole(trial.file.string())
      .and_then(
          [&](const std::string& text) { return GraspReader(trial.file.string(), text).read(); })
      .map([&](std::vector<Channel> channels) {
        return Exploration{{{"object", trial.object}, {"trial", std::to_string(trial.number)}},
                           trial.file.string(),
                           std::move(channels)};
      });
}

}  // namespace

Result<Recording> import_icub_grasp(const std::filesystem::path& folder) {
  std::error_code unknown;
  const bool has_trials = std::filesystem::is_directory(folder / "trials", unknown);
  SOMATO_TRY(const std::vector<Trial> trials, find_trials(has_trials ? folder / "trials" : folder));
  Recording recording;
  for (const Trial& trial : trials) {
    SOMATO_TRY(Exploration exploration, read_trial(trial));
    recording.explorations.push_back(std::move(exploration));
  }
  return recording;
}

}  // namespace somato
