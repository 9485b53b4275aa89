#include "report_things.h"

#include <array>
#include <optional>
#include <utility>

#include "explore_table.h"
#include "somato/simulation/explorer.h"

namespace somato::program {
namespace {

struct MaterialColour {
  const char* name;
  std::array<double, 3> colour;
};

// What the real things look like, more or less; nothing in the simulation has a colour.
constexpr MaterialColour kColours[] = {
    {"wood", {0.76, 0.57, 0.35}},     {"metal", {0.66, 0.69, 0.73}},
    {"plastic", {0.83, 0.30, 0.25}},  {"hard_board", {0.55, 0.40, 0.28}},
    {"rubber", {0.22, 0.24, 0.27}},   {"sponge", {0.93, 0.80, 0.36}},
    {"corduroy", {0.36, 0.42, 0.62}}, {"felt", {0.35, 0.55, 0.42}}};

std::optional<std::array<double, 3>> colour_of(const std::string& material) {
  for (const MaterialColour& known : kColours) {
    if (material == known.name) return known.colour;
  }
  return {};
}

ReportThing thing_of(const Object& object) {
  return {object.name,
          choice_name(object.shape),
          object.size,
          object.top_diameter,
          object.material.name,
          choice_name(object.material.hardness),
          colour_of(object.material.name),
          object.mass};
}

ReportThing thing_of(const Material& material) {
  return {material.name,
          {},
          {},
          0.0,
          material.name,
          choice_name(material.hardness),
          colour_of(material.name),
          {}};
}

void append(const ObjectTable& table, std::vector<ReportThing>& things) {
  for (const Object& object : table.objects) things.push_back(thing_of(object));
}

template <typename Parameters>
void add_units(const std::string& table, const Parameters& /*parameters*/,
               std::map<std::string, std::string>& units) {
  for (const auto& parameter : Parameters::declarations().all()) {
    units[table + "." + parameter.info.name] = parameter.info.unit;
  }
}

}  // namespace

Result<std::vector<ReportThing>> report_things() {
  std::vector<ReportThing> things;
  for (const auto& [body, name] : Choices<ExploringBody>::all()) {
    auto table = default_things(body);
    if (!table) return fail(std::move(table.error()));
    append(*table, things);
  }
  for (const char* name : {"lucs3_new", "lucs3_sides"}) {
    auto table = own_object_table(name, declared_materials());
    if (!table) return fail(std::move(table.error()));
    append(*table, things);
  }
  for (const Material& material : declared_materials()) things.push_back(thing_of(material));
  return things;
}

std::map<std::string, std::string> explore_units() {
  const ExploringParameters all;
  std::map<std::string, std::string> units;
  add_units("explore.simulation", all.simulation, units);
  add_units("explore.plan", all.plan, units);
  add_units("explore.grasp", all.grasp, units);
  add_units("explore.closing", all.closing, units);
  add_units("explore.texture_probe", all.texture_probe, units);
  add_units("explore.stroke", all.stroke, units);
  add_units("explore.hardness_probe", all.hardness_probe, units);
  add_units("explore.press", all.press, units);
  return units;
}

}  // namespace somato::program
