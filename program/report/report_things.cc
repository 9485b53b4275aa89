#include "report/report_things.h"

#include <utility>

#include "bodies/objects/material_colour.h"
#include "explore/explore_table.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato::program {
namespace {

ReportThing thing_of(const Object& object) {
  return {object.name,
          choice_name(object.shape),
          object.size,
          object.top_diameter,
          object.material.name,
          choice_name(object.material.hardness),
          material_colour(object.material.name),
          object.mass};
}

ReportThing thing_of(const Material& material) {
  return {material.name,
          {},
          {},
          0.0,
          material.name,
          choice_name(material.hardness),
          material_colour(material.name),
          {}};
}

void append(const ObjectTable& table, std::vector<ReportThing>& things) {
  for (const Object& object : table.objects) things.push_back(thing_of(object));
  for (const Material& material : table.materials) things.push_back(thing_of(material));
}

}  // namespace

Result<std::vector<ReportThing>> report_things() {
  std::vector<ReportThing> things;
  for (const std::string& name : own_object_tables()) {
    SOMATO_TRY(auto table, own_object_table(name, declared_materials()));
    append(table, things);
  }
  append({{}, declared_materials()}, things);
  return things;
}

std::map<std::string, std::string> explore_units() {
  std::map<std::string, std::string> units;
  for (const auto& [name, info] : explore_parameters()) units[name] = info.unit;
  return units;
}

}  // namespace somato::program
