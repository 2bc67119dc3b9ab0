# Headers of other libraries that most sources of a target include, parsed once for all of them. None of ours: a change
# of theirs must not compile everything anew.
function(microslip_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  # So that compiler caches see what they hold. With precompiled headers g++ 12 sees copies of impossible sizes in
  # std::string that are not there.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess -Wno-stringop-overflow -Wno-array-bounds>)
endfunction()
