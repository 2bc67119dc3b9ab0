# The documentation as the tests see it: its code is built and run, its tutorials too, and the site is built where Sphinx is.
set(making ${CMAKE_CURRENT_LIST_DIR})
file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/docs/*.md)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${pages} ${making}/run_blocks.py ${making}/blocks.py)

# C and C++ of the pages, each block a program.
set(code ${CMAKE_BINARY_DIR}/docs_code)
execute_process(COMMAND ${Python3_EXECUTABLE} -B ${making}/run_blocks.py extract ${code} ${pages} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB sources ${code}/*.cpp ${code}/*.c)
foreach(source ${sources})
  get_filename_component(name ${source} NAME_WE)
  add_executable(docs_${name} ${source})
  target_link_libraries(docs_${name} PRIVATE microslip::microslip microslip::microslip_c)
endforeach()

set(python_packages "\"$0\" -c 'import h5py, matplotlib, numpy' || exit 77")
set(environment ${python_environment} MPLBACKEND=Agg PYTHONPATH=${CMAKE_BINARY_DIR}/share/microslip/python)
foreach(page ${pages})
  file(STRINGS ${page} fences REGEX "^```[a-z]+$")
  get_filename_component(name ${page} NAME_WE)
  if(NOT fences OR name STREQUAL "gallery") # whose commands take minutes: `tools/pictures --check gallery` runs them
    continue()
  endif()
  add_test(NAME docs_code_${name}
    COMMAND sh -c "${python_packages}; exec \"$0\" \"$@\"" ${python_interpreter} ${making}/run_blocks.py check ${page}
      ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
  set_tests_properties(docs_code_${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}")
endforeach()
add_test(NAME docs_making COMMAND sh -c "${python_packages}; exec \"$0\" -m unittest discover -s tests -t ." ${python_interpreter}
  WORKING_DIRECTORY ${making})
set_tests_properties(docs_making PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}")

# The pictures of docs/images are those that the program draws today, as far as they take less than half a minute.
add_test(NAME docs_images
  COMMAND sh -c "${python_packages}; exec \"$0\" '${making}/images.py' --check --quick" ${python_interpreter})
set_tests_properties(docs_images PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}" TIMEOUT 900)

# With sanitizers what follows takes minutes and says nothing that the tests of programs and module do not.
if(CMAKE_CXX_FLAGS MATCHES "sanitize")
  return()
endif()

# The figures of pages that are printed within seconds; tools/figures --check compares the others as well.
foreach(page ${pages})
  file(STRINGS ${page} printed REGEX "^<!-- printed by: ")
  if(printed)
    get_filename_component(name ${page} NAME)
    add_test(NAME docs_printed_${name}
      COMMAND sh -c "${python_packages}; exec \"$0\" \"$@\"" ${python_interpreter} ${making}/printed.py --check --quick
        --build ${CMAKE_BINARY_DIR} /${name})
    set_tests_properties(docs_printed_${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}")
  endif()
endforeach()
set(tutorial_packages "\"$0\" -c 'import h5py, matplotlib, nbformat, numpy' || exit 77")
file(GLOB tutorials CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/tutorials/*.py)
foreach(tutorial ${tutorials})
  get_filename_component(name ${tutorial} NAME_WE)
  add_test(NAME tutorial_${name} COMMAND sh -c "${tutorial_packages}; exec \"$0\" \"$@\"" ${Python3_EXECUTABLE} ${making}/tutorial.py
    ${tutorial} ${CMAKE_BINARY_DIR}/docs/.doctrees/tutorials/${name})
  set_tests_properties(tutorial_${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}" FIXTURES_SETUP tutorials)
endforeach()

# The site, without a warning, with the tutorials that have been run.
add_test(NAME docs
  COMMAND sh -c "${tutorial_packages}; \"$0\" -c 'import furo, myst_parser, sphinx' && test -d /usr/share/javascript/mathjax || exit 77; exec \"$0\" -m sphinx -q -W --keep-going -b html \"$@\""
    ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/docs ${CMAKE_BINARY_DIR}/docs)
set_tests_properties(docs PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT "${environment}" FIXTURES_REQUIRED tutorials TIMEOUT 600)
