# Unity builds. Most of what a source costs to compile is its headers, and the code that their templates make: sources of
# a folder are therefore compiled as one, where CMAKE_UNITY_BUILD is on (all presets but `lint` and `separate`, which
# read each source by itself so that a missing include is found).
#
# squat_sources(TARGET a.cpp b.cpp ... [UNITS n | UNIT name] [ALONE c.cpp ...])
#   Adds sources; those of one folder are compiled as one unit, or as n. UNIT: a unit of this name apart from the
#   folder's others, for sources that a change elsewhere compiles again when the others need not be. ALONE: sources that
#   need settings of their own.
function(squat_sources target)
  cmake_parse_arguments(ARG "" "UNIT;UNITS" "ALONE" ${ARGN})
  if(NOT ARG_UNITS)
    set(ARG_UNITS 1)
  endif()
  set(sources ${ARG_UNPARSED_ARGUMENTS})
  target_sources(${target} PRIVATE ${sources} ${ARG_ALONE})
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  list(LENGTH sources count)
  set(index 0)
  foreach(source IN LISTS sources)
    set(unit ${ARG_UNIT})
    if(NOT unit)
      math(EXPR unit "${index} * ${ARG_UNITS} / ${count}")
    endif()
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    cmake_path(GET path PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(REPLACE "/" "_" group ${folder})
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group}_${unit})
    math(EXPR index "${index} + 1")
  endforeach()
  set_source_files_properties(${ARG_ALONE} TARGET_DIRECTORY ${target} PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()
