#pragma once

#include "nanobind/nanobind.h"

namespace somato::python {

/// The parts of the extension module.
void bind_analysis(nanobind::module_& module);
void bind_codes(nanobind::module_& module);
void bind_explore(nanobind::module_& module);
void bind_map(nanobind::module_& module);
void bind_pictures(nanobind::module_& module);
void bind_rounding(nanobind::module_& module);
void bind_recording(nanobind::module_& module);
void bind_study(nanobind::module_& module);
void bind_suggestion(nanobind::module_& module);
void bind_system(nanobind::module_& module);
void bind_t_mpsom(nanobind::module_& module);

}  // namespace somato::python
