# How tests are built and registered. Each test has the label of its room, and each room a target
# ROOM_room, so that './dev test ROOM' builds and runs its tests; tests that only './dev test --all'
# runs have the label 'long' too.

# A room's cases run in this many processes; each writes the durations of its cases to test_cases/, and
# each test its processor time to test_times/, which scripts/budget.py compares with the budget.
set(SOMATO_TEST_SHARDS 2)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/test_cases ${PROJECT_BINARY_DIR}/test_times)

function(somato_room room)
  if(NOT TARGET ${room}_room)
    add_custom_target(${room}_room)
  endif()
  foreach(target IN LISTS ARGN)
    add_dependencies(${room}_room ${target})
  endforeach()
endfunction()

# somato_test(ROOM NAME [LONG] [DEPENDS TARGET...] COMMAND...): the time limit only ends a test that hangs, on
# machines of any speed.
function(somato_test room name)
  cmake_parse_arguments(PARSE_ARGV 2 test "LONG" "" "DEPENDS;COMMAND")
  set(labels ${room})
  if(test_LONG)
    list(APPEND labels long)
  endif()
  # A target is replaced by its file only as the first word of a command.
  list(POP_FRONT test_COMMAND program)
  if(TARGET ${program})
    set(program $<TARGET_FILE:${program}>)
  endif()
  add_test(NAME ${room}.${name} COMMAND ${PROJECT_SOURCE_DIR}/scripts/with_processor_time.sh
           ${PROJECT_BINARY_DIR}/test_times/${room}.${name} ${program} ${test_COMMAND})
  set_tests_properties(${room}.${name} PROPERTIES TIMEOUT 3600 LABELS "${labels}")
  somato_room(${room} ${test_DEPENDS})
endfunction()

# Under the thread sanitizer only the tests with "Thread" in their names run: files without one are not
# built.
function(somato_keep_threaded list)
  set(kept)
  foreach(source IN LISTS ${list})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(STRINGS ${source} threaded REGEX "TEST.*[Tt]hread" LIMIT_COUNT 1)
    if(threaded)
      list(APPEND kept ${source})
    endif()
  endforeach()
  set(${list} ${kept} PARENT_SCOPE)
endfunction()

# somato_test_program(ROOM SOURCE...): the program ROOM_tests, registered in shards.
function(somato_test_program room)
  set(sources ${ARGN})
  set(arguments --gtest_brief=1)
  if(SOMATO_SANITIZE STREQUAL "thread")
    somato_keep_threaded(sources)
    list(APPEND arguments "--gtest_filter=*Thread*:*thread*")
  endif()
  if(NOT sources)
    return()
  endif()
  set(program ${room}_tests)
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE test_support GTest::gtest_main)
  target_compile_options(${program} PRIVATE -O0 -ffp-contract=off)
  somato_link_optimized_templates(${program})
  somato_set_warnings(${program})
  somato_use_precompiled(${program} test_headers)
  somato_compile_together(${program})
  math(EXPR last "${SOMATO_TEST_SHARDS} - 1")
  foreach(shard RANGE ${last})
    somato_test(${room} ${shard} DEPENDS ${program}
                COMMAND ${program} ${arguments})
    set_tests_properties(${room}.${shard} PROPERTIES COST 200 ENVIRONMENT
      "GTEST_TOTAL_SHARDS=${SOMATO_TEST_SHARDS};GTEST_SHARD_INDEX=${shard};\
GTEST_OUTPUT=json:${PROJECT_BINARY_DIR}/test_cases/${room}.${shard}.json")
  endforeach()
endfunction()
