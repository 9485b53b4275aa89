#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "job.h"
#include "somato/maps/t_mpsom.h"

namespace somato::bench {

/// The map of P06's last system for `t_mpsom`, one of 100 times its neurons for `t_mpsom_large`;
/// nothing for another name. `scale` divides the iterations, one a frame.
std::optional<TMpsomParameters> t_mpsom_parameters(const std::string& name, std::size_t scale);

/// Learns frames, one after the other.
std::unique_ptr<Job> make_t_mpsom_job(const TMpsomParameters& parameters);

}  // namespace somato::bench
