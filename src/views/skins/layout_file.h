#pragma once

#include <string>
#include <vector>

#include "somato/core/parameter.h"
#include "views/skins/channel_places.h"

namespace somato {

/// The keys of a table [layout.CHANNEL] apart from its table of groups.
struct LayoutKeys {
  std::vector<std::vector<double>> places;
  std::vector<std::string> elements;
  std::string picture;
  std::vector<std::vector<double>> picture_corners;

  static const Declarations<LayoutKeys>& declarations();
};

/// The tables of the layout file at `path`, which docs/formats/layout-file.md describes; pictures
/// are found from its folder. Errors: kSystem for files that cannot be read; kUsage, with the
/// line, for unknown keys, no channel, no places or more than 4096, a place that is not two numbers
/// of at most 1e6, two elements at one place, an extent of more than 1000 distances between
/// neighbours, elements that occur twice or are not one for each place, an empty group, a picture
/// without corners or corners without a picture, another format than PNG, JPEG and SVG, more than
/// 512 KiB.
Result<std::vector<ChannelPlaces>> read_layout(const std::string& path);

}  // namespace somato
