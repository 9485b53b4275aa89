#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <utility>

#include "commands.h"
#include "explore_table.h"
#include "pages.h"
#include "somato/bodies/object_table.h"
#include "somato/live/address.h"
#include "somato/live/view_server.h"
#include "somato/live/view_session.h"
#include "somato/simulation/recorded_scenes.h"
#include "somato/simulation/watched_explorer.h"
#include "study_data.h"
#include "terminal.h"
#include "view_systems.h"

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

Result<std::size_t> find_thing(const WatchedBody& body, const std::string& name) {
  std::vector<std::string> known;
  for (const ShownThing& thing : body.things()) {
    if (thing.name == name) return known.size();
    known.push_back(thing.name);
  }
  return fail(unknown_name("thing", name, "--object", known));
}

Result<ViewSource> body_source(const Arguments& arguments) {
  const auto body = read_body(arguments);
  if (!body) return fail(body.error());
  const auto things = arguments.has("objects")
                          ? read_object_table(arguments.text("objects"), declared_materials())
                          : default_things(*body);
  if (!things) return fail(things.error());
  auto watched = watch_body(*body, *things, {}, kSeed);
  if (!watched) return fail(std::move(watched.error()));
  const auto thing = arguments.has("object") ? find_thing(**watched, arguments.text("object"))
                                             : Result<std::size_t>(0);
  if (!thing) return fail(thing.error());
  auto systems = systems_for_body((*watched)->name());
  if (!systems) return fail(std::move(systems.error()));
  ViewSource source;
  if (arguments.has("RECORDING")) {
    auto recording = read_study_data(RecordingFormat::kAutomatic, arguments.text("RECORDING"));
    if (!recording) return fail(std::move(recording.error()));
    source.recording = std::move(*recording);
  }
  source.name = (*watched)->name();
  source.body = std::move(*watched);
  source.scenes = recorded_scenes(things->objects);
  source.thing = *thing;
  source.systems = std::move(*systems);
  return source;
}

// Those beside the program's own.
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
    return fail(ErrorKind::kUsage, "name a recording to play, or a body that explores", "view",
                "somato view FILE.mcap, or somato view --body lucs2 --object boule");
  }
  if (!arguments.has("object") || arguments.has("body")) return {};
  return fail(ErrorKind::kUsage, "a recording holds what it holds", "--object",
              "give it with --body");
}

// The given system comes first, and is chosen.
Result<ViewSource> read_source(const Arguments& arguments) {
  if (auto fits = check_flags(arguments); !fits) return fail(std::move(fits.error()));
  auto source = arguments.has("body") ? body_source(arguments) : recording_source(arguments);
  if (!source) return source;
  if (arguments.has("model")) {
    auto model = trained_system(arguments.text("model"));
    if (!model) return fail(std::move(model.error()));
    source->systems.insert(source->systems.begin(), std::move(*model));
  }
  if (!source->systems.empty()) source->system = 0;
  return source;
}

Result<ViewServerSettings> read_server_settings(const Arguments& arguments) {
  ViewServerSettings settings;
  auto port = arguments.number("port", 0);
  if (!port) return fail(std::move(port.error()));
  if (port->value_or(0) > 65535) {
    return fail(ErrorKind::kUsage, "a port is at most 65535", "--port");
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
    return fail(ErrorKind::kUsage, "the view answers to one address alone", "--address",
                "give that of the interface that others come by");
  }
  const bool is_ours = address->reach == Address::Reach::kLoopback;
  if (is_ours || arguments.has("allow-others")) return settings;
  return fail(ErrorKind::kUsage, "others could reach this address", "--address",
              "whoever learns the start address, which goes through the network unprotected, could "
              "then see all and move the body; say --allow-others if that is wanted");
}

void wait_for_interrupt() {
  while (!stop_requested()) ::usleep(50000);
}

Result<void> run_view(const Arguments& arguments) {
  auto settings = read_server_settings(arguments);
  if (!settings) return fail(std::move(settings.error()));
  auto source = read_source(arguments);
  if (!source) return fail(std::move(source.error()));
  auto served = view_pages();
  if (!served) return fail(std::move(served.error()));
  catch_stop_requests();
  ViewSession session(std::move(*source));
  session.start();
  auto server = ViewServer::start(session, std::move(*served), *settings);
  if (!server) return fail(std::move(server.error()));
  fmt::print("Open {}\n", (*server)->start_address());
  std::fflush(stdout);
  std::fputs("Ctrl-C ends the view.\n", stderr);
  wait_for_interrupt();
  fmt::print("The view is closed.\n");
  return {};
}

}  // namespace

Command view_command() {
  return {
      "view",
      "Look at explorations in a browser of this machine",
      {{"RECORDING",
        "The recording to play: its file, or a folder of original files; with --body, what "
        "systems learn from",
        false}},
      {{"--body",
        "Instead of a recording, a simulated body that explores: lucs2, lucs3, texture or "
        "hardness"},
       {"--object",
        "What the body explores first, by its name; the first of its table unless given"},
       input_flag(
           "--objects",
           "TOML file with the things that a body explores, instead of its own table, or that a "
           "recording's hand explored"),
       input_flag("--model", "A trained system that reads along, saved by 'somato run'"),
       {"--port", "Port of the page; any that is free unless given"},
       {"--address", "Address to be reached at, in digits; 127.0.0.1 unless given"},
       {"--allow-others",
        "Allows an --address that other machines reach: anyone who has the start address can then "
        "see everything and move the body, and the address is sent through the network unprotected",
        false, false}},
      {},
      run_view};
}

}  // namespace somato::program
