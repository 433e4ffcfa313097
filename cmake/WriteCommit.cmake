# Writes FILE, the one source that knows the commit of the sources in SOURCE; leaves it alone where it says so already, so
# that nothing is compiled or linked again. Without git, or in an archive that `git archive` made: what cmake/commit says.
set(commit "")
file(READ ${SOURCE}/cmake/commit archived)
string(STRIP "${archived}" archived)
if(archived MATCHES "^[0-9a-f]+$")
  string(SUBSTRING ${archived} 0 12 commit)
else()
  find_program(GIT git)
  # A folder within somebody else's repository is not of its commits.
  execute_process(COMMAND ${GIT} rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  file(REAL_PATH ${SOURCE} source)
  if(GIT AND failed EQUAL 0 AND top STREQUAL source)
    set(ENV{GIT_OPTIONAL_LOCKS} 0)
    execute_process(COMMAND ${GIT} describe --always --exclude=* --abbrev=12 --dirty=-changed
      WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
endif()
set(text "// Written by cmake/WriteCommit.cmake.
#include \"core/ProgramVersion.h\"

const char* squat::programCommit() { return \"${commit}\"; }
")
set(written "")
if(EXISTS ${FILE})
  file(READ ${FILE} written)
endif()
if(NOT text STREQUAL written)
  file(WRITE ${FILE} "${text}")
endif()
