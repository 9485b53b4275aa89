# With ccache, a source is compiled once for all checkouts and builds of the same user: paths are relative
# to the checkout, and precompiled headers count by their content. Without ccache nothing changes.
option(SOMATO_COMPILER_CACHE "Use ccache where it is installed" ON)
find_program(SOMATO_CCACHE ccache)
if(SOMATO_COMPILER_CACHE AND SOMATO_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${PROJECT_SOURCE_DIR}/cmake/cached_compiler.sh ${SOMATO_CCACHE}
      ${PROJECT_SOURCE_DIR})
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)  # the cache needs it with g++
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # The cache knows the paths of these options only if they are not behind -Xclang.
    set(CMAKE_CXX_COMPILE_OPTIONS_USE_PCH -include-pch <PCH_FILE>)
  endif()
endif()

# Paths in messages, and of debuggers, are relative to the checkout.
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)
