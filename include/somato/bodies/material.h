#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/recording/recording.h"

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
  double friction = 0.5;                ///< Coulomb coefficient, against skin, table and edge.
  double stiffness = 50.0;              ///< N/mm under the tip of the hardness probe.
  /// N/mm under a taxel's dome; without a value: as under the tip.
  std::optional<double> touch_stiffness;
  double loss = 0.1;                ///< Loss factor: damping of what vibrates against it.
  double roughness = 5.0;           ///< Root mean square height of the surface, um.
  double correlation_length = 0.3;  ///< Heights further apart are independent, mm.
  /// How heights grow with distance below that length: as its power.
  double hurst = 0.7;
  double weave_period = 0.0;  ///< mm; 0: no weave.
  double weave_height = 0.0;  ///< Of its ridges over its grooves, um.

  /// All but the name.
  static const Declarations<Material>& declarations();

  /// Whether the numbers fit each other. Errors (kUsage): one out of its range; a weave with a
  /// period and no height, or the other way round.
  Result<void> validate() const;

  /// N/mm under a taxel's dome.
  double stiffness_under_taxel() const { return touch_stiffness.value_or(stiffness); }
};

/// The material that `table` describes, by the keys of Material::declarations(). Errors (kUsage) of
/// read_parameters() and Material::validate(), with their place.
Result<Material> read_material(const std::string& name, const Table& table);

/// The materials in the tables [material.NAME] of a file, in their order; none when there are none.
/// Errors (kUsage) as read_material(), and for a 'material' that holds anything but tables.
Result<std::vector<Material>> read_materials(const Table& file);

/// The eight materials of objects/materials.toml, four soft and four hard.
const std::vector<Material>& declared_materials();

/// The material of that name; an unknown name is an error (kUsage) with the nearest known one.
Result<Material> find_material(std::span<const Material> materials, std::string_view name);

/// What is known about an exploration of the material itself: material, hardness, and trial, which
/// is written counting from 1 and given from 0.
std::vector<Label> labels_of(const Material& material, std::size_t trial);

}  // namespace somato
