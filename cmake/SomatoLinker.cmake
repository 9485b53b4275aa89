# clang's own linker, where it is installed: it takes a fifth of the time of that of binutils, which took 1 s of
# processors for each of thirty programs, and more with a sanitizer.
if(PROJECT_IS_TOP_LEVEL AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=lld SOMATO_HAS_LLD)
  if(SOMATO_HAS_LLD)
    add_link_options(-fuse-ld=lld)
  endif()
endif()
