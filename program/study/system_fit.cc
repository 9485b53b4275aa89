#include "study/system_fit.h"

#include "systems/graph/layout_fit.h"

namespace somato::program {
namespace {

struct Origin {
  std::string name;
  std::string others;
};

Result<void> check_channels(const System& system, const RecordingLayout& layout,
                            const Origin& origin, const std::string& place) {
  const auto fits = check_layout(system, layout);
  if (fits) return {};
  return fail(ErrorKind::kData,
              "the " + origin.name + " does not fit the system: " + fits.error().what, place,
              "use " + origin.others + " with the same channels");
}

}  // namespace

Result<void> check_fit(const System& system, const Recording& recording, const std::string& place) {
  return check_fit(system, layout_of(recording), place);
}

Result<void> check_fit(const System& system, const RecordingLayout& layout,
                       const std::string& place) {
  return check_channels(system, layout, {"recording", "recordings"}, place);
}

Result<void> check_body_fit(const System& system, const Exploration& begun,
                            const std::string& place) {
  return check_channels(system, layout_of({{begun}}), {"body", "a body"}, place);
}

}  // namespace somato::program
