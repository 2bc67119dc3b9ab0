# Headers of other libraries that most sources of a target include, parsed once for all of them. None of ours: a change
# of theirs must not compile everything anew.
function(microslip_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  # So that compiler caches see what they hold.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()
