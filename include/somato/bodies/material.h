#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato {

/// Whether a material gives way under a finger.
enum class Hardness { kSoft, kHard };

template <>
struct Choices<Hardness> {
  static const std::vector<std::pair<Hardness, std::string>>& all();
};

/// What a thing is made of, as far as it can be felt. None of these numbers is given in the papers.
struct Material {
  std::string name;
  Hardness hardness = Hardness::kHard;  ///< The group it is said to belong to; a label.
  double density = 1000.0;              ///< kg/m^3.
  double friction = 0.5;                ///< Coulomb coefficient, against skin and table.
  double stiffness = 50.0;              ///< N/mm under the tip of the hardness probe.

  /// All but the name.
  static const Declarations<Material>& declarations();
};

/// The material of that name; an unknown name is an error (kUsage) with the nearest known one.
Result<Material> find_material(std::span<const Material> materials, std::string_view name);

}  // namespace somato
