# The headers that nearly every source includes, compiled once: reading them costs more than the rest
# of a typical file. Sources still include what they use: clang-tidy reads each of them without.
set(SOMATO_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map>
    <memory> <optional> <span> <string> <string_view> <utility> <variant> <vector> <fmt/format.h>
    <fmt/ranges.h> <tl/expected.hpp>)

# somato_precompile(TARGET HEADER...): its own precompiled headers, with HEADERs beyond the common ones.
function(somato_precompile target)
  target_precompile_headers(${target} PRIVATE ${SOMATO_COMMON_HEADERS} ${ARGN})
  # Instantiates templates once in the header instead of once in each source.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:Clang>:-fpch-instantiate-templates>)
endfunction()

# somato_precompiled_as(TARGET OTHER): the precompiled headers of OTHER, which is compiled alike.
function(somato_precompiled_as target other)
  target_precompile_headers(${target} REUSE_FROM ${other})
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:Clang>:-fpch-instantiate-templates>)
endfunction()
