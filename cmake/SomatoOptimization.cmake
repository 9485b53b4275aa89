# Options of the rooms without long loops, and of the program.

# Where speed is irrelevant, a release is optimized little.
set(SOMATO_LITTLE_OPTIMIZATION $<$<CONFIG:Release>:-O1>)

# For tests, these rooms are not optimized at all except in a release: that would take longer than the
# tests of these rooms.
option(SOMATO_BUILD_FOR_TESTS "Optimize only the rooms with long loops, except in a release" ${SOMATO_BUILD_TESTS})
set(SOMATO_OPTIMIZATION_OF_OTHERS "")
if(SOMATO_BUILD_FOR_TESTS)
  set(SOMATO_OPTIMIZATION_OF_OTHERS $<$<NOT:$<CONFIG:Release>>:-O0>)
endif()
