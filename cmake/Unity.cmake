# Unity builds. Most of what a source costs to compile is its headers, and the code that their templates make: the
# sources of a folder are therefore compiled as one, where CMAKE_UNITY_BUILD is on (all presets but `lint`, which reads
# each source by itself so that a missing include is found).
#
# squat_sources(TARGET a.cpp b.cpp ... [ALONE c.cpp ...] [UNITS n])
#   Adds sources; those of one folder are compiled as n units (1). ALONE: sources that need settings of their own.
function(squat_sources target)
  cmake_parse_arguments(ARG "" "UNITS" "ALONE" ${ARGN})
  if(NOT ARG_UNITS)
    set(ARG_UNITS 1)
  endif()
  set(sources ${ARG_UNPARSED_ARGUMENTS})
  target_sources(${target} PRIVATE ${sources} ${ARG_ALONE})
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  list(LENGTH sources count)
  set(index 0)
  foreach(source IN LISTS sources)
    math(EXPR unit "${index} * ${ARG_UNITS} / ${count}")
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    cmake_path(GET path PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(REPLACE "/" "_" group ${folder})
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group}_${unit})
    math(EXPR index "${index} + 1")
  endforeach()
  set_source_files_properties(${ARG_ALONE} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
