# Options of the wings without long loops, and of the program.

# In a release they are optimized little: more takes a third of their compilation, 50 s of processors, and they call
# the wings with long loops for what takes long. For tests, they are not optimized at all except in a release: that
# would take longer than the tests of these wings.
option(SOMATO_BUILD_FOR_TESTS "Optimize only the wings with long loops, except in a release" ${SOMATO_BUILD_TESTS})
set(SOMATO_OPTIMIZATION_OF_OTHERS $<$<CONFIG:Release>:-O1>)
if(SOMATO_BUILD_FOR_TESTS)
  list(APPEND SOMATO_OPTIMIZATION_OF_OTHERS $<$<NOT:$<CONFIG:Release>>:-O0>)
endif()

# In a release the wings with long loops are compiled with -O2, kernels and maps with -O3: with g++ 12, -O3 takes 5 to 9 %
# more time for a group of sources, and their programs take as many instructions (bench/guard.py).
set(SOMATO_OPTIMIZATION_OF_LONG_LOOPS $<$<CONFIG:Release>:-O2>)
set(SOMATO_OPTIMIZATION_OF_KERNELS $<IF:$<CONFIG:Release>,-O3,-O2>)

# g++ 14 refuses precompiled headers that are optimized unlike their users: somato_headers serves
# the code that is optimized little, somato_optimized_headers the wings with long loops.

# somato_link_optimized_templates(PROGRAM): of the functions that several sources instantiate, a linker keeps the
# first. In a program whose first sources are not optimized, those of strings and vectors would not be either: an
# optimized source that instantiates all of them is the first. It halves the time of tests that write long texts.
function(somato_link_optimized_templates program)
  if(NOT SOMATO_BUILD_FOR_TESTS OR CMAKE_BUILD_TYPE STREQUAL "Release")
    return()
  endif()
  if(NOT TARGET standard_templates)
    add_library(standard_templates OBJECT ${PROJECT_SOURCE_DIR}/cmake/standard_templates.cc)
    target_compile_features(standard_templates PRIVATE cxx_std_20)
    target_include_directories(standard_templates PRIVATE ${PROJECT_SOURCE_DIR}/include)
  endif()
  add_dependencies(${program} standard_templates)
  target_link_options(${program} PRIVATE $<TARGET_OBJECTS:standard_templates>)
  set_property(TARGET ${program} APPEND PROPERTY LINK_DEPENDS $<TARGET_OBJECTS:standard_templates>)
endfunction()
