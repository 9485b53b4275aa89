#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "base/files/toml_file.h"
#include "bodies/body/exploration_draft.h"
#include "bodies/hands/hand_picture.h"
#include "explore/device.h"
#include "explore/explore_table.h"
#include "explore/session_recording.h"
#include "explore/topics.h"
#include "flags/commands.h"
#include "flags/left_out.h"
#include "flags/output.h"
#include "flags/output_folder.h"
#include "recordings/file/growing_recording.h"
#include "som/data.h"
#include "somato/bodies/exploring.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/simulated_explorer.h"
#include "somato/simulation/simulation_parameters.h"
#include "terminal/still_elements.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// A flag that would be ignored is a mistake.
Result<void> check_flags(const Arguments& arguments, ExploringBody body) {
  SOMATO_TRY_VOID(check_effect(
      body, given_parameters(arguments, SimulationParameters::declarations().infos())));
  if (!is_probe(body) || !arguments.has("images")) return {};
  return fail(ErrorKind::kUsage, "has no effect on the body " + choice_name(body), "--images",
              "omit it");
}

Result<ExploringParameters> read_parameters(const Arguments& arguments, ExploringBody body) {
  ExploringParameters parameters;
  if (arguments.has("settings")) {
    auto read = read_toml(arguments.text("settings")).and_then([](const Table& file) {
      return read_exploring_parameters(file);
    });
    if (!read) return read;
    parameters = std::move(*read);
  }
  SOMATO_TRY_VOID(check_flags(arguments, body));
  SOMATO_TRY(auto simulation, read_flags<SimulationParameters>(arguments, parameters.simulation));
  parameters.simulation = std::move(simulation);
  return parameters;
}

Result<ObjectTable> read_things(const Arguments& arguments, ExploringBody body) {
  if (!arguments.has("objects")) return default_things(body);
  auto table = read_object_table(arguments.text("objects"), declared_materials());
  if (!table) return table;
  std::vector<std::string> meshes;
  for (const Object& object : table->objects) {
    if (!object.mesh_file.empty()) meshes.push_back(object.mesh_file);
  }
  SOMATO_TRY_VOID(check_not_read(arguments.text("output"), meshes));
  return table;
}

struct Request {
  std::unique_ptr<GraspPictures> pictures;             // or nullptr
  std::unique_ptr<Explorer> real;                      // One of these two.
  std::unique_ptr<const SimulatedExplorer> simulated;  // Ends before its pictures.
  std::size_t each = 5;
  std::size_t threads = 1;
  std::string output;
  std::string image_folder;
  std::size_t longest = 600;  // s of the body's time

  const std::vector<ExploredThing>& things() const {
    return real ? real->things() : simulated->things();
  }
};

// Flags of simulated bodies that a device or topics would ignore.
Result<void> check_real_flags(const Arguments& arguments, const std::string& source) {
  const Table flags = given_parameters(arguments, SimulationParameters::declarations().infos());
  std::vector<std::string> given;
  given.reserve(flags.entries.size());
  for (const Table::Entry& entry : flags.entries) given.push_back(entry.where);
  for (const char* flag : {"body", "seed", "images", "threads"}) {
    if (arguments.has(flag)) given.push_back(fmt::format("--{}", flag));
  }
  if (given.empty()) return {};
  return fail(ErrorKind::kUsage, "has no effect with " + source, given.front(), "omit it");
}

// A device or the topics of a robot.
Result<Request> real_request(const Arguments& arguments, const std::string& source,
                             const std::function<Result<std::unique_ptr<Explorer>>()>& make) {
  SOMATO_TRY_VOID(check_real_flags(arguments, source));
  SOMATO_TRY(auto explorations, arguments.number("explorations", 1));
  SOMATO_TRY(auto longest, arguments.number("longest", 1));
  Request request;
  SOMATO_TRY(request.real, make());
  request.each = explorations.value_or(5);
  request.output = arguments.text("output");
  request.longest = longest.value_or(600);
  return request;
}

Result<Request> read_device_request(const Arguments& arguments) {
  return real_request(arguments, "--device", [&] {
    return device_explorer(arguments, arguments.text("output"), PermittedBy::kTerminal);
  });
}

Result<Request> read_topic_request(const Arguments& arguments) {
  return real_request(arguments, "--topics", [&] {
    return topic_session(arguments).map(
        [](BodySession session) { return std::move(session.explorer); });
  });
}

Result<Request> read_request(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_topic_flags(arguments));
  if (arguments.has("topics")) return read_topic_request(arguments);
  if (arguments.has("device")) return read_device_request(arguments);
  if (!arguments.has("body")) {
    return fail(ErrorKind::kUsage, "a body, a device or topics are required", "explore",
                "add --body lucs2, --device FILE, or --topics ADDRESS");
  }
  SOMATO_TRY(auto body, read_body(arguments));
  SOMATO_TRY(auto things, read_things(arguments, body));
  SOMATO_TRY(auto parameters, read_parameters(arguments, body));
  SOMATO_TRY(auto seed, arguments.number("seed", 0));
  SOMATO_TRY(auto explorations, arguments.number("explorations", 1));
  SOMATO_TRY(auto longest, arguments.number("longest", 1));
  SOMATO_TRY(auto threads, read_threads(arguments));
  Request request;
  request.image_folder = arguments.text("images");
  if (!request.image_folder.empty()) {
    request.pictures = std::make_unique<GraspPictures>(request.image_folder);
  }
  SOMATO_TRY(request.simulated, simulated_explorer(body, things, parameters, seed.value_or(1),
                                                   request.pictures.get()));
  request.each = explorations.value_or(5);
  request.threads = threads;
  request.output = arguments.text("output");
  request.longest = longest.value_or(600);
  return request;
}

// The number of frames per step of a hand's exploration; of a probe, of its only channel.
class FrameSpread {
 public:
  void add(std::size_t frames) {
    least_ = std::min(least_.value_or(frames), frames);
    most_ = std::max(most_, frames);
    sum_ += frames;
    ++count_;
  }

  std::string text() const {
    if (least_ == most_) return counted(most_, "frame") + " each";
    return fmt::format("{} to {} frames each, mean {:.1f}", *least_, most_,
                       static_cast<double>(sum_) / static_cast<double>(count_));
  }

 private:
  std::optional<std::size_t> least_;
  std::size_t most_ = 0;
  std::size_t sum_ = 0;
  std::size_t count_ = 0;
};

// The first failures, one per line; further ones are usually similar.
void report_failures(const Request& request, const ExploringOutcome& outcome) {
  constexpr std::size_t kShown = 10;
  const std::size_t count = outcome.failures.size();
  std::string text;
  for (std::size_t i = 0; i < std::min(count, kShown); ++i) {
    const FailedExploration& failure = outcome.failures[i];
    text += fmt::format("somato: {}, trial {}: {}\n", request.things()[failure.thing].name,
                        failure.trial + 1, to_string(failure.error));
  }
  if (count > kShown) text += fmt::format("somato: and {} more\n", count - kShown);
  std::fputs(text.c_str(), stderr);
}

// Some explorations can succeed if others fail.
Result<void> judge(const Request& request, const ExploringOutcome& outcome) {
  report_failures(request, outcome);
  const GraspPictures* pictures = request.pictures.get();
  if (outcome.failures.empty() && pictures != nullptr && pictures->lost() > 0) {
    Error error = *pictures->first_error();
    error.kind = ErrorKind::kIncomplete;
    error.what = fmt::format("all explorations are recorded, but {} could not be saved: {}",
                             counted(pictures->lost(), "picture"), error.what);
    return fail(std::move(error));
  }
  if (outcome.failures.empty()) return {};
  const std::size_t planned = request.things().size() * request.each;
  const std::size_t failed = outcome.failures.size();
  const std::size_t left = planned - failed - outcome.recorded;
  // After a fault a device ends: not everything was tried.
  const bool has_ended = outcome.failures.back().error.kind == ErrorKind::kUnavailable;
  return fail(
      has_ended ? ErrorKind::kUnavailable : ErrorKind::kIncomplete,
      fmt::format("{} of {} explorations failed and are not recorded{}", failed, planned,
                  left > 0 ? fmt::format("; the other {} were not begun", left) : std::string()),
      request.output);
}

// The readings of a real body are saved while it explores.
ExplorationObserver saving_observer(ExplorationDraft& draft, std::vector<Label> labels) {
  return {[&draft, labels = std::move(labels)](const BodyDescription& body,
                                               const Scene&) -> Result<void> {
            draft.begin(body, labels);
            return {};
          },
          [&draft](const ExplorationStep& step) {
            return step.readings == Readings::kRecorded ? draft.append(step.state) : Result<void>();
          }};
}

Result<Exploration> explore_one(GrowingRecording& file, Explorer& body, ExploreOptions options,
                                std::size_t thing, std::size_t trial) {
  ExplorationDraft draft(file);
  options.observer = saving_observer(draft, body.labels(thing, trial));
  auto explored = body.explore(thing, trial, options);
  if (!explored) SOMATO_TRY_VOID(file.drop_draft());
  return explored;
}

// Explorations of a real body follow each other; only simulated ones are made at the same time.
Result<ExploringOutcome> explore_things(GrowingRecording& file, const Request& request,
                                        const ExplorationSink& sink) {
  const ExploreOptions options{
      .limits = {static_cast<double>(request.longest), [] { return !stop_requested(); }}};
  const Progress progress = terminal_progress("exploring");
  if (request.simulated) {
    return explore_all(*request.simulated, {request.each}, request.threads, options, sink,
                       progress);
  }
  const auto explore = [&](std::size_t thing, std::size_t trial) {
    return explore_one(file, *request.real, options, thing, trial);
  };
  return explore_in_turn(*request.real, {request.each}, explore, sink, progress);
}

// The ranges of all channels, in the order of the first exploration.
class RangesOfChannels {
 public:
  void add(const Exploration& exploration) {
    channels_.resize(exploration.channels.size());
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const Channel& channel = exploration.channels[i];
      channels_[i].name = channel.name;
      channels_[i].element_names = channel.element_names;
      channels_[i].ranges.add(channel);
    }
  }

  // Sensors that never changed or lack readings.
  std::string text() const {
    std::string text;
    for (const Ranges& channel : channels_) {
      text += text_of(still_elements(channel.ranges.elements()), channel.element_names,
                      fmt::format("channel \"{}\": ", channel.name));
    }
    return text;
  }

 private:
  struct Ranges {
    std::string name;
    std::vector<std::string> element_names;
    ElementRanges ranges;
  };
  std::vector<Ranges> channels_;
};

Result<void> explore_into(GrowingRecording& file, const Request& request) {
  FrameSpread spread;
  RangesOfChannels ranges;
  const auto sink = [&](Exploration&& exploration) {
    const std::size_t frames = exploration.channels.front().frames.rows();
    ranges.add(exploration);
    return file.add(std::move(exploration)).map([&] { spread.add(frames); });
  };
  auto outcome = explore_things(file, request, sink);
  const std::size_t recorded = file.count();
  if (recorded == 0 && outcome) {
    report_failures(request, *outcome);
    return fail(ErrorKind::kData, "every exploration failed; no recording was saved",
                request.output);
  }
  if (recorded == 0) return fail(std::move(outcome.error()));
  SOMATO_TRY_VOID(file.finish());
  // A simulated taxel that nothing touches is exactly 0, and not dead.
  const std::string still = request.real ? ranges.text() : std::string();
  print_summary(fmt::format("{}: {} of {}, {}\n{}", request.output,
                            counted(recorded, "exploration"),
                            counted(request.things().size(), "thing"), spread.text(), still));
  if (outcome) return judge(request, *outcome);
  outcome.error().advice = saved_text(file);
  return fail(std::move(outcome.error()));
}

Result<void> run_explore(const Arguments& arguments) {
  SOMATO_TRY(auto request, read_request(arguments));
  OutputFolder images(request.image_folder, "--images");
  if (!request.image_folder.empty()) {
    SOMATO_TRY_VOID(images.make());
  }
  SOMATO_TRY(const auto file, GrowingRecording::begin(request.output));
  return explore_into(*file, request);
}

std::vector<KeySection> key_sections_of_exploring() {
  return {
      {"Settings of exploring",
       "Tables of the file that `somato explore --settings` reads ([exploring](../exploring.md)). "
       "None of these numbers is in the papers, unless a line states so.",
       {key_table<SimulationParameters>("`[simulation]`"), key_table<ExplorationPlan>("`[plan]`"),
        key_table<GuardedGrasp>("`[grasp]`"), key_table<Closing>("`[closing]`"),
        key_table<TextureProbeParameters>("`[texture_probe]`"),
        key_table<StrokeParameters>("`[stroke]`"),
        key_table<HardnessProbeParameters>("`[hardness_probe]`"),
        key_table<PressParameters>("`[press]`")}},
      {"Objects to explore",
       "The tables of the file that `somato explore --objects` reads ([objects](../objects.md)).",
       {key_table<ObjectLine>("`[object]`"), key_table<Material>("`[material.NAME]`")}}};
}

}  // namespace

Command explore_command() {
  Command command{
      "explore",
      "Explore objects or materials with a hand or probe, simulated or real, and record the "
      "sensors",
      {},
      {{"--body",
        "Body that explores: lucs2, lucs3, texture, hardness, probes (both probes), or all_senses "
        "(Hand III with taxels, then both probes)"},
       device_flag(),
       input_flag(
           "--objects",
           "TOML file with the objects and materials to explore. Default: the body's own table"),
       {"--explorations", "Number of explorations of each object or material. Default: 5"},
       {"--seed", "Seed of placement and noise. Default: 1"},
       {"--longest",
        "Maximum duration of an exploration, in seconds of the body's time. Default: 600"},
       input_flag(
           "--settings",
           "TOML file with tables of parameters: simulation, plan, grasp, closing, texture_probe, "
           "stroke, hardness_probe, press"),
       folder_flag("--images", "Folder for pictures of the grasps"),
       threads_flag(),
       output_flag("-o,--output", "File for the recording", true)},
      SimulationParameters::declarations().infos(),
      run_explore,
      {"simulation"},
      key_sections_of_exploring};
  for (Flag& flag : topic_flags()) command.flags.push_back(std::move(flag));
  remove_left_out_flags(command);
  return command;
}

}  // namespace somato::program
