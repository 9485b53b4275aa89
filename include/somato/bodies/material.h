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

/// Whether a material yields under a finger.
enum class Hardness { kSoft, kHard };

template <>
struct Choices<Hardness> {
  static const std::vector<std::pair<Hardness, std::string>>& all();
};

/// The tactile properties of a material. None of these numbers is given in the papers.
struct Material {
  std::string name;
  Hardness hardness = Hardness::kHard;  ///< The group of the material; a label.
  double density = 1000.0;              ///< kg/m^3.
  double friction = 0.5;                ///< Coulomb coefficient, against skin, table and edge.
  double stiffness = 50.0;              ///< N/mm under the tip of the hardness probe.
  /// N/mm under a taxel's dome; empty: as under the tip.
  std::optional<double> touch_stiffness;
  double loss = 0.1;       ///< Loss factor: damping of vibrations.
  double roughness = 5.0;  ///< Root mean square height of the surface, um.
  double correlation_length =
      0.3;  ///< Correlation length: heights further apart are independent, mm.
  /// Exponent of the growth of height differences with distance below that length.
  double hurst = 0.7;
  double weave_period = 0.0;  ///< mm; 0: no weave.
  double weave_height = 0.0;  ///< Height of its ridges above its grooves, um.

  /// All keys except the name.
  static const Declarations<Material>& declarations();

  /// Whether the numbers are consistent. Errors (kUsage): one out of its range; a weave with a
  /// period and no height, or vice versa.
  Result<void> validate() const;

  /// N/mm under a taxel's dome.
  double stiffness_under_taxel() const { return touch_stiffness.value_or(stiffness); }

  bool operator==(const Material&) const = default;
};

/// The material described by `table`, with the keys of Material::declarations(). Errors (kUsage) of
/// read_parameters() and Material::validate(), with their location.
Result<Material> read_material(const std::string& name, const Table& table);

/// The materials in the tables [material.NAME] of a file, in order; empty without such tables.
/// Errors (kUsage) as read_material(), and for a 'material' that contains anything but tables.
Result<std::vector<Material>> read_materials(const Table& file);

/// The eight materials of objects/materials.toml, four soft and four hard.
const std::vector<Material>& declared_materials();

/// The material with that name; an unknown name is an error (kUsage) with the nearest known one.
Result<Material> find_material(std::span<const Material> materials, std::string_view name);

/// The labels of an exploration of the material itself: material, hardness, and trial, which is
/// written counting from 1 and passed counting from 0.
std::vector<Label> labels_of(const Material& material, std::size_t trial);

}  // namespace somato
