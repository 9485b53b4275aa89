#include "explore/explore_table.h"

#include <utility>

namespace somato::program {
namespace {

template <typename Parameters>
void add_parameters(const std::string& table, const Parameters& /*parameters*/,
                    std::map<std::string, ParameterInfo>& all) {
  for (const ParameterInfo& info : Parameters::declarations().infos()) {
    all[table + "." + info.name] = info;
  }
}

}  // namespace

const Declarations<ExploreParameters>& ExploreParameters::declarations() {
  using P = ExploreParameters;
  static const auto declared =
      Declarations<P>()
          .add("body", &P::body, "", Range::any(), "Body that explores. Required.")
          .add("objects", &P::objects, "", Range::any(),
               "TOML file with the objects and materials to explore, or the name of a built-in "
               "table; empty: the body's own.")
          .add("explorations", &P::explorations, "", Range::between(1, 1e6),
               "Number of explorations of each object or material.")
          .add("new_objects", &P::new_objects, "", Range::any(),
               "Whether the body's new objects are explored once each, as test data.");
  return declared;
}

Result<ExploringBody> read_body(const Arguments& arguments) {
  return choice_named<ExploringBody>("body", arguments.text("body"), "--body");
}

Result<ExploreTable> read_explore_table(const Table& table) {
  Table keys{table.where, {}};
  Table tables{table.where, {}};
  for (const Table::Entry& entry : table.entries) {
    (std::holds_alternative<Table>(entry.content) ? tables : keys).entries.push_back(entry);
  }
  if (!keys.find("body")) {
    return fail(ErrorKind::kUsage, "[explore] requires a body", table.where,
                "add body = \"lucs2\", or another body");
  }
  SOMATO_TRY(auto explore, read_parameters<ExploreParameters>(keys));
  if (explore.new_objects && explore.body != ExploringBody::kLucs3) {
    return fail(ErrorKind::kUsage, "only lucs3 has a table of new objects",
                keys.find("new_objects")->where, "use --test-data instead");
  }
  SOMATO_TRY(auto exploring, read_exploring_parameters(tables));
  return ExploreTable{std::move(explore), std::move(exploring)};
}

std::map<std::string, ParameterInfo> explore_parameters() {
  const ExploringParameters tables;
  std::map<std::string, ParameterInfo> all;
  add_parameters("explore", ExploreParameters{}, all);
  add_parameters("explore.simulation", tables.simulation, all);
  add_parameters("explore.plan", tables.plan, all);
  add_parameters("explore.grasp", tables.grasp, all);
  add_parameters("explore.closing", tables.closing, all);
  add_parameters("explore.texture_probe", tables.texture_probe, all);
  add_parameters("explore.stroke", tables.stroke, all);
  add_parameters("explore.hardness_probe", tables.hardness_probe, all);
  add_parameters("explore.press", tables.press, all);
  return all;
}

std::string to_text(const ExploreTable& table) {
  const ExploringParameters& all = table.exploring;
  return parameters_to_toml(table.explore) + parameters_to_toml(all.simulation) +
         parameters_to_toml(all.plan) + parameters_to_toml(all.grasp) +
         parameters_to_toml(all.closing) + parameters_to_toml(all.texture_probe) +
         parameters_to_toml(all.stroke) + parameters_to_toml(all.hardness_probe) +
         parameters_to_toml(all.press);
}

}  // namespace somato::program
