# Where ccache is installed, what was compiled before is taken over, in other clones, too: paths below the source are relative
# to it, and precompiled headers count by their contents.
find_program(MICROSLIP_CCACHE ccache)
mark_as_advanced(MICROSLIP_CCACHE)
if(MICROSLIP_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT EMSCRIPTEN)
  foreach(language C CXX)
    if(NOT CMAKE_${language}_COMPILER_LAUNCHER)
      set(CMAKE_${language}_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros ${MICROSLIP_CCACHE})
    endif()
  endforeach()
endif()
