#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "views/skins/skin_layout.h"

namespace somato {

/// The grid of `count` elements that are not of a hand; see skin_layout().
SkinLayout grid_layout(const std::vector<std::string>& names, std::size_t count,
                       const std::vector<std::size_t>& shape);

}  // namespace somato
