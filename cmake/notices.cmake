# The copyright notices and licences of the libraries that the program has compiled in (docs/licences.md), as Debian's
# packages of them tell: installed as NOTICES. Boost's asks for none in binaries. On other systems whoever hands out binaries adds what theirs tell.
set(notices "")
foreach(library libcli11-dev libcsv-dev libfmt-dev libhdf5-dev libjemalloc-dev libtomlplusplus-dev
    nlohmann-json3-dev pybind11-dev)
  set(file /usr/share/doc/${library}/copyright)
  if(EXISTS ${file})
    file(READ ${file} text)
    string(APPEND notices "==== ${library} ====\n\n${text}\n")
  endif()
endforeach()
if(notices AND MICROSLIP_BUILD_APP)
  include(GNUInstallDirs)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/package/NOTICES CONTENT "${notices}" @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/package/NOTICES DESTINATION ${CMAKE_INSTALL_DATADIR}/microslip COMPONENT program)
endif()
