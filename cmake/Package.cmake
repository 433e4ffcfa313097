# Debian packages by CPack. Two that take each other's place, since figures bring Qt and VTK and 200 packages with them:
#   squat-studio     the studio, and squat with figures        (preset release)
#   squat-headless   squat alone, for servers: ten libraries   (preset headless)
set(SQUAT_PACKAGE_CONTACT "The Squat Studio developers <developers@squat-studio.invalid>" CACHE STRING
  "Maintainer of the Debian package: name and address")
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # a package needs no tests: ./bootstrap package builds what it holds
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${SQUAT_PACKAGE_CONTACT})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_OUTPUT_FILE_PREFIX ${CMAKE_BINARY_DIR}/package)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# The system that it was built for, which its libraries tie it to: that of the next Debian takes its place there.
cmake_host_system_information(RESULT system QUERY DISTRIB_INFO)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
if(system_ID STREQUAL debian AND system_VERSION_ID)
  string(APPEND CPACK_DEBIAN_PACKAGE_RELEASE "+deb${system_VERSION_ID}")
endif()
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(about "A squat is a short rolling-contact-fatigue defect on the top of a rail. The
program squat rolls a wheel over it with a three-dimensional explicit
finite-element model and computes the axle box acceleration (ABA): time
history, power spectral density, wavelet scalogram.
")
if(SQUAT_GRAPHICS)
  set(CPACK_PACKAGE_NAME squat-studio)
  set(other squat-headless)
  # What is not linked but loaded: fonts, Qt's reader of icons, the renderer where there is no display.
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, libegl-mesa0, libgl1-mesa-dri, libqt6svg6")
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "bash-completion, shared-mime-info")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "axle box acceleration at defects of a rail: studio and command line")
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "${about}
This package holds the desktop program squat-studio and the command line with
figures; squat-headless is the command line for servers.")
else()
  set(CPACK_PACKAGE_NAME squat-headless)
  set(other squat-studio)
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS bash-completion)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "axle box acceleration at defects of a rail: command line for servers")
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "${about}
This package holds the command line without figures; squat-studio draws them.")
endif()
set(CPACK_DEBIAN_PACKAGE_CONFLICTS ${other})
set(CPACK_DEBIAN_PACKAGE_REPLACES ${other})
install(FILES cmake/copyright DESTINATION share/doc/${CPACK_PACKAGE_NAME})
include(CPack)
