#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "explore/device.h"
#include "explore/session_recording.h"
#include "explore/topics.h"
#include "flags/commands.h"
#include "flags/left_out.h"
#include "recordings/layout_flag.h"
#include "study/system_fit.h"
#include "terminal/real_time.h"
#include "terminal/service_watch.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"
#include "view/live_source.h"
#include "view/planned_names.h"
#include "view/reading_session.h"
#include "view/view_layout.h"
#include "view/view_serving.h"
#include "view/view_systems.h"
#include "views/live/view_session.h"
#include "views/session/system_reading.h"

namespace somato::program {
namespace {

// Standard output is only for readings.
void print_note(const std::string& text) {
  if (isatty(STDERR_FILENO) == 1 && !is_quiet()) std::fputs(text.c_str(), stderr);
}

Result<void> check_output_flags(const Arguments& arguments) {
  for (const std::string flag : {"port", "address", "allow-others", "names", "each", "layout"}) {
    if (!arguments.has(flag) || arguments.has("view")) continue;
    return fail(ErrorKind::kUsage, "has no effect without the view", "--" + flag, "add --view");
  }
  for (const std::string flag : {"output", "teach"}) {
    if (arguments.text(flag) != "/dev/stdout") continue;
    return fail(ErrorKind::kUsage, "standard output is for the readings", "--" + flag,
                "name a file");
  }
  return {};
}

Result<double> read_speed(const Arguments& arguments) {
  double speed = 1.0;
  const bool is_real = arguments.has("device") || arguments.has("topics");
  if (is_real && arguments.has("speed")) {
    return fail(ErrorKind::kUsage, "a device and topics have their own speed", "--speed",
                "omit it");
  }
  if (is_real) return kFastest;  // Nothing waits for the pace of a picture.
  if (!arguments.has("speed")) return speed;
  const std::string text = arguments.text("speed");
  if (text == "max") return kFastest;
  ParameterInfo info;
  info.name = "speed";
  info.type = "number";
  info.range = Range::between(0.05, 100);
  auto read = detail::Field<double>::read(info, value_from_text(info, text), speed);
  if (read) return speed;
  read.error().where = "--speed";
  read.error().advice = "use max, or a factor between 0.05 and 100";
  return fail(std::move(read.error()));
}

// Locked from the beginning: what is read of the model stays in memory.
Result<void> begin_real_time(const Arguments& arguments) {
  if (!arguments.has("realtime")) return {};
  if (arguments.has("device")) return prepare_real_time();
  return fail(ErrorKind::kUsage, "has no effect without a device", "--realtime",
              "omit it, or use it together with --device FILE");
}

Result<ViewSystem> read_model(const std::string& path) {
  SOMATO_TRY(auto system, trained_system(path));
  auto reading = live::SystemReading::build(system.trained);
  if (reading) return system;
  reading.error().where = path;
  return fail(std::move(reading.error()));
}

Result<void> save_taught(const Arguments& arguments, const ReadingSession& readings,
                         const ViewSession& session) {
  if (!arguments.has("teach")) return {};
  const std::string path = arguments.text("teach");
  if (readings.taught() == 0) {
    print_note(fmt::format("{}: not written, because no name was learned\n", path));
    return {};
  }
  const auto model = session.system();
  SOMATO_TRY_VOID(save_system(path, *model));
  print_note(
      fmt::format("{}: the system with {}\n", path, counted(readings.taught(), "further name")));
  return {};
}

// The system is the only one, so that the view shows what is written.
Result<ViewSource> read_live_source(const Arguments& arguments) {
  SOMATO_TRY(auto system, read_model(arguments.text("model")));
  SOMATO_TRY(auto source, live_source(arguments));
  SOMATO_TRY_VOID(add_layout(arguments, source));
  if (source.layout) {
    SOMATO_TRY_VOID(check_fit(system.trained->system, *source.layout, arguments.text("recording")));
  }
  source.systems.push_back(std::move(system));
  source.system = 0;
  SOMATO_TRY_VOID(plan_names(arguments, source));
  return source;
}

// The pages and the server of --view.
struct ViewRequest {
  std::vector<ViewPage> pages;
  ViewServerSettings server;
};

Result<std::optional<ViewRequest>> read_view(const Arguments& arguments) {
  std::optional<ViewRequest> request;
  if (!arguments.has("view")) return request;
  SOMATO_TRY(auto settings, read_server_settings(arguments));
  SOMATO_TRY(auto served, view_pages());
  request = ViewRequest{std::move(served), std::move(settings)};
  return request;
}

Result<std::unique_ptr<ViewServer>> serve_view(ViewSession& session,
                                               std::optional<ViewRequest> request) {
  if (!request) return std::unique_ptr<ViewServer>();
  return ViewServer::start(session, std::move(request->pages), request->server);
}

void print_start(const ViewServer* server) {
  if (server == nullptr) return print_note("Press Ctrl-C to end.\n");
  std::fputs(fmt::format("Open {}\nPress Ctrl-C to end.\n", server->start_address()).c_str(),
             stderr);
}

Error with_saved(Error error, SessionRecording& recording) {
  if (error.kind == ErrorKind::kInterrupted && recording.explorations() > 0) {
    error.advice = saved_text(*recording.file());
  }
  return error;
}

Result<void> run_live(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_output_flags(arguments));
  SOMATO_TRY(const auto speed, read_speed(arguments));
  SOMATO_TRY(const auto rollover, read_rollover(arguments));
  SOMATO_TRY(const auto memory, read_page_memory(arguments));
  SOMATO_TRY(auto view, read_view(arguments));
  SOMATO_TRY(auto manager, ServiceManager::from_environment());
  SOMATO_TRY_VOID(begin_real_time(arguments));
  SOMATO_TRY(auto source, read_live_source(arguments));
  const bool is_viewed = view.has_value();
  ReadingSession readings(source.systems.front().trained, source.name);
  source.teaches = arguments.has("teach");
  if (source.teaches) readings.take_names(!is_viewed);  // a page must not wait
  source.readings = readings.sink();
  SessionRecording recording(arguments.text("output"), rollover);
  SOMATO_TRY_VOID(recording.begin());
  source.file = recording.file();
  catch_stop_requests();
  ViewSettings settings{
      .wait_for_viewer = is_viewed, .speed = speed, .has_page = is_viewed, .memory = memory};
  if (arguments.has("realtime")) settings.on_thread = take_real_time_priority;
  ViewSession session(std::move(source), settings);
  SOMATO_TRY(auto server, serve_view(session, std::move(view)));
  ServiceWatch watch(std::move(manager), [&](auto task) { return session.post(std::move(task)); });
  session.start();
  print_start(server.get());
  SOMATO_TRY_VOID(watch.begin());
  readings.wait(is_viewed, [&] { watch.look(ServiceWatch::Clock::now()); });
  watch.end();
  server.reset();
  session.stop();
  const auto saved = recording.finish();
  if (!is_quiet()) std::fputs(losses_text(session.losses()).c_str(), stderr);
  SOMATO_TRY_VOID(save_taught(arguments, readings, session));
  if (!saved) return fail(saved.error());
  print_note(*saved);
  auto outcome = readings.outcome();
  if (outcome) return outcome;
  return fail(with_saved(std::move(outcome.error()), recording));
}

}  // namespace

Command live_command() {
  Command command{
      "live",
      "Read explorations with a trained system in real time, one line of JSON after each frame",
      {},
      {input_flag("--model", "Trained system, saved by 'somato run'", true),
       {"--body", "Simulated body that explores: lucs2, lucs3, texture or hardness"},
       device_flag(),
       unattended_flag(),
       input_flag("--recording",
                  "Recording to replay instead: its file, or a folder of original files"),
       input_flag("--objects",
                  "TOML file with the objects and materials that the body explores, instead of its "
                  "own table; with --recording and --view, that were explored"),
       {"--object", "Name of the only object or material to explore. Default: all of the table"},
       {"--explorations", "Number of explorations of each object or material. Default: 5"},
       {"--seed", "With --body: seed of placement and noise. Default: 1"},
       output_flag("-o,--output", "File for a recording of the explorations"),
       every_flag(),
       output_flag(
           "--teach",
           "Learn names from standard input, one line for an exploration, and save the "
           "system to this file at the end; after an unknown exploration a name is awaited"),
       {"--speed",
        "Factor of the original speed, 0.05 to 100, or max: without waiting. Default: 1"},
       {"--realtime",
        "With --device: lock the memory, and give the threads that read and compute a real-time "
        "priority (SCHED_FIFO, 40). An error where that is not permitted",
        false, false},
       {"--view",
        "Show the explorations in a browser at the same time, like 'somato view'; they begin with "
        "the first viewer, or with --device after a press of Start, and the view stays open until "
        "Ctrl-C",
        false, false},
       layout_flag("with which the page draws a skin"),
       page_memory_flag()},
      {},
      run_live};
  for (Flag& flag : planned_name_flags()) command.flags.push_back(std::move(flag));
  for (Flag& flag : topic_flags()) command.flags.push_back(std::move(flag));
  for (Flag& flag : server_flags()) command.flags.push_back(std::move(flag));
  remove_left_out_flags(command);
  return command;
}

}  // namespace somato::program
