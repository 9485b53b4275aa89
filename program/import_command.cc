#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "commands.h"
#include "somato/files/toml_file.h"
#include "somato/recording/csv_trials.h"
#include "somato/recording/format.h"
#include "somato/recording/recording_file.h"

namespace somato::program {
namespace {

constexpr const char* kCsv = "csv";

std::vector<std::string> formats() {
  std::vector<std::string> names;
  names.reserve(Choices<RecordingFormat>::all().size() + 1);
  for (const auto& [format, name] : Choices<RecordingFormat>::all()) names.push_back(name);
  names.emplace_back(kCsv);
  return names;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos;
       end = text.find(separator)) {
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.emplace_back(text);
  return parts;
}

// "touch:counts=taxel1..taxel16+Fz", the unit perhaps left out.
Result<CsvChannel> channel_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    return fail(ErrorKind::kUsage, fmt::format("'{}' is no channel", text), "--channels",
                "write such as touch:counts=taxel1..taxel16,force:N=Fx+Fy+Fz");
  }
  const std::string head = text.substr(0, equals);
  const std::size_t colon = std::min(head.find(':'), head.size());
  CsvChannel channel;
  channel.name = head.substr(0, colon);
  channel.unit = head.substr(std::min(colon + 1, head.size()));
  channel.columns = split(text.substr(equals + 1), '+');
  return channel;
}

Result<CsvImport> description_of_flags(const Arguments& arguments) {
  CsvImport description;
  auto trials = read_flags<CsvTrials>(arguments);
  if (!trials) return fail(std::move(trials.error()));
  description.trials = std::move(*trials);
  if (!arguments.has("channels")) return description;
  for (const std::string& text : split(arguments.text("channels"), ',')) {
    auto channel = channel_of(text);
    if (!channel) return fail(std::move(channel.error()));
    description.channels.push_back(std::move(*channel));
  }
  return description;
}

// A flag that describes CSV files, if any was given.
std::string describing_flag(const Arguments& arguments) {
  std::vector<std::string> names{"--channels"};
  for (const ParameterInfo& info : CsvTrials::declarations().infos())
    names.push_back(flag_of(info.name));
  const auto given = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return arguments.has(name.substr(2));
  });
  return given == names.end() ? std::string() : *given;
}

Result<Recording> import_csv(const Arguments& arguments) {
  const std::string flag = describing_flag(arguments);
  if (!arguments.has("description")) {
    return description_of_flags(arguments).and_then([&](const CsvImport& description) {
      return import_csv_trials(arguments.text("DIR"), description);
    });
  }
  if (!flag.empty()) {
    return fail(ErrorKind::kUsage, "the files are described twice", flag,
                "leave out the flag, or --description");
  }
  return read_toml(arguments.text("description"))
      .and_then(read_csv_import)
      .and_then([&](const CsvImport& description) {
        return import_csv_trials(arguments.text("DIR"), description);
      });
}

Result<Recording> import_named(const Arguments& arguments) {
  const std::string& name = arguments.text("FORMAT");
  const std::string flag =
      arguments.has("description") ? "--description" : describing_flag(arguments);
  if (!flag.empty()) {
    return fail(ErrorKind::kUsage, fmt::format("the format '{}' is known", name), flag,
                "leave out the flag, or import as csv");
  }
  for (const auto& [format, known] : Choices<RecordingFormat>::all()) {
    if (known == name) return load_recording(format, arguments.text("DIR"));
  }
  return fail(unknown_name("format", name, "FORMAT", formats()));
}

std::string summary(const Recording& recording) {
  const Exploration& first = recording.explorations.front();
  std::vector<std::string> labels;
  labels.reserve(first.labels.size());
  for (const Label& label : first.labels) labels.push_back(label.name);
  std::vector<std::string> channels;
  channels.reserve(first.channels.size());
  for (const Channel& channel : first.channels) {
    channels.push_back(fmt::format("{} ({}{}{})", channel.name, channel.frames.columns(),
                                   channel.unit.empty() ? "" : " x ", channel.unit));
  }
  return fmt::format("{} explorations; labels: {}; channels: {}", recording.explorations.size(),
                     fmt::join(labels, ", "), fmt::join(channels, ", "));
}

Result<void> run_import(const Arguments& arguments) {
  const auto recording =
      arguments.text("FORMAT") == kCsv ? import_csv(arguments) : import_named(arguments);
  if (!recording) return fail(recording.error());
  const std::string path = arguments.text("output");
  if (auto saved = write_recording(path, *recording); !saved) return saved;
  fmt::print("{}: {}\n", path, summary(*recording));
  return {};
}

}  // namespace

Command import_command() {
  return {"import",
          "Make a recording of a folder of recorded files",
          {{"FORMAT", fmt::format("What the files are: {}", fmt::join(formats(), ", ")), true,
            false, Role::kValue},
           {"DIR", "Folder with the files, in it or below", true}},
          {output_flag("-o,--output", "File for the recording", true),
           input_flag(
               "--description",
               "For csv: TOML file with the tables [import] and [[channel]], instead of the flags "
               "below"),
           {"--channels",
            "For csv: the channels with their units and columns, such as "
            "touch:counts=taxel1..taxel16,force:N=Fx+Fy+Fz"}},
          CsvTrials::declarations().infos(),
          run_import,
          "import"};
}

}  // namespace somato::program
