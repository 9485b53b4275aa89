#include "study/system_fit.h"

#include "somato/recording/layout.h"
#include "systems/graph/layout_fit.h"

namespace somato::program {
namespace {

struct Origin {
  std::string name;
  std::string others;
};

Result<void> check_channels(const System& system, const Recording& recording, const Origin& origin,
                            const std::string& place) {
  const auto fits = check_layout(system, layout_of(recording));
  if (fits) return {};
  return fail(ErrorKind::kData,
              "the " + origin.name + " does not fit the system: " + fits.error().what, place,
              "use " + origin.others + " with the same channels");
}

}  // namespace

Result<void> check_fit(const System& system, const Recording& recording, const std::string& place) {
  return check_channels(system, recording, {"recording", "recordings"}, place);
}

Result<void> check_body_fit(const System& system, const Exploration& begun,
                            const std::string& place) {
  return check_channels(system, {{begun}}, {"body", "a body"}, place);
}

}  // namespace somato::program
