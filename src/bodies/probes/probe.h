#pragma once

namespace somato::detail {

/// The probes that explore a material: one of them, or both in the same exploration.
enum class Probe { kTexture, kHardness, kBoth };

}  // namespace somato::detail
