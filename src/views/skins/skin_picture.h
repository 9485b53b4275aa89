#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "views/skins/skin_places.h"

namespace somato {

/// The readings of a skin, or of other elements of a channel, at one time.
struct SkinFrame {
  std::string title{};
  std::vector<float> values{};        ///< One per element, finite.
  std::vector<std::uint8_t> valid{};  ///< 0 for a missing value, else 1; empty if none is missing.
};

/// Frames of one channel, drawn side by side in the same range of colours.
struct SkinPicture {
  std::string title{};
  std::string caption{};                     ///< May be empty.
  std::vector<std::string> element_names{};  ///< One per element, or empty.
  std::vector<std::size_t> shape{};          ///< The shape of a frame; empty: flat.
  std::optional<SkinPlaces> places{};        ///< One per element; by default by names and shape.
  std::size_t columns = 0;                   ///< Frames side by side; 0: up to four.
  std::string unit{};
  double least = 0.0;  ///< The value with the first colour; lesser ones have it, too.
  double greatest = 0.0;
  std::vector<SkinFrame> frames{};  ///< At least one.
};

/// A standalone SVG picture: the elements at their places, with groups outlined and named; or on an
/// unfolded hand if their names give their places (such as "finger1_proximal_3"), otherwise in a
/// grid by the shape of the frame, each in the colour of its value, with a tooltip; missing values
/// are outlined. Throws InvalidArgument without frames or elements, for sizes that differ (also of
/// places), for values or limits that are not finite, and if `least` exceeds `greatest`.
std::string draw_skin(const SkinPicture& picture);

}  // namespace somato
