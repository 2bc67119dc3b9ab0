# `cpack` in a build folder of the preset `package` makes two Debian packages: microslip, and its libcontact, which
# replaces CONTACT's library and is not for everybody. tools/package makes and tries them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME microslip)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
string(REPLACE "-" "~" CPACK_DEBIAN_PACKAGE_VERSION ${MICROSLIP_VERSION}) # which Debian sorts before the release
set(CPACK_PACKAGE_CONTACT "The microslip authors <noreply@microslip.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
file(WRITE ${CMAKE_BINARY_DIR}/package/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_MICROSLIP_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/package/triggers)
set(CPACK_DEBIAN_LIBCONTACT_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/package/triggers)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

set(CPACK_DEBIAN_MICROSLIP_PACKAGE_NAME microslip)
set(CPACK_DEBIAN_MICROSLIP_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_MICROSLIP_PACKAGE_RECOMMENDS "python3-h5py, python3-jinja2, python3-matplotlib")
set(CPACK_DEBIAN_MICROSLIP_PACKAGE_SUGGESTS "g++, gfortran, pkg-config, weasyprint")
set(CPACK_DEBIAN_MICROSLIP_DESCRIPTION
"Forces, tractions and slip between two bodies that roll on each other, such as
wheel and rail: FASTSIM2 and Kalker's exact theory. Program, Python module,
libraries and headers for C++, C and Fortran, functional mock-up units.")

set(CPACK_DEBIAN_LIBCONTACT_PACKAGE_NAME microslip-libcontact)
set(CPACK_DEBIAN_LIBCONTACT_DESCRIPTION
"A shared library with the interface of CONTACT's (cntc_... and subs_...), with
its header and its module for Fortran.")

include(CPack)
cpack_add_component_group(microslip)
cpack_add_component_group(libcontact)
foreach(component Unspecified libraries program python)
  cpack_add_component(${component} GROUP microslip)
endforeach()
cpack_add_component(libcontact GROUP libcontact)

# As Debian wants its documents: compressed, a copyright and a changelog of its form for each package. The time is that of
# SOURCE_DATE_EPOCH where that is set.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  find_program(GZIP gzip REQUIRED)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  function(microslip_debian_documents package component)
    set(documents ${CMAKE_INSTALL_DATADIR}/doc/${package})
    set(made ${CMAKE_BINARY_DIR}/debian/${package})
    configure_file(packaging/debian/changelog.in ${made}/changelog @ONLY)
    configure_file(packaging/debian/lintian-overrides.in ${made}/${package} @ONLY)
    install(FILES packaging/debian/copyright CHANGELOG.md ${made}/changelog DESTINATION ${documents} COMPONENT ${component})
    install(FILES ${made}/${package} DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component})
    install(CODE "file(GLOB files \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${documents}/CHANGELOG.md\"
      \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${documents}/changelog\"
      \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/man/man1/*.1\")
      execute_process(COMMAND ${GZIP} -9nf \${files} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component})
  endfunction()
  microslip_debian_documents(microslip Unspecified)
  microslip_debian_documents(microslip-libcontact libcontact)
endif()
