// Uses what is installed as a user would; exits with 0 when the answers are right.

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "somato/codes/spectrum.h"
#include "somato/core/parameter.h"
#include "somato/core/random.h"
#include "somato/core/signal.h"
#include "somato/graph/som_model.h"
#include "somato/graph/system.h"
#include "somato/maps/som_training.h"

namespace {

bool inner_product_is_right() {
  const auto dense = somato::Signal::dense(std::vector<float>{1, 2, 3});
  const auto sparse = somato::Signal::sparse({3}, {2}, {0.5F});
  return somato::inner_product(dense.view(), sparse.view()) == 1.5;
}

bool random_numbers_are_right() {
  return somato::philox4x32({0, 0, 0, 0}, {0, 0})[0] == 0x6627E8D5;
}

// Needs the formatting library that stands behind the static library.
bool messages_are_right() {
  const somato::Error error = somato::unknown_name("key", "row", "a.toml:2", {"rows"});
  return to_string(error) == "a.toml:2: unknown key 'row'; did you mean 'rows'?";
}

// Needs nothing but the static library, though a transform stands behind it.
bool spectrum_is_right() {
  somato::SpectrumParameters parameters;
  parameters.bands = 2;
  const somato::Matrix<float> frames(8, 1, {1, -1, 1, -1, 1, -1, 1, -1});
  const auto spectrum = somato::Spectrum(parameters).apply(frames, 100.0);
  return spectrum && spectrum->values()[1] > 100.0F * spectrum->values()[0];
}

// Trains, saves and loads a map: the rooms above the core.
bool a_map_comes_back(const char* path) {
  const somato::Samples samples(somato::Matrix<float>(3, 2, {0, 0, 1, 0, 1, 1}));
  somato::SomModel model;
  model.som = somato::train_som({}, samples).value();
  if (!somato::save_som_model(path, model)) return false;
  const auto loaded = somato::load_som_model(path);
  return loaded && loaded->som.weights() == model.som.weights();
}

// Builds a system from a description put together in C++, without a file.
bool a_system_is_built() {
  somato::SystemBuilder builder("user");
  builder
      .module("hand", "channel",
              {{"channel", {std::string("joints")}},
               {"shape", {somato::Value::List{{std::int64_t{9}}}}}})
      .module("closed", "last", {{"input", {std::string("hand")}}});
  const auto system = somato::System::build(builder.description(), {});
  return system && system->modules()[1].output.shape == std::vector<std::size_t>{9};
}

}  // namespace

int main() {
  if (!a_system_is_built()) return 3;
  if (!a_map_comes_back("installed.somato")) return 2;
  if (inner_product_is_right() && random_numbers_are_right() && messages_are_right() &&
      spectrum_is_right()) {
    return 0;
  }
  std::puts("the installed library gives wrong answers");
  return 1;
}
