#include "systems/graph/layout_fit.h"

#include <fmt/format.h>

namespace somato {

Result<void> check_layout(const System& trained, const RecordingLayout& layout) {
  SOMATO_TRY(const auto other, System::build(trained.description(), layout));
  for (std::size_t i = 0; i < other.modules().size(); ++i) {
    const SystemModule& module = other.modules()[i];
    const PortType& then = trained.modules()[i].output;
    if (module.output.shape == then.shape) continue;
    return fail(ErrorKind::kData,
                fmt::format("module '{}' gives {}, but gave {} in training", module.name,
                            to_string(module.output), to_string(then)));
  }
  return {};
}

}  // namespace somato
