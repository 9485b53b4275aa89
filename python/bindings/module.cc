#include "bindings.h"
#include "errors.h"

NB_MODULE(_somato, module) {
  module.doc() = "The C++ library, for the classes of the package.";
  module.attr("__version__") = SOMATO_VERSION;
  somato::python::register_failures();
  somato::python::bind_codes(module);
  somato::python::bind_explore(module);
  somato::python::bind_map(module);
  somato::python::bind_analysis(module);
  somato::python::bind_pictures(module);
  somato::python::bind_recording(module);
  somato::python::bind_rounding(module);
  somato::python::bind_system(module);
  somato::python::bind_study(module);
  somato::python::bind_suggestion(module);
  somato::python::bind_t_mpsom(module);
}
