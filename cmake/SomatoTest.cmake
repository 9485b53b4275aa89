# How tests are built and registered. A group of tests is a wing (src/rooms.json) or a folder of tests. Each test
# has the label of its group, and each group a target GROUP_group, so that './dev test GROUP' builds and runs its
# tests. The cases of a room are one test, GROUP.ROOM, with the label GROUP/ROOM too, and so have others of the room,
# GROUP.ROOM.NAME; tests that only './dev test --all' runs have the label 'long'.

# Each room writes the durations of its cases to test_cases/, and each test its processor time to test_times/,
# which scripts/budget.py compares with the budget.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/test_cases ${PROJECT_BINARY_DIR}/test_times)

# somato_group(GROUP TARGET...): the tests of the group need these targets.
function(somato_group group)
  if(NOT TARGET ${group}_group)
    add_custom_target(${group}_group)
  endif()
  foreach(target IN LISTS ARGN)
    add_dependencies(${group}_group ${target})
  endforeach()
endfunction()

# somato_test(GROUP NAME [LONG] [DEPENDS TARGET...] COMMAND...): the time limit only ends a test that hangs, on
# machines of any speed.
function(somato_test group name)
  cmake_parse_arguments(PARSE_ARGV 2 test "LONG" "" "DEPENDS;COMMAND")
  set(labels ${group})
  if(name MATCHES "^([^.]+)[.]")
    list(APPEND labels ${group}/${CMAKE_MATCH_1})
  endif()
  if(test_LONG)
    list(APPEND labels long)
  endif()
  # A target is replaced by its file only as the first word of a command.
  list(POP_FRONT test_COMMAND program)
  if(TARGET ${program})
    set(program ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:${program}>)
  endif()
  add_test(NAME ${group}.${name} COMMAND ${PROJECT_SOURCE_DIR}/scripts/with_processor_time.sh
           ${PROJECT_BINARY_DIR}/test_times/${group}.${name} ${program} ${test_COMMAND})
  set_tests_properties(${group}.${name} PROPERTIES TIMEOUT 3600 LABELS "${labels}")
  somato_group(${group} ${test_DEPENDS})
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

# somato_test_program(GROUP [NAME PROGRAM] SOURCES SOURCE... [LINK LIBRARY...]): a program with the tests in the
# folders of the group, tests/GROUP/ROOM. Each room is a test of its own (tests/base/support/room_main.cc).
function(somato_test_program group)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "NAME" "SOURCES;LINK")
  set(sources ${test_SOURCES})
  set(arguments --gtest_brief=1)
  if(SOMATO_SANITIZE STREQUAL "thread")
    somato_keep_threaded(sources)
    list(APPEND arguments "--gtest_filter=*Thread*:*thread*")
  endif()
  if(NOT sources)
    return()
  endif()
  set(program ${group}_tests)
  if(test_NAME)
    set(program ${test_NAME})
  endif()
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE test_support ${test_LINK})
  target_compile_options(${program} PRIVATE -O0 -ffp-contract=off)
  somato_link_optimized_templates(${program})
  somato_set_warnings(${program})
  somato_use_precompiled(${program} test_headers)
  somato_compile_together(${program})
  set(rooms ${sources})
  list(TRANSFORM rooms REPLACE "^.*/([^/]+)/[^/]+$" "\\1")
  list(REMOVE_DUPLICATES rooms)
  foreach(room IN LISTS rooms)
    somato_test(${group} ${room} DEPENDS ${program} COMMAND ${program} ${arguments})
    set_tests_properties(${group}.${room} PROPERTIES COST 200 LABELS "${group};${group}/${room}" ENVIRONMENT
      "SOMATO_TEST_ROOM=${group}/${room};\
GTEST_OUTPUT=json:${PROJECT_BINARY_DIR}/test_cases/${group}.${room}.json")
  endforeach()
endfunction()
