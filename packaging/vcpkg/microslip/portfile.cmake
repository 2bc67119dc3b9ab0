# An overlay port: vcpkg install microslip[program] --overlay-ports=FOLDER
vcpkg_download_distfile(archive
  URLS "@URL@" FILENAME "microslip-@VERSION@.tar.gz" SHA512 @SHA512@)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${archive}")
vcpkg_check_features(OUT_FEATURE_OPTIONS options FEATURES program MICROSLIP_BUILD_APP)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${options} -DMICROSLIP_BUILD_PYTHON=OFF -DMICROSLIP_BUILD_LIBCONTACT=OFF -DMICROSLIP_BUILD_TESTS=OFF
    -DMICROSLIP_BUILD_BENCH=OFF -DMICROSLIP_MPI=OFF
  MAYBE_UNUSED_VARIABLES MICROSLIP_MPI)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/microslip)
vcpkg_fixup_pkgconfig()
if("program" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES microslip microslip-validate AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
