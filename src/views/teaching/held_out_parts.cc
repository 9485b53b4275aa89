#include "views/teaching/held_out_parts.h"

#include <algorithm>
#include <map>

#include "somato/maps/novelty.h"

namespace somato::live {

std::vector<HeldOutPart> held_out_parts(const std::vector<std::size_t>& class_of, std::size_t parts,
                                        double false_alarm_rate) {
  std::map<std::size_t, std::size_t> counts;
  std::vector<std::size_t> part_of;
  part_of.reserve(class_of.size());
  for (const std::size_t one : class_of) part_of.push_back(counts[one]++ % parts);
  const bool has_single =
      std::any_of(counts.begin(), counts.end(), [](const auto& one) { return one.second < 2; });
  if (has_single || !check_scores(class_of.size(), false_alarm_rate)) return {};
  std::vector<HeldOutPart> divided(parts);
  for (std::size_t i = 0; i < class_of.size(); ++i) {
    for (std::size_t part = 0; part < parts; ++part) {
      (part_of[i] == part ? divided[part].held_out : divided[part].training).push_back(i);
    }
  }
  std::erase_if(divided, [](const HeldOutPart& part) { return part.held_out.empty(); });
  return divided;
}

}  // namespace somato::live
