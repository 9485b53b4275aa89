#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/object_table.h"

namespace somato {

inline Material material_of(std::string name, double density) {
  Material material;
  material.name = std::move(name);
  material.density = density;
  return material;
}

/// The materials that tables may be of, whatever else is known.
inline const std::vector<Material>& declared() {
  static const std::vector<Material> all{material_of("plastic", 1000), material_of("metal", 8000),
                                         material_of("hard_board", 700), material_of("wood", 600)};
  return all;
}

inline void expect_says(const std::string& message, std::initializer_list<std::string> parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks: " << part;
  }
}

}  // namespace somato
