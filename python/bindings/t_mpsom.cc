#include "somato/maps/t_mpsom.h"

#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "base/archives/archive.h"
#include "bindings.h"
#include "errors.h"
#include "interrupts.h"
#include "maps/t_mpsom/t_mpsom_archive.h"
#include "maps/t_mpsom/t_mpsom_learner.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/maps/som_training.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

const std::string kKind = "t_mpsom";
const std::string kPrefix = "map.";

/// The inputs in a row: its columns, input by input.
class RowInputs {
 public:
  RowInputs(const TMpsomParameters& parameters, const Rows& rows)
      : sizes_(parameters.input_sizes), rows_(rows), inputs_(sizes_.size()) {}

  std::span<const SignalView> at(std::size_t row) {
    const float* next = rows_.data() + row * rows_.shape(1);
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      inputs_[i] = SignalView::dense({next, sizes_[i]});
      next += sizes_[i];
    }
    return inputs_;
  }

 private:
  const std::vector<std::size_t>& sizes_;
  const Rows& rows_;
  std::vector<SignalView> inputs_;
};

TMpsom initial(const nb::dict& values) {
  const auto parameters = parameters_of<TMpsomParameters>(values, "TMPSOM");
  value_or_throw(parameters.validate());
  return TMpsom(parameters);
}

void check_columns(const TMpsom& map, const Rows& rows) {
  std::size_t columns = 0;
  for (const std::size_t size : map.parameters().input_sizes) columns += size;
  if (columns == rows.shape(1)) return;
  throw Failure{Error{ErrorKind::kData,
                      "the inputs have " + std::to_string(columns) + " elements, but the data " +
                          std::to_string(rows.shape(1)) + " columns",
                      "TMPSOM(input_sizes)", "use sizes that add up to the number of columns"}};
}

// A copy of the map that has learned the rows that `next` gives, one in each iteration from `first`
// to before `last`.
template <typename Next>
TMpsom learned(const TMpsom& map, const Rows& rows, std::uint64_t first, std::uint64_t last,
               const Next& next, nb::object progress = nb::none()) {
  check_columns(map, rows);
  TMpsom changed = map;
  unlocked(
      [&](Interrupts& interrupts) {
        const Schedule rate = changed.parameters().learning_rate();
        RowInputs inputs(map.parameters(), rows);
        TMpsomLearner learner(changed);
        const Progress report = interrupts.progress();
        for (std::uint64_t t = first; t < last && report(t - first, last - first); ++t) {
          learner.learn(inputs.at(next(t)), rate.at(t));
        }
        report(last - first, last - first);
      },
      std::move(progress));
  return changed;
}

TMpsom train(const nb::dict& values, const Rows& rows, nb::object progress) {
  const TMpsom map = initial(values);
  DrawSequence draws(Draws::kWithReplacement, rows.shape(0), map.parameters().seed);
  return learned(
      map, rows, 0, map.parameters().iterations,
      [&](std::uint64_t /*iteration*/) { return draws.next(); }, std::move(progress));
}

TMpsom learn_in_order(const TMpsom& map, const Rows& rows, std::uint64_t done) {
  return learned(map, rows, done, done + rows.shape(0),
                 [&](std::uint64_t iteration) { return iteration - done; });
}

nb::object activity(const TMpsom& map, const Rows& rows) {
  check_columns(map, rows);
  std::vector<float> activity(rows.shape(0) * map.neurons());
  unlocked([&](Interrupts& interrupts) {
    RowInputs inputs(map.parameters(), rows);
    TMpsom::Workspace workspace(map);
    for (std::size_t i = 0; i < rows.shape(0) && interrupts.proceed(); ++i) {
      map.activation(inputs.at(i), workspace, {activity.data() + i * map.neurons(), map.neurons()});
    }
  });
  const std::size_t shape[] = {rows.shape(0), map.neurons()};
  return array_of(std::move(activity), shape);
}

nb::object weights(const TMpsom& map, std::size_t input) {
  const Matrix<float> all = map.weights(input);
  const std::size_t shape[] = {all.rows(), all.columns()};
  return array_of(std::vector<float>(all.values().begin(), all.values().end()), shape);
}

nb::bytes state_of(const TMpsom& map) {
  Archive archive(kKind);
  add_t_mpsom(archive, kPrefix, map);
  const std::string bytes = encode_archive(archive);
  return nb::bytes(bytes.data(), bytes.size());
}

void set_state(TMpsom& map, const nb::bytes& bytes) {
  const Archive archive = value_or_throw(decode_archive({bytes.c_str(), bytes.size()}, "pickle"));
  new (&map) TMpsom(value_or_throw(t_mpsom_from(archive, kPrefix, "pickle")));
}

}  // namespace

void bind_t_mpsom(nb::module_& module) {
  module.def("t_mpsom_parameters",
             [] { return descriptions_of(TMpsomParameters::declarations().infos()); });
  nb::class_<TMpsom>(module, "TMpsom", "A T-MPSOM, immutable.")
      .def_static("train", &train, nb::arg("parameters"), nb::arg("rows").noconvert(),
                  nb::arg("progress").none() = nb::none())
      .def_static("initial", &initial, nb::arg("parameters"))
      .def("learned", &learn_in_order, nb::arg("rows").noconvert(), nb::arg("done"))
      .def("activity", &activity, nb::arg("rows").noconvert())
      .def("weights", &weights, nb::arg("input"))
      .def_prop_ro("parameters", [](const TMpsom& map) { return dict_of(map.parameters()); })
      .def_prop_ro("neurons", &TMpsom::neurons)
      .def("__getstate__", &state_of)
      .def("__setstate__", &set_state);
}

}  // namespace somato::python
