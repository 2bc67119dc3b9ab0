# Projects that use microslip as it is installed: with find_package, from C++ and from C alone, and with pkg-config.
set(prefix ${CMAKE_BINARY_DIR}/consumer/prefix)
set(folder ${CMAKE_BINARY_DIR}/consumer)
add_test(NAME consumer_install
  COMMAND ${CMAKE_COMMAND} --install ${CMAKE_BINARY_DIR} --prefix ${prefix} --component libraries)
set_tests_properties(consumer_install PROPERTIES FIXTURES_SETUP installed)

set(compilers -G ${CMAKE_GENERATOR} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DCMAKE_C_COMPILER=${CMAKE_C_COMPILER}
  -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_C_FLAGS=${CMAKE_CXX_FLAGS} -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS})
set(find_package sh ${CMAKE_CURRENT_LIST_DIR}/find_package.sh ${prefix})
add_test(NAME consumer_find_package
  COMMAND ${find_package} ${CMAKE_CURRENT_LIST_DIR} ${folder}/cxx consumer ${compilers})
add_test(NAME consumer_find_package_c
  COMMAND ${find_package} ${CMAKE_CURRENT_LIST_DIR}/c ${folder}/c consumer ${compilers}
    -DSOURCE=${PROJECT_SOURCE_DIR}/examples/c/first_contact.c)
add_test(NAME consumer_wheelset
  COMMAND ${find_package} ${PROJECT_SOURCE_DIR}/examples/wheelset ${folder}/wheelset wheelset ${compilers})
if(Simbody_FOUND)
  add_test(NAME consumer_vehicle
    COMMAND ${find_package} ${PROJECT_SOURCE_DIR}/examples/vehicle ${folder}/vehicle rolling_bodies ${compilers})
  set_tests_properties(consumer_vehicle PROPERTIES FIXTURES_REQUIRED installed)
endif()
# A sanitizer's run time must come first, which gfortran does not see to.
set(fortran ${CMAKE_Fortran_COMPILER})
if(CMAKE_CXX_FLAGS MATCHES sanitize)
  set(fortran "")
endif()
add_test(NAME consumer_pkg_config
  COMMAND sh ${CMAKE_CURRENT_LIST_DIR}/pkg_config.sh ${prefix} ${PROJECT_SOURCE_DIR} ${folder}/pkg_config
    "${CMAKE_CXX_COMPILER} ${CMAKE_CXX_FLAGS}" "${CMAKE_C_COMPILER} ${CMAKE_CXX_FLAGS}" ${fortran})
set_tests_properties(consumer_find_package consumer_find_package_c consumer_wheelset consumer_pkg_config PROPERTIES
  FIXTURES_REQUIRED installed)
