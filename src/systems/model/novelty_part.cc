#include "systems/model/novelty_part.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "maps/som/map_parts.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

const std::string kNovelty = "novelty";
const std::string kScales = "novelty.scales";

struct NoveltyPart {
  Novelty novelty;

  static const Declarations<NoveltyPart>& declarations() {
    using P = NoveltyPart;
    static const auto declared =
        Declarations<P>()
            .add(
                "false_alarm_rate", [](P& p) -> auto& { return p.novelty.false_alarm_rate; }, "",
                Range::between(0, 1), "Share of known explorations that may be refused.")
            .add(
                "samples", [](P& p) -> auto& { return p.novelty.samples; }, "", Range::at_least(1),
                "Held-out explorations.")
            .add(
                "threshold", [](P& p) -> auto& { return p.novelty.threshold; }, "", Range::above(0),
                "Threshold.");
    return declared;
  }
};

}  // namespace

void add_novelty(Archive& archive, const Novelty& novelty) {
  archive.add(kNovelty, parameters_to_toml(NoveltyPart{novelty}));
  archive.add(kScales, Array<double>{{novelty.scales.size()}, novelty.scales});
}

Result<std::optional<Novelty>> novelty_from(const Archive& archive, std::size_t classes,
                                            const std::string& where) {
  if (archive.find(kNovelty) == nullptr) return std::optional<Novelty>{};
  SOMATO_TRY(auto part, parameters_from<NoveltyPart>(archive, kNovelty, where));
  SOMATO_TRY(const auto scales, archive.get<Array<double>>(kScales, where));
  if (scales->shape != std::vector<std::uint64_t>{classes}) {
    return damaged_model("'novelty.scales' does not have a scale for each class", where);
  }
  const auto is_scale = [](double scale) { return std::isfinite(scale) && scale > 0.0; };
  if (!std::all_of(scales->values.begin(), scales->values.end(), is_scale)) {
    return damaged_model("a scale of 'novelty.scales' is not above 0", where);
  }
  part.novelty.scales = scales->values;
  return std::optional(std::move(part.novelty));
}

}  // namespace somato
