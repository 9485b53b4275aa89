# The headers that nearly every source includes, compiled once: reading them costs more than the rest
# of a typical file. Sources still include what they use: './dev lint' reads each changed one without.
set(SOMATO_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map>
    <memory> <optional> <span> <string> <string_view> <utility> <variant> <vector> <fmt/format.h>
    <fmt/ranges.h> <tl/expected.hpp> <nlohmann/json.hpp>)

# somato_precompiled_headers(TARGET HEADER...): an object library with them and additional HEADERs. It is
# compiled like its users, but without their own definitions: g++ refuses precompiled headers with a
# definition that a source does not have.
function(somato_precompiled_headers target)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${target}.cc CONTENT "")
  add_library(${target} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${target}.cc)
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_link_libraries(${target} PRIVATE fmt::fmt tl::expected nlohmann_json::nlohmann_json Threads::Threads)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  somato_set_warnings(${target})
  target_precompile_headers(${target} PRIVATE ${SOMATO_COMMON_HEADERS} ${ARGN})
  somato_instantiate_once(${target})
endfunction()

# somato_use_precompiled(TARGET HEADERS): TARGET is compiled with the precompiled headers HEADERS.
function(somato_use_precompiled target headers)
  target_precompile_headers(${target} REUSE_FROM ${headers})
  somato_instantiate_once(${target})
endfunction()

# clang instantiates templates in the precompiled headers instead of in each source.
function(somato_instantiate_once target)
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:Clang>:-fpch-instantiate-templates>)
endfunction()
