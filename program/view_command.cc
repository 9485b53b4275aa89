#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "commands.h"
#include "explore_table.h"
#include "live/address.h"
#include "live/view_server.h"
#include "live/view_session.h"
#include "pages.h"
#include "simulation/recorded_scenes.h"
#include "somato/bodies/object_table.h"
#include "somato/recording/recording_file.h"
#include "somato/simulation/simulated_explorer.h"
#include "study_data.h"
#include "terminal.h"
#include "view_systems.h"
#include "wording.h"

namespace somato::program {
namespace {

constexpr std::uint64_t kSeed = 1;

std::string type_of(std::string_view name) {
  if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  return "text/html; charset=utf-8";
}

Result<std::vector<ViewPage>> view_pages() {
  std::vector<ViewPage> served;
  for (const Page& page : pages()) {
    if (!page.name.starts_with("view.")) continue;
    const std::string path = page.name == "view.html" ? "/" : fmt::format("/{}", page.name);
    served.push_back({path, type_of(page.name), std::string(page.text)});
  }
  if (!served.empty()) return served;
  return fail(ErrorKind::kUsage, "this program was built without its pages", "view",
              "build it where npm is installed");
}

Result<std::size_t> find_thing(const Explorer& explorer, const std::string& name) {
  std::vector<std::string> known;
  for (const ExploredThing& thing : explorer.things()) {
    if (thing.name == name) return known.size();
    known.push_back(thing.name);
  }
  return fail(unknown_name("thing", name, "--object", known));
}

// The viewed body; other choices consist of several bodies.
Result<ExploringBody> read_one_body(const Arguments& arguments) {
  return read_body(arguments).and_then([](ExploringBody body) -> Result<ExploringBody> {
    if (body != ExploringBody::kProbes && body != ExploringBody::kAllSenses) return body;
    return fail(ErrorKind::kUsage, "only one body can be viewed at a time", choice_name(body),
                "use lucs2, lucs3, texture or hardness");
  });
}

Result<ViewSource> body_source(const Arguments& arguments) {
  SOMATO_TRY(const auto body, read_one_body(arguments));
  SOMATO_TRY(const auto things,
             arguments.has("objects")
                 ? read_object_table(arguments.text("objects"), declared_materials())
                 : default_things(body));
  auto explorer = simulated_explorer(body, things, {}, kSeed);
  if (!explorer) return fail(std::move(explorer.error()));
  const auto thing = arguments.has("object") ? find_thing(**explorer, arguments.text("object"))
                                             : Result<std::size_t>(0);
  if (!thing) return fail(thing.error());
  auto systems = systems_for_body(choice_name(body));
  if (!systems) return fail(std::move(systems.error()));
  ViewSource source;
  if (arguments.has("RECORDING")) {
    auto recording = read_study_data(RecordingFormat::kAutomatic, arguments.text("RECORDING"));
    if (!recording) return fail(std::move(recording.error()));
    source.recording = std::move(*recording);
  }
  source.name = choice_name(body);
  source.explorer = std::move(*explorer);
  source.scenes = recorded_scenes(things.objects);
  source.thing = *thing;
  source.systems = std::move(*systems);
  return source;
}

// Objects in addition to the built-in ones.
Result<ObjectTable> read_objects(const Arguments& arguments) {
  if (!arguments.has("objects")) return ObjectTable{};
  return read_object_table(arguments.text("objects"), declared_materials());
}

Result<ViewSource> recording_source(const Arguments& arguments) {
  const std::string path = arguments.text("RECORDING");
  auto recording = read_study_data(RecordingFormat::kAutomatic, path);
  if (!recording) return fail(std::move(recording.error()));
  auto objects = read_objects(arguments);
  if (!objects) return fail(std::move(objects.error()));
  auto systems = systems_for(*recording);
  if (!systems) return fail(std::move(systems.error()));
  ViewSource source;
  source.name = std::filesystem::path(path).filename().string();
  source.recording = std::move(*recording);
  source.scenes = recorded_scenes(std::move(objects->objects));
  source.systems = std::move(*systems);
  return source;
}

Result<void> check_flags(const Arguments& arguments) {
  if (!arguments.has("RECORDING") && !arguments.has("body")) {
    return fail(ErrorKind::kUsage, "a recording or a body that explores is required", "view",
                "somato view FILE.mcap, or somato view --body lucs2 --object boule");
  }
  for (const auto& [flag, problem] :
       {std::pair("object", "the objects of a recording are fixed"),
        std::pair("output", "a recording cannot be recorded again")}) {
    if (!arguments.has(flag) || arguments.has("body")) continue;
    return fail(ErrorKind::kUsage, problem, fmt::format("--{}", flag),
                "use it together with --body");
  }
  return {};
}

// A given system is listed first, and selected.
Result<ViewSource> read_source(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_flags(arguments));
  auto source = arguments.has("body") ? body_source(arguments) : recording_source(arguments);
  if (!source) return source;
  if (arguments.has("model")) {
    SOMATO_TRY(auto model, trained_system(arguments.text("model")));
    source->systems.insert(source->systems.begin(), std::move(model));
  }
  if (!source->systems.empty()) source->system = 0;
  return source;
}

Result<ViewServerSettings> read_server_settings(const Arguments& arguments) {
  ViewServerSettings settings;
  auto port = arguments.number("port", 0);
  if (!port) return fail(std::move(port.error()));
  if (port->value_or(0) > 65535) {
    return fail(ErrorKind::kUsage, "a port must be at most 65535", "--port");
  }
  settings.port = static_cast<std::uint16_t>(port->value_or(0));
  if (!arguments.has("address")) return settings;
  auto address = parse_address(arguments.text("address"));
  if (!address) {
    address.error().where = "--address";
    return fail(std::move(address.error()));
  }
  settings.address = address->text;
  if (address->reach == Address::Reach::kAll) {
    return fail(ErrorKind::kUsage, "the view requires a single address", "--address",
                "use the address of the interface on which other machines connect");
  }
  const bool is_ours = address->reach == Address::Reach::kLoopback;
  if (is_ours || arguments.has("allow-others")) return settings;
  return fail(ErrorKind::kUsage, "other machines can reach this address", "--address",
              "anyone who obtains the start address, which is transmitted without encryption, can "
              "see the view and move the body; use --allow-others to permit it");
}

// The recording of a body's explorations during the view, if it is saved.
class LiveRecording {
 public:
  explicit LiveRecording(std::string path) : path_(std::move(path)) {}

  /// Makes `source` save each exploration; it must not outlive this object.
  Result<void> begin(ViewSource& source) {
    if (path_.empty()) return {};
    SOMATO_TRY(auto file, RecordingFile::begin(path_));
    file_.emplace(std::move(file));
    source.sink = [this](Exploration&& exploration) {
      return file_->add(std::move(exploration)).map([this] { ++explorations_; });
    };
    return {};
  }

  /// Called after the session is stopped. Without an exploration there is no file.
  Result<void> finish() {
    if (!file_) return {};
    if (explorations_ == 0) {
      print_summary(fmt::format("{}: not written, because the body explored nothing\n", path_));
      return {};
    }
    return file_->finish().map([this] {
      print_summary(fmt::format("{}: {}\n", path_, counted(explorations_, "exploration")));
    });
  }

 private:
  std::string path_;
  std::optional<RecordingFile> file_;
  std::size_t explorations_ = 0;
};

void wait_for_interrupt() {
  while (!stop_requested()) ::usleep(50000);
}

Result<void> run_view(const Arguments& arguments) {
  SOMATO_TRY(auto settings, read_server_settings(arguments));
  SOMATO_TRY(auto source, read_source(arguments));
  SOMATO_TRY(auto served, view_pages());
  LiveRecording recording(arguments.text("output"));
  SOMATO_TRY_VOID(recording.begin(source));
  catch_stop_requests();
  ViewSession session(std::move(source));
  session.start();
  SOMATO_TRY(auto server, ViewServer::start(session, std::move(served), settings));
  fmt::print("Open {}\n", server->start_address());
  std::fflush(stdout);
  std::fputs("Press Ctrl-C to close the view.\n", stderr);
  wait_for_interrupt();
  server.reset();
  session.stop();
  auto saved = recording.finish();
  fmt::print("The view is closed.\n");
  return saved;
}

}  // namespace

Command view_command() {
  return {
      "view",
      "View explorations in a browser on this machine",
      {{"RECORDING",
        "The recording to play: its file, or a folder of original files; with --body, the "
        "recording that systems learn from",
        false}},
      {{"--body",
        "Simulated body that explores, instead of a recording: lucs2, lucs3, texture or hardness"},
       {"--object",
        "Name of the object or material to explore first. Default: the first of the table"},
       input_flag("--objects",
                  "TOML file with the objects and materials that the body explores, instead of its "
                  "own table, or that were explored in the recording"),
       output_flag(
           "-o,--output",
           "With --body: file for a recording of the explorations, saved when the view ends"),
       input_flag("--model",
                  "Trained system that evaluates the explorations, saved by 'somato run'"),
       {"--port", "Port of the page. Default: any free port"},
       {"--address", "Numeric IP address to listen on. Default: 127.0.0.1"},
       {"--allow-others",
        "Permit an --address that other machines can reach: anyone who has the start address can "
        "then see everything and move the body, and the address is transmitted without encryption",
        false, false}},
      {},
      run_view};
}

}  // namespace somato::program
