#include "view/live_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bodies/explorers/recorded_scenes.h"
#include "explore/device.h"
#include "explore/exploring_body.h"
#include "explore/topics.h"
#include "recordings/study_data.h"
#include "somato/recording/recording_file.h"
#include "view/view_systems.h"
#include "views/replay/recorded_explorer.h"

namespace somato::program {
namespace {

constexpr std::size_t kMostExplorations = 1000000;  // months; each has an entry in the plan

tl::unexpected<Error> no_effect(const std::string& flag, const std::string& why,
                                const std::string& advice) {
  return fail(ErrorKind::kUsage, why, "--" + flag, advice);
}

Result<void> check_one_source(const Arguments& arguments) {
  int given = 0;
  for (const char* flag : {"body", "device", "topics", "recording"})
    given += arguments.has(flag) ? 1 : 0;
  if (given == 1) return {};
  return fail(ErrorKind::kUsage,
              "one of a body, a device or topics that explore, or a recording, is required", "live",
              "use --body lucs2, --device FILE, --topics ADDRESS, or --recording FILE");
}

Result<void> check_source_flags(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_one_source(arguments));
  SOMATO_TRY_VOID(check_topic_flags(arguments));
  SOMATO_TRY_VOID(check_unattended(arguments));
  for (const std::string flag : {"object", "explorations", "seed", "output", "every"}) {
    if (!arguments.has(flag) || !arguments.has("recording")) continue;
    return no_effect(flag, "has no effect on a recording", "use it together with --body");
  }
  if (arguments.has("seed") && arguments.has("device")) {
    return no_effect("seed", "has no effect on a device", "omit it");
  }
  const bool shows_objects = !arguments.has("recording") || arguments.has("view");
  if (!arguments.has("objects") || shows_objects) return {};
  return no_effect("objects", "only the view shows the objects of a recording", "add --view");
}

Result<std::vector<PlannedExploration>> planned(const Arguments& arguments,
                                                const Explorer& explorer) {
  SOMATO_TRY(const auto given, arguments.number("explorations", 1));
  const std::size_t each = given.value_or(5);
  std::size_t first = 0;
  std::size_t things = explorer.things().size();
  if (arguments.has("object")) {
    SOMATO_TRY(first, find_thing(explorer, arguments.text("object")));
    things = 1;
  }
  if (each > kMostExplorations / things) {
    return fail(ErrorKind::kUsage,
                fmt::format("a session has at most {} explorations", kMostExplorations),
                "--explorations", "run several sessions");
  }
  std::vector<PlannedExploration> plan;
  plan.reserve(things * each);
  for (std::size_t i = 0; i < things * each; ++i) plan.push_back({first + i / each, i % each});
  return plan;
}

Result<ViewSource> body_source(const Arguments& arguments) {
  SOMATO_TRY(const auto seed, arguments.number("seed", 0));
  const auto permitted = arguments.has("view") ? PermittedBy::kPage : PermittedBy::kTerminal;
  SOMATO_TRY(auto session, body_session(arguments, seed.value_or(1), permitted));
  SOMATO_TRY(auto source, explorer_source(arguments, std::move(session.explorer)));
  source.name = std::move(session.name);
  source.scenes = recorded_scenes(std::move(session.objects));
  return source;
}

// Without a view only the moment that is read is in memory.
Result<ViewSource> streamed_source(const Arguments& arguments, const std::string& path) {
  auto explorer = live::RecordedExplorer::open(path, arguments.has("teach"));
  if (!explorer) return fail(with_place(std::move(explorer.error()), path));
  ViewSource source;
  source.layout = (*explorer)->layout();
  for (std::size_t i = 0; i < (*explorer)->explorations(); ++i) source.plan.push_back({0, i});
  source.explorer = std::move(*explorer);
  source.name = std::filesystem::path(path).filename().string();
  return source;
}

Result<ViewSource> replayed_source(const Arguments& arguments) {
  const std::string path = arguments.text("recording");
  if (!arguments.has("view") && is_mcap_file(path)) return streamed_source(arguments, path);
  ViewSource source;
  SOMATO_TRY(source.recording, read_as_for_model(arguments, path));
  SOMATO_TRY(auto objects, read_objects(arguments));
  source.layout = layout_of(source.recording);
  source.name = std::filesystem::path(path).filename().string();
  source.scenes = recorded_scenes(std::move(objects.objects));
  return source;
}

}  // namespace

Result<ViewSource> explorer_source(const Arguments& arguments, std::unique_ptr<Explorer> explorer) {
  ViewSource source;
  SOMATO_TRY(source.plan, planned(arguments, *explorer));
  source.thing = source.plan.front().thing;
  source.explorer = std::move(explorer);
  return source;
}

Result<ViewSource> live_source(const Arguments& arguments) {
  SOMATO_TRY_VOID(check_source_flags(arguments));
  return arguments.has("recording") ? replayed_source(arguments) : body_source(arguments);
}

}  // namespace somato::program
