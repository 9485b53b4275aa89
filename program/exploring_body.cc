#include "exploring_body.h"

#include <utility>
#include <vector>

#include "explore_table.h"

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

}  // namespace

Result<SimulatedSession> simulated_session(const Arguments& arguments, std::uint64_t seed) {
  SOMATO_TRY(const auto body, read_one_body(arguments));
  SOMATO_TRY(auto things,
             arguments.has("objects") ? read_objects(arguments) : default_things(body));
  SOMATO_TRY(auto explorer, simulated_explorer(body, things, {}, seed));
  return SimulatedSession{body, std::move(things), std::move(explorer)};
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
