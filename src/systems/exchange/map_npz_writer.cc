#include "systems/exchange/map_npz_writer.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/archives/zip_writer.h"
#include "base/arrays/npy_numbers.h"
#include "base/arrays/npy_texts.h"
#include "base/core/memory.h"
#include "base/files/file_writer.h"
#include "base/text/text.h"
#include "maps/som/layer_parts.h"
#include "somato/core/check.h"
#include "systems/exchange/map_npz_format.h"
#include "systems/exchange/parameters_json.h"
#include "systems/model/som_model_fit.h"

namespace somato {
namespace {

class MapWriter {
 public:
  explicit MapWriter(FileWriter file)
      : file_(std::move(file)),
        zip_([this](std::string_view bytes) { return file_.write(bytes); }) {}

  Result<void> add(const std::string& name, std::string_view npy) {
    return zip_.add(name + ".npy", npy);
  }

  Result<void> finish() {
    return zip_.finish().and_then([&] { return file_.commit(); });
  }

 private:
  FileWriter file_;
  ZipWriter zip_;
};

// The dimensions of the neurons: those of the grid, or one for a graph.
std::vector<std::size_t> neuron_shape(const Grid& grid) {
  if (grid.graph() != nullptr) return {grid.size()};
  return {grid.rows(), grid.columns()};
}

std::vector<std::size_t> shape_with(const Grid& grid, std::size_t last) {
  std::vector<std::size_t> shape = neuron_shape(grid);
  shape.push_back(last);
  return shape;
}

// A member of a ZIP archive has less than 4 GiB, and all of it is in memory once more.
Result<void> check_size(const Som& som) {
  const double bytes = static_cast<double>(som.neurons()) * static_cast<double>(som.input_size()) *
                       double{sizeof(float)};
  constexpr double kMost = std::numeric_limits<std::uint32_t>::max() - 1024.0;  // and a header
  if (bytes > kMost) {
    return fail(ErrorKind::kData,
                fmt::format("the weights of {} neurons for {} features need {}, but an array of an "
                            "NPZ archive has less than 4 GiB",
                            som.neurons(), som.input_size(), memory_text(bytes)),
                {}, "use the model file itself");
  }
  return check_free_memory(som.neurons() * som.input_size(), sizeof(float), {});
}

std::string weights_array(const Som& som) {
  std::vector<float> weights(som.neurons() * som.input_size());
  float* next = weights.data();
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    for (std::size_t d = 0; d < som.input_size(); ++d) {
      const auto place = som.elements().place_of(d);
      *next++ = place ? som.weights()(neuron, *place) : 0.0F;
    }
  }
  return npy_of_numbers<float>(weights, shape_with(som.grid(), som.input_size()));
}

std::string positions_array(const Grid& grid) {
  std::vector<double> positions;
  positions.reserve(2 * grid.size());
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    const Position position = grid.position(neuron);
    positions.insert(positions.end(), {position.x, position.y});
  }
  return npy_of_numbers<double>(positions, shape_with(grid, 2));
}

std::string edges_array(const NeuronGraph& graph) {
  std::vector<std::int64_t> edges;
  for (const auto& [a, b] : graph.edges()) {
    edges.insert(edges.end(), {static_cast<std::int64_t>(a), static_cast<std::int64_t>(b)});
  }
  return npy_of_numbers<std::int64_t>(edges, std::array{graph.edges().size(), std::size_t{2}});
}

std::string labels_array_of(const Grid& grid, const NeuronLabels& labels) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(labels.neurons());
  for (std::size_t neuron = 0; neuron < labels.neurons(); ++neuron) {
    numbers.push_back(labels[neuron] ? static_cast<std::int64_t>(*labels[neuron]) : -1);
  }
  return npy_of_numbers<std::int64_t>(numbers, neuron_shape(grid));
}

std::string list_array(const std::vector<double>& numbers) {
  return npy_of_numbers<double>(numbers, std::array{numbers.size()});
}

std::string list_array(std::span<const std::uint32_t> numbers) {
  const std::vector<std::int64_t> wide(numbers.begin(), numbers.end());
  return npy_of_numbers<std::int64_t>(wide, std::array{wide.size()});
}

// numpy pads texts with zeros.
Result<void> check_names(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    require(is_utf8(name), "names of features and classes must be UTF-8");
    if (!name.ends_with('\0')) continue;
    return fail(ErrorKind::kData,
                "a name ends with the character U+0000, with which numpy pads texts", {},
                "rename the column or label");
  }
  return {};
}

Result<void> add_names(MapWriter& file, const std::string& name,
                       const std::vector<std::string>& names) {
  if (names.empty()) return {};
  SOMATO_TRY_VOID(check_names(names));
  return file.add(name, npy_of_texts(names));
}

Result<void> add_map(MapWriter& file, const Som& som) {
  const std::string format = kMapNpzFormat + std::to_string(kMapNpzVersion);
  SOMATO_TRY_VOID(file.add("file_format", npy_of_texts({format}, {})));
  SOMATO_TRY_VOID(file.add("parameters", npy_of_texts({parameters_to_json(som.parameters())}, {})));
  SOMATO_TRY_VOID(file.add("weights", weights_array(som)));
  SOMATO_TRY_VOID(file.add("positions", positions_array(som.grid())));
  const NeuronGraph* graph = som.grid().graph();
  if (graph != nullptr && !graph->edges().empty()) {
    SOMATO_TRY_VOID(file.add("edges", edges_array(*graph)));
  }
  if (!som.parameters().layers.empty()) {
    const std::string layers = layers_to_toml(som.parameters().layers);
    SOMATO_TRY_VOID(file.add("layers", npy_of_texts({layers}, {})));
  }
  if (!som.parameters().relevances.empty()) {
    SOMATO_TRY_VOID(file.add("relevances", list_array(som.parameters().relevances)));
  }
  if (som.elements().all()) return {};
  return file.add("elements", list_array(som.elements().listed()));
}

Result<void> add_scaling(MapWriter& file, const SomModel& model) {
  if (model.standardization) {
    SOMATO_TRY_VOID(file.add("mean", list_array(model.standardization->means)));
    SOMATO_TRY_VOID(file.add("scale", list_array(model.standardization->deviations)));
  }
  if (!model.means.empty()) SOMATO_TRY_VOID(file.add("fill_values", list_array(model.means)));
  if (!model.samples_seen) return {};
  const std::array seen{static_cast<std::int64_t>(*model.samples_seen)};
  return file.add("samples_seen", npy_of_numbers<std::int64_t>(seen, {}));
}

Result<void> write_map(MapWriter& file, const SomModel& model) {
  SOMATO_TRY_VOID(add_map(file, model.som));
  SOMATO_TRY_VOID(add_names(file, "feature_names", model.features));
  SOMATO_TRY_VOID(add_scaling(file, model));
  SOMATO_TRY_VOID(add_names(file, "class_names", model.classes));
  if (!model.classes.empty()) {
    SOMATO_TRY_VOID(file.add("labels", labels_array_of(model.som.grid(), model.labels)));
  }
  return file.finish();
}

}  // namespace

Result<void> save_map_npz(const std::string& path, const SomModel& model) {
  const std::string misfit = misfit_of(model);
  require(misfit.empty(), misfit);
  SOMATO_TRY_VOID(check_size(model.som));
  SOMATO_TRY(FileWriter file, FileWriter::begin(path));
  MapWriter writer(std::move(file));
  return write_map(writer, model);
}

}  // namespace somato
