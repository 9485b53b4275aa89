#include "bodies/sensors/stocked_exploration.h"

#include <utility>

#include "bodies/sensors/exploration_draws.h"

namespace somato {

Result<Exploration> as_thing(const Exploration& explored, const Object& object, std::size_t thing) {
  SOMATO_TRY(auto draws, detail::draws_of(explored));
  if (!draws) {
    return fail(ErrorKind::kUsage, "the exploration has no true values", {},
                "explore again with true_values = true in the table [simulation]");
  }
  draws->thing = thing;
  Exploration exploration = explored;
  exploration.labels = labels_of(object, draws->trial);
  detail::put_draws(*draws, exploration);
  return exploration;
}

}  // namespace somato
