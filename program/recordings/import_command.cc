#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files/toml_file.h"
#include "base/text/number_of_text.h"
#include "base/text/text.h"
#include "flags/commands.h"
#include "recordings/bags/bag_description.h"
#include "recordings/bags/bag_import.h"
#include "recordings/imports/mcap_trials.h"
#include "recordings/imports/wav_trials.h"
#include "recordings/imports/yarp_dumps.h"
#include "somato/recording/csv_import.h"
#include "somato/recording/format.h"
#include "somato/recording/recording_file.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// A recording and an additional message.
struct Imported {
  Recording recording;
  std::string remark;
};

Imported without_remark(Recording recording) {
  return {std::move(recording), {}};
}

std::vector<std::string> formats();

tl::unexpected<Error> misplaced_shape(const std::string& text) {
  return fail(ErrorKind::kUsage, fmt::format("'{}' has brackets where no shape can be", text),
              "--channels", "write the shape behind the name: touch[4x4]:N=t*");
}

// The lengths in "4x4".
Result<std::vector<std::size_t>> shape_in(const std::string& text, const std::string& channel) {
  std::vector<std::size_t> shape;
  for (const std::string& length : split(text, 'x')) {
    const auto value = number_of_text<std::size_t>(length);
    if (!value || *value == 0) {
      return fail(ErrorKind::kUsage, fmt::format("'{}' is not a shape", text), "--channels",
                  fmt::format("write for example {}[4x4], row by row", channel));
    }
    shape.push_back(*value);
  }
  return shape;
}

// Removes the shape from a name such as "touch[4x4]"; without one it is empty.
Result<std::vector<std::size_t>> shape_of_name(std::string& name) {
  const std::size_t bracket = name.find('[');
  if (bracket == std::string::npos) return std::vector<std::size_t>();
  if (!name.ends_with(']')) return misplaced_shape(name);
  const std::string shape = name.substr(bracket + 1, name.size() - bracket - 2);
  name.resize(bracket);
  return shape_in(shape, name);
}

// "touch[4x4]:counts=t00..t33+Fz", where shape and unit are optional.
Result<CsvChannel> channel_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    return fail(ErrorKind::kUsage, fmt::format("'{}' is not a channel", text), "--channels",
                "write for example touch:counts=taxel1..taxel16,force:N=Fx+Fy+Fz");
  }
  const std::string head = text.substr(0, equals);
  const std::size_t colon = std::min(head.find(':'), head.size());
  CsvChannel channel;
  channel.name = head.substr(0, colon);
  channel.unit = head.substr(std::min(colon + 1, head.size()));
  SOMATO_TRY(channel.shape, shape_of_name(channel.name));
  if (channel.unit.find('[') != std::string::npos) return misplaced_shape(text);
  channel.columns = split(text.substr(equals + 1), '+');
  return channel;
}

Result<CsvImport> description_of_flags(const Arguments& arguments) {
  CsvImport description;
  SOMATO_TRY(auto trials, read_flags<CsvTrials>(arguments));
  description.trials = std::move(trials);
  if (!arguments.has("channels")) return description;
  for (const std::string& text : split(arguments.text("channels"), ',')) {
    SOMATO_TRY(auto channel, channel_of(text));
    description.channels.push_back(std::move(channel));
  }
  return description;
}

// The flags that describe files of a format, with `others`.
template <typename Trials>
std::vector<std::string> flags_of(std::vector<std::string> others) {
  for (const ParameterInfo& info : Trials::declarations().infos()) {
    others.push_back(flag_of(info.name));
  }
  return others;
}

std::vector<std::string> csv_flags() {
  return flags_of<CsvTrials>({"--description", "--channels"});
}

std::vector<std::string> bag_flags() {
  return flags_of<BagTrials>({"--description", "--channels", "--labels"});
}

// A given flag that describes files and is not in `known`, if any.
std::string describing_flag(const Arguments& arguments, const std::vector<std::string>& known) {
  std::vector<std::string> names = csv_flags();
  for (const std::string& name : bag_flags()) names.push_back(name);
  const auto given = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return arguments.has(name.substr(2)) &&
           std::find(known.begin(), known.end(), name) == known.end();
  });
  return given == names.end() ? std::string() : *given;
}

// A description in a file and by flags contradict each other.
Result<void> check_flags(const Arguments& arguments, const std::vector<std::string>& known) {
  const std::string foreign = describing_flag(arguments, known);
  if (!foreign.empty()) {
    return fail(
        ErrorKind::kUsage,
        fmt::format("the flag describes files of another format than {}", arguments.text("FORMAT")),
        foreign, "leave out the flag");
  }
  if (!arguments.has("description")) return {};
  const std::string flag = describing_flag(arguments, {"--description"});
  if (flag.empty()) return {};
  return fail(ErrorKind::kUsage, "the files are described by both a flag and --description", flag,
              "leave out the flag, or --description");
}

Result<CsvImport> description_of(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_flags(arguments, csv_flags()));
  if (!arguments.has("description")) return description_of_flags(arguments);
  return read_toml(arguments.text("description")).and_then(read_csv_import);
}

// The numbers of rows and files left out, if any, and warnings, one a line.
std::string lines_of(const CsvImportReport& report) {
  std::string lines;
  if (report.rows_left_out > 0) {
    std::string files;
    if (report.files_left_out > 0) {
      files =
          fmt::format(", with {} shorter than a window", counted(report.files_left_out, "file"));
    }
    lines = fmt::format("left out, because they fill no window: {}{}\n",
                        counted(report.rows_left_out, "row"), files);
  }
  for (const std::string& warning : report.warnings) {
    lines += fmt::format("warning: {}\n", warning);
  }
  return lines;
}

Result<Imported> import_csv(const Arguments& arguments) {
  CsvImportReport report;
  return description_of(arguments)
      .and_then([&](const CsvImport& description) {
        return import_csv_trials(arguments.text("DIR"), description, &report);
      })
      .map([&](Recording recording) { return Imported{std::move(recording), lines_of(report)}; });
}

// Files that define their channels; `import_trials` takes the folder, the pattern and whether to
// pass over other files.
template <typename ImportTrials>
Result<Imported> import_described(const Arguments& arguments, const ImportTrials& import_trials) {
  const std::string flag = describing_flag(arguments, {"--files", "--other-files"});
  if (!flag.empty()) {
    return fail(ErrorKind::kUsage, "the files define their channels", flag,
                "leave out the flag, or import as csv");
  }
  return read_flags<CsvTrials>(arguments)
      .and_then([&](const CsvTrials& trials) {
        return import_trials(arguments.text("DIR"), trials.files,
                             trials.other_files == Unmentioned::kIgnore);
      })
      .map(without_remark);
}

Result<Imported> import_yarp(const Arguments& arguments) {
  const std::string flag = describing_flag(arguments, {"--files", "--other-files"});
  if (!flag.empty()) {
    return fail(ErrorKind::kUsage, "the folders of dumps define the channels", flag,
                "leave out the flag");
  }
  SOMATO_TRY(const CsvTrials trials, read_flags<CsvTrials>(arguments));
  SOMATO_TRY(YarpImport import, import_yarp_dumps(arguments.text("DIR"), trials.files,
                                                  trials.other_files == Unmentioned::kIgnore));
  std::string remark;
  for (const std::string& dump : import.left_out) remark += fmt::format("left out: {}\n", dump);
  return Imported{std::move(import.recording), std::move(remark)};
}

Result<Imported> import_named(const Arguments& arguments) {
  const std::string& name = arguments.text("FORMAT");
  const std::string flag = describing_flag(arguments, {});
  if (!flag.empty()) {
    return fail(ErrorKind::kUsage, fmt::format("the format '{}' needs no description", name), flag,
                "leave out the flag, or import as csv");
  }
  for (const auto& [format, known] : Choices<RecordingFormat>::all()) {
    if (known != name) continue;
    return load_recording(format, arguments.text("DIR")).map(without_remark);
  }
  return fail(unknown_name("format", name, "FORMAT", formats()));
}

std::string summary(const Exploration& first, std::size_t explorations) {
  std::vector<std::string> labels;
  labels.reserve(first.labels.size());
  for (const Label& label : first.labels) labels.push_back(label.name);
  std::vector<std::string> channels;
  channels.reserve(first.channels.size());
  for (const Channel& channel : first.channels) {
    channels.push_back(fmt::format("{} ({}{}{})", channel.name, channel.frames.columns(),
                                   channel.unit.empty() ? "" : " x ", channel.unit));
  }
  return fmt::format("{} explorations; labels: {}; channels: {}", explorations,
                     fmt::join(labels, ", "), fmt::join(channels, ", "));
}

Result<BagImport> bag_description_of(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_flags(arguments, bag_flags()));
  if (arguments.has("description")) {
    return read_toml(arguments.text("description")).and_then(read_bag_import);
  }
  BagImport description;
  SOMATO_TRY(description.trials, read_flags<BagTrials>(arguments));
  if (arguments.has("channels")) {
    SOMATO_TRY(description.channels, parse_bag_channels(arguments.text("channels")));
  }
  if (arguments.has("labels")) {
    for (const std::string& text : split(arguments.text("labels"), ',')) {
      SOMATO_TRY(auto label, parse_bag_label(text));
      description.labels.push_back(std::move(label));
    }
  }
  return description;
}

std::string lines_of(const BagImportReport& report) {
  std::string lines;
  if (report.frames_outside > 0) {
    lines +=
        fmt::format("left out: {} frames outside of the explorations\n", report.frames_outside);
  }
  for (const LeftOutTopic& topic : report.left_out) {
    lines += fmt::format("left out: {} ({}, {}): {}\n", topic.topic, topic.type,
                         counted(topic.messages, "message"), topic.reason);
  }
  for (const std::string& remark : report.remarks) lines += fmt::format("note: {}\n", remark);
  return lines;
}

// Explorations are written as they are read.
Result<void> run_bag_import(const Arguments& arguments) {
  SOMATO_TRY(const BagImport description, bag_description_of(arguments));
  const std::string path = arguments.text("output");
  catch_stop_requests();
  SOMATO_TRY(RecordingFile file, RecordingFile::begin(path));
  SOMATO_TRY(const BagImportReport report, import_bags(arguments.text("DIR"), description, file,
                                                       [] { return !stop_requested(); }));
  SOMATO_TRY_VOID(file.finish());
  print_summary(fmt::format("{}: {}\n{}", path, summary(report.first, report.explorations),
                            lines_of(report)));
  return {};
}

Result<void> write_imported(const Arguments& arguments, Result<Imported> imported) {
  if (!imported) return fail(std::move(imported.error()));
  const std::string path = arguments.text("output");
  SOMATO_TRY_VOID(write_recording(path, imported->recording));
  print_summary(fmt::format(
      "{}: {}\n{}", path,
      summary(imported->recording.explorations.front(), imported->recording.explorations.size()),
      imported->remark));
  return {};
}

// A format that a description completes; data sets need none.
struct DescribedFormat {
  const char* name;
  bool has_patterns;  // It takes --files and --other-files.
  Result<void> (*run)(const Arguments& arguments);
};

constexpr DescribedFormat kDescribed[] = {
    {"csv", false, [](const Arguments& a) { return write_imported(a, import_csv(a)); }},
    {"mcap", true,
     [](const Arguments& a) { return write_imported(a, import_described(a, import_mcap_trials)); }},
    {"bag", false, run_bag_import},
    {"yarp", true, [](const Arguments& a) { return write_imported(a, import_yarp(a)); }},
    {"wav", true,
     [](const Arguments& a) { return write_imported(a, import_described(a, import_wav_trials)); }},
};

std::vector<std::string> formats_with_patterns() {
  std::vector<std::string> names;
  for (const DescribedFormat& format : kDescribed) {
    if (format.has_patterns) names.emplace_back(format.name);
  }
  return names;
}

std::vector<std::string> formats() {
  std::vector<std::string> names;
  names.reserve(Choices<RecordingFormat>::all().size() + std::size(kDescribed));
  for (const auto& [format, name] : Choices<RecordingFormat>::all()) names.push_back(name);
  for (const DescribedFormat& format : kDescribed) names.emplace_back(format.name);
  return names;
}

Result<void> run_import(const Arguments& arguments) {
  for (const DescribedFormat& format : kDescribed) {
    if (arguments.text("FORMAT") == format.name) return format.run(arguments);
  }
  return write_imported(arguments, import_named(arguments));
}

// The parameters of both descriptions; those of the same name mean the same, except for labels.
std::vector<ParameterInfo> import_parameters() {
  std::vector<ParameterInfo> infos = CsvTrials::declarations().infos();
  for (ParameterInfo& info : infos) {
    if (info.name == "labels") {
      info.text += " For bag: labels such as object=cup or object=/topic:field.";
    }
  }
  for (ParameterInfo info : BagTrials::declarations().infos()) {
    const bool is_known = std::any_of(infos.begin(), infos.end(), [&](const ParameterInfo& other) {
      return other.name == info.name;
    });
    info.text = "For bag: " + info.text;
    if (!is_known) infos.push_back(std::move(info));
  }
  return infos;
}

std::vector<KeySection> key_sections_of_imports() {
  return {
      {"Descriptions of CSV files",
       "The import of CSV files as a recording ([your data](../your-data.md)): a table "
       "`[import]`, and a table `[[channel]]` for each channel.",
       {key_table<CsvTrials>("`[import]`"), key_table<CsvChannel>("`[[channel]]`")}},
      {"Descriptions of bags",
       "The import of bags of ROS 2 as a recording ([your robot](../your-robot.md)): a table "
       "`[import]`, a table `[[channel]]` for each channel and a table `[[label]]` for each "
       "label.",
       {key_table<BagTrials>("`[import]` of bags"), key_table<BagChannel>("`[[channel]]` of bags"),
        key_table<BagLabel>("`[[label]]` of bags")}}};
}

}  // namespace

Command import_command() {
  return {
      "import",
      "Import a folder of recorded files as a recording",
      {{"FORMAT",
        fmt::format("Format of the files: {}; {} take the flags --files and --other-files",
                    fmt::join(formats(), ", "), fmt::join(formats_with_patterns(), ", ")),
        true, false, Role::kValue, formats},
       {"DIR", "Folder with the files, also in subfolders; for csv and bag also a single file",
        true}},
      {output_flag("-o,--output", "File for the recording", true),
       input_flag("--description",
                  "For csv and bag: TOML file with the tables [import] and [[channel]] (and "
                  "[[label]] for bag), instead of the flags below"),
       {"--channels",
        "For csv: the channels with their units and columns, such as "
        "touch:counts=taxel1..taxel16,force:N=Fx+Fy+Fz or 'touch[4x4]=t*', where the columns "
        "are the rows of 4 by 4 elements. For bag: with their "
        "topics and fields, such as 'touch:counts=/xServTopic:sensors[*].taxels[*].z' or "
        "'arm:rad=/joint_states:position[shoulder,elbow]'; without it the channels of all known "
        "types"}},
      import_parameters(),
      run_import,
      {"import"},
      key_sections_of_imports};
}

}  // namespace somato::program
