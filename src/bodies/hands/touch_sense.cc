#include "bodies/hands/touch_sense.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace somato::detail {
namespace {

constexpr std::string_view kPrefix = "taxel_";

int taxel_of(const Taxels& taxels, int geom) {
  return geom < 0 ? -1 : taxels.taxel_of_geom[static_cast<std::size_t>(geom)];
}

}  // namespace

Taxels find_taxels(const mjModel& model) {
  Taxels taxels;
  const auto geoms = static_cast<int>(model.ngeom);
  taxels.taxel_of_geom.assign(static_cast<std::size_t>(geoms), -1);
  for (int geom = 0; geom < geoms; ++geom) {
    const char* name = mj_id2name(&model, mjOBJ_GEOM, geom);
    if (!name || !std::string_view(name).starts_with(kPrefix)) continue;
    taxels.taxel_of_geom[static_cast<std::size_t>(geom)] = static_cast<int>(taxels.names.size());
    taxels.names.emplace_back(std::string_view(name).substr(kPrefix.size()));
  }
  return taxels;
}

void read_forces(const mjModel& model, const mjData& data, const Taxels& taxels,
                 std::vector<double>& forces) {
  std::fill(forces.begin(), forces.end(), 0.0);
  for (int i = 0; i < data.ncon; ++i) {
    for (const int geom : contact_geoms(data.contact[i])) {
      const int taxel = taxel_of(taxels, geom);
      if (taxel < 0) continue;
      std::array<mjtNum, 6> force{};
      mj_contactForce(&model, &data, i, force.data());
      forces[static_cast<std::size_t>(taxel)] += force[0];
    }
  }
}

}  // namespace somato::detail
