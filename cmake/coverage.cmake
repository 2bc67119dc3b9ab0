# For tools/coverage, as CMAKE_PROJECT_TOP_LEVEL_INCLUDES: counts the lines and branches of the library, and of nothing else.
function(microslip_count_lines)
  foreach(target microslip microslip_kernels_baseline microslip_kernels_avx2 microslip_kernels_avx512)
    if(TARGET ${target})
      # optimised so little g++ 12 sees uninitialised values that are not there
      target_compile_options(${target} PRIVATE --coverage -fprofile-abs-path -O1 -Wno-maybe-uninitialized)
    endif()
  endforeach()
  target_link_options(microslip INTERFACE --coverage)
endfunction()
cmake_language(DEFER CALL microslip_count_lines)
