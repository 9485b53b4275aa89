# Warnings for our own targets, never for those who use the library.
option(SOMATO_WARNINGS_AS_ERRORS "Treat compiler warnings of Somato's own code as errors" OFF)

function(somato_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -Wpedantic)
  if(SOMATO_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
