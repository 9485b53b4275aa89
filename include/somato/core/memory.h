#pragma once

#include <cstddef>

namespace somato {

/// The working memory that the machine has, in bytes, however much of it is in use; the largest
/// number where that is not known.
std::size_t memory_of_machine();

}  // namespace somato
