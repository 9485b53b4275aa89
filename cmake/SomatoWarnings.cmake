# Warnings for targets of this project, not for users of the library.
option(SOMATO_WARNINGS_AS_ERRORS "Treat compiler warnings of Somato's own code as errors" OFF)

function(somato_set_warnings target)
  # The second line and the clang one replace checks that .clang-tidy disables.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -Wpedantic
                                           -Wredundant-decls -Wzero-as-null-pointer-constant
                                           $<$<CXX_COMPILER_ID:Clang>:-Wreserved-identifier>)
  # g++ 12 warns at -O3 of std::string's own code (its bugs 105329 and 105651).
  target_compile_options(${target} PRIVATE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>)
  # clang treats sources that are compiled together as headers.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  if(SOMATO_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
