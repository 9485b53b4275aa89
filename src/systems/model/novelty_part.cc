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
const std::string kWhitening = "novelty.whitening";

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

// None in files of earlier versions.
Result<Matrix<double>> whitening_from(const Archive& archive, std::size_t elements,
                                      const std::string& where) {
  if (archive.find(kWhitening) == nullptr) return Matrix<double>{};
  SOMATO_TRY(const auto found, archive.get<Array<double>>(kWhitening, where));
  if (found->shape != std::vector<std::uint64_t>{elements, elements}) {
    return damaged_model("'novelty.whitening' does not have the size of the map's inputs", where);
  }
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::all_of(found->values.begin(), found->values.end(), is_finite)) {
    return damaged_model("'novelty.whitening' contains a number that is not finite", where);
  }
  return Matrix<double>(elements, elements, found->values);
}

}  // namespace

void add_novelty(Archive& archive, const Novelty& novelty) {
  archive.add(kNovelty, parameters_to_toml(NoveltyPart{novelty}));
  archive.add(kScales, Array<double>{{novelty.scales.size()}, novelty.scales});
  if (novelty.whitening.empty()) return;
  const auto values = novelty.whitening.values();
  archive.add(kWhitening, Array<double>{{novelty.whitening.rows(), novelty.whitening.columns()},
                                        {values.begin(), values.end()}});
}

Result<std::optional<Novelty>> novelty_from(const Archive& archive, std::size_t classes,
                                            std::size_t elements, const std::string& where) {
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
  SOMATO_TRY(part.novelty.whitening, whitening_from(archive, elements, where));
  return std::optional(std::move(part.novelty));
}

}  // namespace somato
