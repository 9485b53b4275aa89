#include "recordings/layout_flag.h"

#include "views/skins/layout_file.h"

namespace somato::program {

Flag layout_flag(const std::string& what) {
  return input_flag("--layout",
                    "TOML file with the places of the elements, [layout.CHANNEL], " + what);
}

Result<std::vector<ChannelPlaces>> read_layout_flag(const Arguments& arguments) {
  if (!arguments.has("layout")) return std::vector<ChannelPlaces>();
  return read_layout(arguments.text("layout"));
}

}  // namespace somato::program
