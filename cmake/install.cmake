# What other projects need: libraries, headers, the CMake package and pkg-config files. `cmake --install BUILD --component
# libraries` installs just these.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS microslip EXPORT microslip_cxx COMPONENT libraries)
install(TARGETS microslip_c EXPORT microslip_c
  RUNTIME COMPONENT libraries LIBRARY COMPONENT libraries NAMELINK_COMPONENT libraries ARCHIVE COMPONENT libraries
  PUBLIC_HEADER COMPONENT libraries)
install(CODE "set(include_folder ${CMAKE_INSTALL_INCLUDEDIR})" COMPONENT libraries)
install(SCRIPT cmake/install_headers.cmake COMPONENT libraries)
install(FILES c/fortran/microslip.f90 DESTINATION ${CMAKE_INSTALL_DATADIR}/microslip/fortran COMPONENT libraries)
install(FILES c/mex/microslip.c DESTINATION ${CMAKE_INSTALL_DATADIR}/microslip/mex COMPONENT libraries)
install(DIRECTORY examples/profiles DESTINATION ${CMAKE_INSTALL_DATADIR}/microslip)
install(DIRECTORY examples/adapters DESTINATION ${CMAKE_INSTALL_DATADIR}/microslip USE_SOURCE_PERMISSIONS
  PATTERN tests EXCLUDE PATTERN __pycache__ EXCLUDE)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/microslip)
foreach(language cxx c)
  install(EXPORT microslip_${language} NAMESPACE microslip:: DESTINATION ${package} FILE microslip-${language}.cmake
    COMPONENT libraries)
endforeach()
configure_package_config_file(cmake/microslip-config.cmake.in ${CMAKE_BINARY_DIR}/package/microslip-config.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/microslip-config-version.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_BINARY_DIR}/package/microslip-config.cmake
  ${CMAKE_BINARY_DIR}/package/microslip-config-version.cmake DESTINATION ${package} COMPONENT libraries)

file(RELATIVE_PATH microslip_up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
foreach(name microslip microslip_c)
  configure_file(cmake/${name}.pc.in ${CMAKE_BINARY_DIR}/package/${name}.pc @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/package/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT libraries)
endforeach()
