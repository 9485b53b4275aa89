# Options of rooms that only the program and the tests use, and of the program.

# Where speed is irrelevant, a release is optimized little.
set(SOMATO_LITTLE_OPTIMIZATION $<$<CONFIG:Release>:-O1>)

# With tests, these rooms are not optimized at all except in a release: that would take longer than the
# tests of these rooms.
set(SOMATO_PROGRAM_OPTIMIZATION "")
if(SOMATO_BUILD_TESTS)
  set(SOMATO_PROGRAM_OPTIMIZATION $<$<NOT:$<CONFIG:Release>>:-O0>)
endif()
