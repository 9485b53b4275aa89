#include "bodies/hands/hand_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "bodies/hands/png.h"
#include "bodies/hands/ray_picture.h"
#include "bodies/hands/simulated_hand_impl.h"

namespace somato {
namespace {

constexpr detail::Colour kTouched{0.85F, 0.1F, 0.1F};
constexpr double kFelt = 0.05;  // N

std::vector<detail::Tint> touched_taxels(const SimulatedHand::Impl& impl) {
  std::vector<detail::Tint> tints;
  const auto& taxel_of_geom = impl.scene->taxels.taxel_of_geom;
  for (std::size_t geom = 0; geom < taxel_of_geom.size(); ++geom) {
    const int taxel = taxel_of_geom[geom];
    if (taxel < 0 || impl.forces[static_cast<std::size_t>(taxel)] < kFelt) continue;
    tints.push_back({static_cast<int>(geom), kTouched});
  }
  return tints;
}

// A name may hold what would lead into another folder.
std::string picture_file(const std::string& folder, std::string thing, std::size_t trial,
                         std::size_t grasp) {
  std::replace(thing.begin(), thing.end(), '/', '_');
  const std::string name = fmt::format("{}-{}-{}.png", thing, trial + 1, grasp + 1);
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace

Result<void> save_hand_picture(const SimulatedHand& hand, const std::string& path) {
  const SimulatedHand::Impl& impl = hand.impl();
  return detail::ray_picture(*impl.scene->model, *impl.data, {}, touched_taxels(impl))
      .and_then([&](const detail::Image& image) { return detail::write_png(path, image); });
}

void GraspPictures::save(const SimulatedHand& hand, const std::string& thing, std::size_t trial,
                         std::size_t grasp) {
  auto saved = save_hand_picture(hand, picture_file(folder_, thing, trial, grasp));
  if (saved) return;
  const std::scoped_lock lock(mutex_);
  ++lost_;
  if (!first_error_) first_error_ = std::move(saved.error());
}

}  // namespace somato
