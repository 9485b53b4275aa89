#pragma once

#include <cstddef>
#include <memory>

#include "nanobind/nanobind.h"
#include "somato/graph/system_model.h"

namespace somato::python {

/// A trained system, for Python. Copies share it.
struct TrainedSystem {
  std::shared_ptr<const SystemModel> model;

  const System& system() const { return model->system; }

  /// The module that answers, or without an answer the last map. Throws Failure (kUsage) for a
  /// system without a map.
  std::size_t map() const;
};

/// Name, type, inputs and parameters of each module: a list of dictionaries.
nanobind::list modules_of(const SystemDescription& description);

}  // namespace somato::python
