#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "job.h"

namespace somato::bench {

/// Frames to learn: `t_mpsom`, on the map of P06's last system, or `t_mpsom_large`, on one of 100
/// times its neurons; nothing for another name. `scale` divides the frames.
std::unique_ptr<Job> make_t_mpsom_job(const std::string& name, std::size_t scale);

}  // namespace somato::bench
