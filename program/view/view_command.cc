#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bodies/explorers/recorded_scenes.h"
#include "explore/device.h"
#include "explore/exploring_body.h"
#include "explore/session_recording.h"
#include "explore/topics.h"
#include "flags/commands.h"
#include "recordings/layout_flag.h"
#include "recordings/study_data.h"
#include "terminal/terminal.h"
#include "view/browser.h"
#include "view/planned_names.h"
#include "view/view_layout.h"
#include "view/view_preparation.h"
#include "view/view_rendering.h"
#include "view/view_serving.h"
#include "view/view_systems.h"
#include "views/live/view_server.h"
#include "views/live/view_session.h"

namespace somato::program {
namespace {

constexpr std::uint64_t kSeed = 1;

std::vector<std::string> recordings_in(const Arguments& arguments) {
  const auto given = arguments.lists.find("RECORDING");
  return given != arguments.lists.end() ? given->second : std::vector<std::string>();
}

std::string name_in(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// One after the other; all must have the same channels.
Result<void> read_recordings(const Arguments& arguments, ViewSource& source) {
  const std::vector<std::string> paths = recordings_in(arguments);
  auto& all = source.recording.explorations;
  for (const std::string& path : paths) {
    SOMATO_TRY(auto recording, read_as_for_model(arguments, path));
    if (!all.empty()) {
      auto alike = check_alike(recording.explorations.front(), all.front());
      if (!alike) return fail(with_place(std::move(alike.error()), path));
    }
    std::move(recording.explorations.begin(), recording.explorations.end(),
              std::back_inserter(all));
    if (paths.size() > 1) source.origins.resize(all.size(), name_in(path));
  }
  return {};
}

Result<ViewSource> viewed_body_source(const Arguments& arguments) {
  SOMATO_TRY(auto session, body_session(arguments, kSeed, PermittedBy::kPage));
  SOMATO_TRY(const auto thing, arguments.has("object")
                                   ? find_thing(*session.explorer, arguments.text("object"))
                                   : Result<std::size_t>(0));
  SOMATO_TRY(auto systems, session.channels.empty()
                               ? systems_for_body(session.body)
                               : systems_for_channels(session.channels, {"object"}));
  ViewSource source;
  SOMATO_TRY_VOID(read_recordings(arguments, source));
  source.name = std::move(session.name);
  source.explorer = std::move(session.explorer);
  source.scenes = recorded_scenes(std::move(session.objects));
  source.thing = thing;
  source.systems = std::move(systems);
  if (arguments.has("demo")) plan_demonstration(session.body, source);
  if (!recordings_in(arguments).empty() || arguments.has("model")) return source;
  SOMATO_TRY_VOID(prepare_system(arguments, session.body, source));
  return source;
}

Result<ViewSource> recording_source(const Arguments& arguments) {
  const std::vector<std::string> paths = recordings_in(arguments);
  ViewSource source;
  SOMATO_TRY_VOID(read_recordings(arguments, source));
  SOMATO_TRY(auto objects, read_objects(arguments));
  SOMATO_TRY(auto systems, systems_for(source.recording));
  source.name =
      paths.size() == 1 ? name_in(paths.front()) : fmt::format("{} recordings", paths.size());
  source.scenes = recorded_scenes(std::move(objects.objects));
  source.systems = std::move(systems);
  return source;
}

bool has_body(const Arguments& arguments) {
  return arguments.has("body") || arguments.has("device") || arguments.has("topics");
}

// The flags that have no effect on a demonstration.
Result<void> check_demonstration(const Arguments& arguments) {
  if (!arguments.has("demo")) return {};
  const auto misused = [](const std::string& what) {
    return fail(ErrorKind::kUsage, "a demonstration explores all objects of a simulated body", what,
                "omit it, or --demo");
  };
  const std::vector<std::string> recordings = recordings_in(arguments);
  if (!recordings.empty()) return misused(recordings.front());
  for (const std::string other : {"device", "topics", "object"}) {
    if (arguments.has(other)) return misused("--" + other);
  }
  return {};
}

Result<void> check_view_flags(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_demonstration(arguments));
  SOMATO_TRY_VOID(check_rendering(arguments));
  const bool explores = has_body(arguments);
  if (recordings_in(arguments).empty() && !explores) {
    return fail(ErrorKind::kUsage, "a recording or a body that explores is required", "view",
                "somato view --demo, somato view FILE.mcap, or somato view --body lucs2");
  }
  for (const auto& [flag, problem] :
       {std::pair("object", "the objects of a recording are fixed"),
        std::pair("output", "a recording cannot be recorded again")}) {
    if (!arguments.has(flag) || explores) continue;
    return fail(ErrorKind::kUsage, problem, fmt::format("--{}", flag),
                "use it together with --body, --device or --topics");
  }
  return check_topic_flags(arguments);
}

// A given system is listed first, and selected.
Result<ViewSource> read_source(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_view_flags(arguments));
  auto source = has_body(arguments) ? viewed_body_source(arguments) : recording_source(arguments);
  if (!source) return source;
  SOMATO_TRY_VOID(add_layout(arguments, *source));
  if (arguments.has("model")) {
    SOMATO_TRY(auto model, trained_system(arguments.text("model")));
    source->systems.insert(source->systems.begin(), std::move(model));
    source->system = 0;
  }
  if (!source->system && !source->systems.empty()) source->system = 0;
  SOMATO_TRY_VOID(plan_names(arguments, *source));
  return source;
}

// A demonstration has a body, if none is named.
Arguments with_body(Arguments arguments) {
  if (arguments.has("demo") && !arguments.has("body")) arguments.texts["body"] = "lucs2";
  return arguments;
}

Result<ViewSettings> settings_of(const Arguments& arguments) {
  ViewSettings settings;
  SOMATO_TRY(settings.memory, read_page_memory(arguments));
  if (arguments.has("demo")) settings.speed = demonstration_speed(arguments.text("body"));
  return settings;
}

// A browser that cannot be started is no reason to end.
std::optional<BrowserStart> start_browser(const Arguments& arguments, const std::string& address) {
  if (!arguments.has("open")) return {};
  auto browser = BrowserStart::open(address);
  if (browser) return std::move(*browser);
  std::fputs(fmt::format("somato: {}\n", to_string(browser.error())).c_str(), stderr);
  return {};
}

void wait_for_interrupt() {
  while (!stop_requested()) ::usleep(50000);
}

Result<void> run_view(const Arguments& given) {
  const Arguments arguments = with_body(given);
  SOMATO_TRY(auto settings, read_server_settings(arguments));
  SOMATO_TRY(const auto view, settings_of(arguments));
  SOMATO_TRY(const auto rollover, read_rollover(arguments));
  SOMATO_TRY(auto source, read_source(arguments));
  if (arguments.has("render")) return render_view(arguments, std::move(source));
  SOMATO_TRY(auto served, view_pages());
  SessionRecording recording(arguments.text("output"), rollover);
  SOMATO_TRY_VOID(recording.begin());
  source.file = recording.file();
  catch_stop_requests();
  ViewSession session(std::move(source), view);
  session.start();
  SOMATO_TRY(auto server, ViewServer::start(session, std::move(served), settings));
  fmt::print("Open {}\n", server->start_address());
  std::fflush(stdout);
  const auto browser = start_browser(arguments, server->start_address());
  std::fputs("Press Ctrl-C to close the view.\n", stderr);
  wait_for_interrupt();
  server.reset();
  session.stop();
  const auto saved = recording.finish();
  print_summary(saved.value_or(""));
  print_summary(losses_text(session.losses()));
  fmt::print("The view is closed.\n");
  return saved ? Result<void>() : fail(saved.error());
}

}  // namespace

Command view_command() {
  Command command{
      "view",
      "View explorations in a browser on this machine",
      {{"RECORDING",
        "The recordings to play, one after the other: their files, or folders of original files; "
        "with --body or --device, the recordings that systems learn from",
        false, true}},
      {{"--body",
        "Simulated body that explores, instead of a recording: lucs2, lucs3, texture or hardness"},
       device_flag(),
       {"--demo",
        "Show a trained system while a simulated hand explores all objects in turn, in a loop; "
        "--body selects another body than lucs2",
        false, false},
       {"--open", "Open the page in a browser, with xdg-open", false, false},
       {"--object",
        "Name of the object or material to explore first. Default: the first of the table"},
       input_flag("--objects",
                  "TOML file with the objects and materials that the body explores, instead of its "
                  "own table, or that were explored in the recording"),
       output_flag("-o,--output",
                   "With --body, --device or --topics: file for a recording of the explorations"),
       every_flag(),
       input_flag("--model",
                  "Trained system that evaluates the explorations, saved by 'somato run'"),
       layout_flag("with which the page draws a skin"),
       page_memory_flag()},
      {},
      run_view};
  for (Flag& flag : rendering_flags()) command.flags.push_back(std::move(flag));
  for (Flag& flag : planned_name_flags()) command.flags.push_back(std::move(flag));
  for (Flag& flag : topic_flags()) command.flags.push_back(std::move(flag));
  for (Flag& flag : server_flags()) command.flags.push_back(std::move(flag));
  return command;
}

}  // namespace somato::program
