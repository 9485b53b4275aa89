#include "somato/bodies/material.h"

#include <fmt/format.h>

#include "base/files/embedded.h"
#include "base/files/toml_file.h"
#include "somato/core/check.h"

namespace somato {
namespace {

tl::unexpected<Error> not_tables(const std::string& where) {
  return fail(ErrorKind::kUsage, "'material' must be a table", where,
              "write each material as a table [material.NAME]");
}

// Properties used by the texture probe.
void declare_surface(Declarations<Material>& d) {
  d.add("loss", &Material::loss, "", Range::between(0, 2),
        "Loss factor: damping of vibrations; not given in the paper");
  d.add("roughness", &Material::roughness, "um", Range::between(0, 2000),
        "Root mean square height of the surface; not given in the paper");
  d.add("correlation_length", &Material::correlation_length, "mm", Range::between(0.02, 100),
        "Correlation length of the heights; not given in the paper");
  d.add("hurst", &Material::hurst, "", Range::between(0.05, 1),
        "Exponent of the height differences as a function of distance below that length; not given "
        "in "
        "the paper");
  d.add("weave_period", &Material::weave_period, "mm", Range::between(0, 100),
        "Period of the ridges of a weave; 0: no weave; not given in the paper");
  d.add("weave_height", &Material::weave_height, "um", Range::between(0, 5000),
        "Height of the ridges above the grooves; not given in the paper");
}

}  // namespace

const std::vector<std::pair<Hardness, std::string>>& Choices<Hardness>::all() {
  static const std::vector<std::pair<Hardness, std::string>> choices = {{Hardness::kSoft, "soft"},
                                                                        {Hardness::kHard, "hard"}};
  return choices;
}

const Declarations<Material>& Material::declarations() {
  static const Declarations<Material> all = [] {
    Declarations<Material> d;
    d.add("hardness", &Material::hardness, "", Range::any(),
          "Group of the material; not given in the paper");
    d.add("density", &Material::density, "kg/m^3", Range::between(0.001, 1e6),
          "Density; not given in the paper");
    d.add("friction", &Material::friction, "", Range::between(0, 2),
          "Coulomb friction against skin and table; not given in the paper");
    d.add("stiffness", &Material::stiffness, "N/mm", Range::between(1e-6, 1e9),
          "Force per mm under the tip of the hardness probe; not given in the paper");
    d.add("touch_stiffness", &Material::touch_stiffness, "N/mm", Range::between(1e-6, 1e9),
          "Force per mm under a taxel; automatic: as under the tip; not given in the paper");
    declare_surface(d);
    return d;
  }();
  return all;
}

Result<void> Material::validate() const {
  SOMATO_TRY_VOID(check_ranges(*this));
  if ((weave_period > 0.0) == (weave_height > 0.0)) return {};
  return fail(ErrorKind::kUsage, "a weave needs both 'weave_period' and 'weave_height'", {},
              "set both, or neither");
}

Result<Material> read_material(const std::string& name, const Table& table) {
  Material defaults;
  defaults.name = name;
  auto material = read_parameters<Material>(table, std::move(defaults));
  if (!material) return material;
  if (auto valid = material->validate(); !valid) {
    valid.error().where = table.where;
    return fail(std::move(valid.error()));
  }
  return material;
}

Result<std::vector<Material>> read_materials(const Table& file) {
  const Table::Entry* entry = file.find("material");
  if (!entry) return std::vector<Material>{};
  const Table* tables = std::get_if<Table>(&entry->content);
  if (!tables) return not_tables(entry->where);
  std::vector<Material> materials;
  materials.reserve(tables->entries.size());
  for (const Table::Entry& each : tables->entries) {
    const Table* table = std::get_if<Table>(&each.content);
    if (!table) return not_tables(each.where);
    SOMATO_TRY(auto material, read_material(each.name, *table));
    materials.push_back(std::move(material));
  }
  return materials;
}

const std::vector<Material>& declared_materials() {
  static const std::vector<Material> all = [] {
    constexpr std::string_view kFile = "objects/materials.toml";
    const auto file = parse_toml(detail::embedded_text(kFile), kFile);
    SOMATO_ASSERT(file);
    auto materials = read_materials(*file);
    SOMATO_ASSERT(materials);
    return std::move(*materials);
  }();
  return all;
}

Result<Material> find_material(std::span<const Material> materials, std::string_view name) {
  std::vector<std::string> known;
  known.reserve(materials.size());
  for (const Material& material : materials) {
    if (material.name == name) return material;
    known.push_back(material.name);
  }
  return fail(unknown_name("material", name, {}, known));
}

std::vector<Label> labels_of(const Material& material, std::size_t trial) {
  return {{"material", material.name},
          {"hardness", choice_name(material.hardness)},
          {"trial", fmt::format("{}", trial + 1)}};
}

}  // namespace somato
