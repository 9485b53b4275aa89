#include "explore/exploring_body.h"

#include <utility>
#include <vector>

#include "explore/explore_table.h"
#include "explore/topics.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato::program {
namespace {

// Other choices consist of several bodies.
Result<ExploringBody> read_one_body(const Arguments& arguments) {
  return read_body(arguments).and_then([](ExploringBody body) -> Result<ExploringBody> {
    if (body != ExploringBody::kProbes && body != ExploringBody::kAllSenses) return body;
    return fail(ErrorKind::kUsage, "only one body can explore in a session", choice_name(body),
                "use lucs2, lucs3, texture or hardness");
  });
}

// The body of --body, and its things.
struct ChosenBody {
  ExploringBody body;
  ObjectTable things;
};

Result<ChosenBody> chosen_body(const Arguments& arguments) {
  SOMATO_TRY(const auto body, read_one_body(arguments));
  SOMATO_TRY(auto things,
             arguments.has("objects") ? read_objects(arguments) : default_things(body));
  return ChosenBody{body, std::move(things)};
}

Result<BodySession> simulated_session(const Arguments& arguments, std::uint64_t seed) {
  SOMATO_TRY(auto chosen, chosen_body(arguments));
  SOMATO_TRY(auto explorer, simulated_explorer(chosen.body, chosen.things, {}, seed));
  const std::string name = choice_name(chosen.body);
  return BodySession{name, name, std::move(chosen.things.objects), std::move(explorer)};
}

// The last states of a device that stopped are saved beside the recording.
Result<BodySession> device_session(const Arguments& arguments, PermittedBy permitted) {
  const std::string beside = arguments.has("output") ? arguments.text("output") : "somato";
  SOMATO_TRY(const auto file, read_checked_device(arguments.text("device")));
  SOMATO_TRY(auto explorer, device_explorer(arguments, beside, permitted));
  BodySession session{file.settings.name, file.settings.body, {}, std::move(explorer)};
  for (const ExploredThing& thing : session.explorer->things()) {
    if (thing.object) session.objects.push_back(*thing.object);
  }
  return session;
}

}  // namespace

Result<BodySession> body_session(const Arguments& arguments, std::uint64_t seed,
                                 PermittedBy permitted) {
  SOMATO_TRY_VOID(check_topic_flags(arguments));
  if (arguments.has("topics")) return topic_session(arguments);
  if (arguments.has("body") && arguments.has("device")) {
    return fail(ErrorKind::kUsage, "a body and a device are given", "--device", "omit one of them");
  }
  return arguments.has("device") ? device_session(arguments, permitted)
                                 : simulated_session(arguments, seed);
}

Result<std::unique_ptr<SimulatedExplorer>> chosen_simulation(const Arguments& arguments,
                                                             std::uint64_t seed) {
  SOMATO_TRY(const auto chosen, chosen_body(arguments));
  return simulated_explorer(chosen.body, chosen.things, {}, seed);
}

Result<std::size_t> find_thing(const Explorer& explorer, const std::string& name) {
  std::vector<std::string> known;
  for (const ExploredThing& thing : explorer.things()) {
    if (thing.name == name) return known.size();
    known.push_back(thing.name);
  }
  return fail(unknown_name("thing", name, "--object", known));
}

Result<ObjectTable> read_objects(const Arguments& arguments) {
  if (!arguments.has("objects")) return ObjectTable{};
  return read_object_table(arguments.text("objects"), declared_materials());
}

}  // namespace somato::program
