#include "report/report_things.h"

#include "bodies/objects/built_in_things.h"
#include "bodies/objects/material_colour.h"
#include "explore/explore_table.h"

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

}  // namespace

std::vector<ReportThing> built_in_things() {
  return things_in({built_in_objects(), declared_materials()});
}

std::vector<ReportThing> things_in(const ObjectTable& table) {
  std::vector<ReportThing> things;
  things.reserve(table.objects.size());
  for (const Object& object : table.objects) things.push_back(thing_of(object));
  for (const Material& material : table.materials) things.push_back(thing_of(material));
  return things;
}

std::map<std::string, std::string> explore_units() {
  std::map<std::string, std::string> units;
  for (const auto& [name, info] : explore_parameters()) units[name] = info.unit;
  return units;
}

}  // namespace somato::program
