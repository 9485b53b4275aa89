#include "somato/maps/schedule.h"

#include "base/core/elementary.h"

namespace somato {

const std::vector<std::pair<ScheduleShape, std::string>>& Choices<ScheduleShape>::all() {
  static const std::vector<std::pair<ScheduleShape, std::string>> choices{
      {ScheduleShape::kConstant, "constant"},
      {ScheduleShape::kLinear, "linear"},
      {ScheduleShape::kExponential, "exponential"}};
  return choices;
}

double Schedule::at(std::uint64_t step) const {
  if (shape == ScheduleShape::kConstant) return start;
  if (step >= reached_at) return end;
  const double share = static_cast<double>(step) / static_cast<double>(reached_at);
  if (shape == ScheduleShape::kLinear) return start + share * (end - start);
  return start * power(end / start, share);
}

Result<void> Schedule::validate(const std::string& name) const {
  if (shape != ScheduleShape::kExponential || (start > 0.0 && end > 0.0)) return {};
  return fail(ErrorKind::kUsage,
              "an exponential schedule of the " + name + " cannot start or end at 0", {},
              "use a linear schedule, or values above 0");
}

}  // namespace somato
