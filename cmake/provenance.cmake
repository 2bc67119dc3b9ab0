# The commit that a build was made from, asked again at every build, so that results can name it.
find_package(Git QUIET)
add_custom_target(microslip_provenance
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DGIT=${GIT_EXECUTABLE} -DVERSION=${MICROSLIP_VERSION}
    "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" -DBUILD_TYPE=${CMAKE_BUILD_TYPE}
    -DOUTPUT=${CMAKE_BINARY_DIR}/generated/microslip_build.hpp -P ${PROJECT_SOURCE_DIR}/cmake/write_provenance.cmake
  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/microslip_build.hpp
  COMMENT "Asking which commit this is")
