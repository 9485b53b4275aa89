# -DSOMATO_PROFILE=robot: the program for the computer of a robot (docs/embedding.md). It only sets defaults of the
# options, each of which can still be given.
set(SOMATO_PROFILE "" CACHE STRING "A set of defaults for the options: empty, or robot")
set_property(CACHE SOMATO_PROFILE PROPERTY STRINGS "" robot)
if(SOMATO_PROFILE STREQUAL "robot")
  foreach(part SIMULATION REPORT STUDIES IMPORTERS PAGES PYTHON MPI PROTOBUF)
    set(SOMATO_BUILD_${part} OFF CACHE BOOL "Off in the profile robot")
  endforeach()
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE MinSizeRel CACHE STRING "That of the profile robot" FORCE)
  endif()
  # Smaller than -Os by a quarter with clang; the kernels keep their own options.
  string(REPLACE "-Os" "-Oz" CMAKE_CXX_FLAGS_MINSIZEREL "${CMAKE_CXX_FLAGS_MINSIZEREL}")
  add_compile_options(-ffunction-sections -fdata-sections)
elseif(NOT SOMATO_PROFILE STREQUAL "")
  message(FATAL_ERROR "SOMATO_PROFILE=${SOMATO_PROFILE} is unknown: use robot, or leave it empty")
endif()

# somato_make_small(): options by which the linker drops functions that no command uses, and keeps one of several equal
# ones.
function(somato_make_small)
  include(CheckLinkerFlag)
  add_link_options(-Wl,--gc-sections -Wl,--as-needed)
  if(SOMATO_HAS_LLD)
    add_link_options(-Wl,--icf=safe)
  endif()
  check_linker_flag(CXX -Wl,-z,pack-relative-relocs SOMATO_HAS_RELATIVE_RELOCATIONS)
  if(SOMATO_HAS_RELATIVE_RELOCATIONS)
    add_link_options(-Wl,-z,pack-relative-relocs)
  endif()
endfunction()
