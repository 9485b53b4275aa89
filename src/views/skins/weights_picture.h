#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/maps/som.h"
#include "views/skins/channel_places.h"

namespace somato {

/// The most neurons in one picture of weights.
inline constexpr std::size_t kMostNeuronsOnSkin = 400;

/// Inputs of a map on a skin.
struct SkinInputs {
  std::vector<std::size_t> inputs;  ///< The input of each element.
  std::vector<std::string> names;   ///< The name of each element.
  SkinPlaces skin;
};

/// The input elements with the names that the layout lists, or without such a list all; `names` are
/// those of the input elements, or none. Errors (kUsage): those of places_for(), no channel or
/// several, elements that are no inputs.
Result<SkinInputs> inputs_on_skin(const Som& som, const std::vector<std::string>& names,
                                  const std::vector<ChannelPlaces>& layout);

/// A standalone SVG picture of the weights of a map on a skin: of one neuron, or of each in the
/// rows and columns of the map, all in one range of colours. Throws InvalidArgument for a neuron
/// that is not on the map. Errors (kUsage): more than kMostNeuronsOnSkin neurons; weights that are
/// not finite.
Result<std::string> draw_weights(const Som& som, const SkinInputs& elements,
                                 std::optional<std::size_t> neuron, const std::string& title);

}  // namespace somato
