#include "somato/bodies/material.h"

namespace somato {

const std::vector<std::pair<Hardness, std::string>>& Choices<Hardness>::all() {
  static const std::vector<std::pair<Hardness, std::string>> choices = {{Hardness::kSoft, "soft"},
                                                                        {Hardness::kHard, "hard"}};
  return choices;
}

const Declarations<Material>& Material::declarations() {
  static const Declarations<Material> all = [] {
    Declarations<Material> d;
    d.add(
        "hardness", [](auto& m) -> auto& { return m.hardness; }, "", Range::any(),
        "The group it belongs to; not given in the paper");
    d.add(
        "density", [](auto& m) -> auto& { return m.density; }, "kg/m^3", Range::above(0),
        "Density; not given in the paper");
    d.add(
        "friction", [](auto& m) -> auto& { return m.friction; }, "", Range::between(0, 2),
        "Coulomb friction against skin and table; not given in the paper");
    d.add(
        "stiffness", [](auto& m) -> auto& { return m.stiffness; }, "N/mm", Range::above(0),
        "Force for a mm under the tip of the hardness probe; not given in the paper");
    return d;
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

}  // namespace somato
