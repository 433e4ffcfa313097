# cmake/WriteCommit.cmake in a repository of its own, changed, within another one, as an archive and without git; FOLDER is
# made anew. What it must write is known from git's own `rev-parse`.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/tree/cmake)
file(COPY ${SOURCE}/cmake/WriteCommit.cmake ${SOURCE}/cmake/commit DESTINATION ${FOLDER}/tree/cmake)
file(COPY ${SOURCE}/.gitattributes DESTINATION ${FOLDER}/tree)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(output "${output}" PARENT_SCOPE)
endfunction()
function(git)
  run(git -C ${FOLDER}/tree -c user.name=Test -c user.email=test@example.org ${ARGN})
  set(output "${output}" PARENT_SCOPE)
endfunction()
function(expect commit tree)
  run(${CMAKE_COMMAND} -D SOURCE=${tree} -D FILE=${FOLDER}/Commit.cpp -P ${tree}/cmake/WriteCommit.cmake)
  file(READ ${FOLDER}/Commit.cpp text)
  if(NOT text MATCHES "return \"${commit}\";")
    message(FATAL_ERROR "'${commit}' belongs into ${tree}:\n${text}")
  endif()
endfunction()

expect("" ${FOLDER}/tree)  # the build folder may lie within a repository; these sources are not of it
git(init --quiet)
git(add .)
git(commit --quiet -m first)
git(rev-parse --short=12 HEAD)
set(first ${output})
expect(${first} ${FOLDER}/tree)

file(TIMESTAMP ${FOLDER}/Commit.cpp before "%s")
execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 1.1)
expect(${first} ${FOLDER}/tree)
file(TIMESTAMP ${FOLDER}/Commit.cpp after "%s")
if(NOT before EQUAL after)
  message(FATAL_ERROR "the source was written although the commit is the same")
endif()

file(APPEND ${FOLDER}/tree/cmake/WriteCommit.cmake "# changed\n")
expect(${first}-changed ${FOLDER}/tree)

file(MAKE_DIRECTORY ${FOLDER}/tree/inner)
file(COPY ${SOURCE}/cmake DESTINATION ${FOLDER}/tree/inner)
expect("" ${FOLDER}/tree/inner)

git(archive --prefix=release/ -o ${FOLDER}/release.tar HEAD)
file(ARCHIVE_EXTRACT INPUT ${FOLDER}/release.tar DESTINATION ${FOLDER})
expect(${first} ${FOLDER}/release)
