#include "explore/explore_table.h"

#include <utility>

#include "base/files/toml_file.h"
#include "somato/bodies/material.h"

namespace somato::program {
namespace {

template <typename Parameters>
void add_parameters(const std::string& table, const Parameters& /*parameters*/,
                    std::map<std::string, ParameterInfo>& all) {
  for (const ParameterInfo& info : Parameters::declarations().infos()) {
    all[table + "." + info.name] = info;
  }
}

bool declares_things(const Table::Entry& entry) {
  return entry.name == "object" || entry.name == "material";
}

// The path of a file is what precedes the line in a location.
std::string file_of(const std::string& where) {
  return where.substr(0, where.rfind(':'));
}

Result<void> read_things(const Table& things, ExploreTable& read) {
  if (things.entries.empty()) return {};
  const Table::Entry& first = things.entries.front();
  if (!read.explore.objects.empty()) {
    return fail(ErrorKind::kUsage, "[explore] has 'objects' and a table '" + first.name + "'",
                first.where, "remove one of them");
  }
  SOMATO_TRY(auto table, object_table_of(things, file_of(things.where), declared_materials()));
  read.things = std::move(table);
  read.things_text = to_toml(things);
  return {};
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
  Table things{table.where, {}};
  for (const Table::Entry& entry : table.entries) {
    const bool is_table = std::holds_alternative<Table>(entry.content);
    Table& same = declares_things(entry) ? things : is_table ? tables : keys;
    same.entries.push_back(entry);
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
  ExploreTable read{std::move(explore), std::move(exploring)};
  SOMATO_TRY_VOID(read_things(things, read));
  return read;
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

std::map<std::string, std::string> explore_defaults() {
  std::map<std::string, std::string> defaults;
  for (const auto& [name, info] : explore_parameters()) defaults[name] = info.default_text;
  return defaults;
}

std::string to_text(const ExploreTable& table) {
  const ExploringParameters& all = table.exploring;
  return parameters_to_toml(table.explore) + parameters_to_toml(all.simulation) +
         parameters_to_toml(all.plan) + parameters_to_toml(all.grasp) +
         parameters_to_toml(all.closing) + parameters_to_toml(all.texture_probe) +
         parameters_to_toml(all.stroke) + parameters_to_toml(all.hardness_probe) +
         parameters_to_toml(all.press) + table.things_text;
}

}  // namespace somato::program
