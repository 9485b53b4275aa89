# Run by cpack between installing and packing: what only packages of Debian want, in each of their folders below
# CPACK_TEMPORARY_DIRECTORY. The same tree gives the same bytes: times are those of the last commit.
set(names_program somato)
set(names_library ${CPACK_SOMATO_LIBRARY})
set(names_development libsomato-dev)
set(source ${CPACK_SOMATO_SOURCE})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

execute_process(COMMAND date --utc --rfc-email "--date=@$ENV{SOURCE_DATE_EPOCH}" OUTPUT_VARIABLE date
                OUTPUT_STRIP_TRAILING_WHITESPACE)

# write_changelogs(FOLDER)
function(write_changelogs folder)
  file(WRITE ${folder}/changelog.Debian "somato (${CPACK_SOMATO_VERSION}) ${CPACK_SOMATO_SUITE}; urgency=medium

  * Packed by 'cpack' from the source tree; changelog.gz lists what changed.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  file(COPY_FILE ${source}/CHANGELOG.md ${folder}/changelog)
  run(gzip --best --no-name --force ${folder}/changelog.Debian ${folder}/changelog)
endfunction()

foreach(group program library development)
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${group})
  set(name ${names_${group}})
  set(folder ${root}/usr/share/doc/${name})
  file(MAKE_DIRECTORY ${folder})
  write_changelogs(${folder})
  file(COPY_FILE ${source}/packaging/debian/copyright ${folder}/copyright)
  set(overrides ${source}/packaging/debian/${group}.lintian-overrides)
  if(EXISTS ${overrides})
    file(MAKE_DIRECTORY ${root}/usr/share/lintian/overrides)
    file(COPY_FILE ${overrides} ${root}/usr/share/lintian/overrides/${name})
  endif()
  file(GLOB pages ${root}/usr/share/man/man*/*[0-9])
  if(pages)
    run(gzip --best --no-name --force ${pages})
  endif()
  # Links and scripts keep their permissions; everything else is a file that all may read.
  run(chmod -R go-w,a+rX ${root})
endforeach()

# Completions of zsh are in a folder of Debian's own.
set(completions ${CPACK_TEMPORARY_DIRECTORY}/program/usr/share/zsh)
file(MAKE_DIRECTORY ${completions}/vendor-completions)
file(RENAME ${completions}/site-functions/_somato ${completions}/vendor-completions/_somato)
file(REMOVE_RECURSE ${completions}/site-functions)
