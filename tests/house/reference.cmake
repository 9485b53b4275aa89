# A page of docs/reference is what the program prints.
# -DPROGRAM=FILE -DWORDS="WORD WORD..." -DPAGE=FILE
separate_arguments(words UNIX_COMMAND "${WORDS}")
execute_process(COMMAND ${PROGRAM} ${words} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "'${PROGRAM} ${WORDS}' failed: ${status}")
endif()
file(READ ${PAGE} page)
if(NOT printed STREQUAL page)
  message(FATAL_ERROR "${PAGE} is not what the program prints.\n"
    "Make it anew: build/release/somato ${WORDS} > ${PAGE}")
endif()
