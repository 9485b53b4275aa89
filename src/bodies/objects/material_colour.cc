#include "bodies/objects/material_colour.h"

namespace somato {
namespace {

struct MaterialColour {
  std::string_view material;
  std::array<double, 3> colour;
};

constexpr MaterialColour kColours[] = {
    {"wood", {0.76, 0.57, 0.35}},     {"metal", {0.66, 0.69, 0.73}},
    {"plastic", {0.83, 0.30, 0.25}},  {"hard_board", {0.55, 0.40, 0.28}},
    {"rubber", {0.22, 0.24, 0.27}},   {"sponge", {0.93, 0.80, 0.36}},
    {"corduroy", {0.36, 0.42, 0.62}}, {"felt", {0.35, 0.55, 0.42}}};

}  // namespace

std::optional<std::array<double, 3>> material_colour(std::string_view material) {
  for (const MaterialColour& known : kColours) {
    if (material == known.material) return known.colour;
  }
  return {};
}

}  // namespace somato
