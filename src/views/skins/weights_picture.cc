#include "views/skins/weights_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "maps/pictures/map_panels.h"
#include "somato/core/check.h"
#include "somato/core/parameter.h"
#include "views/skins/skin_picture.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

// Elements without names have numbers.
Names names_of(const Som& som, const Names& names) {
  Names all = names;
  for (std::size_t i = all.size(); i < som.input_size(); ++i) {
    all.push_back(fmt::format("{}", i + 1));
  }
  return all;
}

// The inputs that are the elements of the channel.
Result<std::vector<std::size_t>> inputs_of(const ChannelPlaces& channel, const Names& names) {
  std::vector<std::size_t> inputs(names.size());
  std::iota(inputs.begin(), inputs.end(), std::size_t{0});
  if (channel.elements.empty()) return inputs;
  inputs.clear();
  for (const std::string& element : channel.elements) {
    const auto found = std::find(names.begin(), names.end(), element);
    if (found == names.end()) return fail(unknown_name("input", element, channel.where, names));
    inputs.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return inputs;
}

std::string title_of(const Grid& grid, std::size_t neuron) {
  if (grid.graph() != nullptr) return fmt::format("neuron {}", neuron + 1);
  return fmt::format("row {}, column {}", neuron / grid.columns() + 1, neuron % grid.columns() + 1);
}

SkinFrame frame_of(const Som& som, const std::vector<std::size_t>& inputs, std::size_t neuron) {
  SkinFrame frame{title_of(som.grid(), neuron), {}, {}};
  for (const std::size_t input : inputs) {
    frame.values.push_back(som.weight(neuron, input));
  }
  return frame;
}

Result<void> set_range(SkinPicture& picture) {
  picture.least = INFINITY;
  picture.greatest = -INFINITY;
  for (const SkinFrame& frame : picture.frames) {
    for (const float value : frame.values) {
      if (!std::isfinite(value)) {
        return fail(ErrorKind::kUsage, "a weight is not finite", frame.title,
                    "train the map again");
      }
      picture.least = std::min(picture.least, double{value});
      picture.greatest = std::max(picture.greatest, double{value});
    }
  }
  return {};
}

Result<void> check_one(const std::vector<ChannelPlaces>& layout) {
  if (layout.size() == 1) return {};
  return fail(ErrorKind::kUsage, fmt::format("the layout has {} channels", layout.size()),
              layout.empty() ? std::string() : layout.back().where,
              "a map has one list of inputs: use one table [layout.CHANNEL]");
}

}  // namespace

Result<SkinInputs> inputs_on_skin(const Som& som, const Names& names,
                                  const std::vector<ChannelPlaces>& layout) {
  SOMATO_TRY_VOID(check_one(layout));
  const Names all = names_of(som, names);
  SkinInputs elements;
  SOMATO_TRY(elements.inputs, inputs_of(layout.front(), all));
  for (const std::size_t input : elements.inputs) elements.names.push_back(all[input]);
  SOMATO_TRY(elements.skin, places_for(layout.front(), elements.names));
  return elements;
}

Result<std::string> draw_weights(const Som& som, const SkinInputs& elements,
                                 std::optional<std::size_t> neuron, const std::string& title) {
  require(!neuron || *neuron < som.neurons(), "the neuron is not on the map");
  if (!neuron && som.neurons() > kMostNeuronsOnSkin) {
    return fail(ErrorKind::kUsage,
                fmt::format("{} neurons are more than the {} that one picture has", som.neurons(),
                            kMostNeuronsOnSkin),
                {}, "choose one neuron");
  }
  SkinPicture picture;
  picture.title = title;
  picture.caption = fmt::format("Weights of {} on the skin", caption_of(som.grid()));
  picture.element_names = elements.names;
  picture.places = elements.skin;
  picture.columns = som.grid().columns();
  for (std::size_t i = neuron.value_or(0); i < (neuron ? *neuron + 1 : som.neurons()); ++i) {
    picture.frames.push_back(frame_of(som, elements.inputs, i));
  }
  SOMATO_TRY_VOID(set_range(picture));
  return draw_skin(picture);
}

}  // namespace somato
