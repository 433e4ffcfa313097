# What is installed beside the programs: resources, texts, manual, man pages and shell completion, and for the studio
# what a desktop wants to know of it.
set(resources share/squat-studio)
install(DIRECTORY resources/ DESTINATION ${resources}
  PATTERN desktop EXCLUDE PATTERN __pycache__ EXCLUDE PATTERN "*.sh" EXCLUDE)
install(PROGRAMS resources/examples/evaluate.sh DESTINATION ${resources}/examples)
install(FILES CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE README.md DESTINATION share/doc/squat-studio)

set(programs squat)
if(SQUAT_GRAPHICS)
  list(APPEND programs squat-studio)
endif()
set(files)
foreach(program IN LISTS programs)
  list(APPEND files $<TARGET_FILE:${program}>)
endforeach()
set(pages ${CMAKE_BINARY_DIR}/pages)
add_custom_command(OUTPUT ${pages}/made
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${pages}
  COMMAND ${CMAKE_COMMAND} -E env QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8 $<TARGET_FILE:squat_pages> ${pages} ${files}
  COMMAND sh -c "gzip -9n '${pages}'/man1/*.1"
  COMMAND ${CMAKE_COMMAND} -E touch ${pages}/made
  DEPENDS squat_pages ${programs} VERBATIM
  COMMENT "Man pages, shell completion and reference pages from the programs' own help and table of parameters")
if(SQUAT_SANITIZERS OR CMAKE_CROSSCOMPILING)
  add_custom_target(pages DEPENDS ${pages}/made)  # nobody installs these programs, or they do not start here
else()
  add_custom_target(pages ALL DEPENDS ${pages}/made)
endif()
install(DIRECTORY ${pages}/man1 DESTINATION share/man)
install(DIRECTORY ${pages}/completions DESTINATION share/bash-completion)
install(DIRECTORY ${pages}/manual DESTINATION ${resources})

# The manual as one HTML file, its reference pages included.
if(TARGET squat_manual)
  set(html ${CMAKE_BINARY_DIR}/manual/squat-studio.html)
  file(GLOB texts CONFIGURE_DEPENDS resources/manual/*.md resources/studies/*.md resources/pictures/*.png
    resources/examples/*)
  add_custom_command(OUTPUT ${html}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/manual
    COMMAND squat_manual ${PROJECT_SOURCE_DIR}/resources/manual/README.md ${pages}/manual ${html}
    DEPENDS squat_manual ${pages}/made ${texts} CHANGELOG.md CONTRIBUTING.md VERBATIM
    COMMENT "Manual as one HTML file")
  if(SQUAT_SANITIZERS OR CMAKE_CROSSCOMPILING)
    add_custom_target(manual DEPENDS ${html})
  else()
    add_custom_target(manual ALL DEPENDS ${html})
  endif()
  add_dependencies(manual pages)
  install(FILES ${html} DESTINATION share/doc/squat-studio)
else()
  add_custom_target(manual
    COMMAND ${CMAKE_COMMAND} -E echo
      "The HTML manual needs md4c (Debian: libmd4c-dev, libmd4c-html0-dev): ./bootstrap packages, then configure again"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()

if(SQUAT_GRAPHICS)
  # The releases are those of the changelog: "## [0.2.0] - 2026-11-24".
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CHANGELOG.md)
  file(STRINGS CHANGELOG.md headings REGEX "^## \\[[0-9.]+\\] - [0-9-]+$")
  set(releases "")
  foreach(heading IN LISTS headings)
    string(REGEX REPLACE "^## \\[(.+)\\] - (.+)$" "    <release version=\"\\1\" date=\"\\2\"/>\n" release "${heading}")
    string(APPEND releases "${release}")
  endforeach()
  configure_file(resources/desktop/squat-studio.metainfo.xml.in squat-studio.metainfo.xml @ONLY)
  install(FILES resources/icons/squat-studio.svg DESTINATION share/icons/hicolor/scalable/apps)
  install(FILES resources/desktop/squat-studio.desktop DESTINATION share/applications)
  install(FILES resources/desktop/squat-studio.xml DESTINATION share/mime/packages)
  install(FILES ${CMAKE_BINARY_DIR}/squat-studio.metainfo.xml DESTINATION share/metainfo)
endif()
