// The containers that most sources use, optimized (cmake/SomatoOptimization.cmake).

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "somato/core/matrix.h"

template class std::basic_string<char>;
template class std::vector<std::string>;
template class std::vector<char>;
template class std::vector<std::byte>;
template class std::vector<std::uint8_t>;
template class std::vector<int>;
template class std::vector<std::size_t>;
template class std::vector<float>;
template class std::vector<double>;
template class std::vector<float, somato::detail::CacheLineAllocator<float>>;
template class std::vector<double, somato::detail::CacheLineAllocator<double>>;
