# At installation: the headers that users include, as patterns below the root, and what these include.
cmake_policy(VERSION 3.25)
set(public_headers
  microslip/*.hpp microslip/batch/*.hpp microslip/contact/*.hpp
  microslip/elasticity/hertz.hpp microslip/elasticity/interface_layer.hpp microslip/elasticity/layered_body.hpp
  microslip/elasticity/material.hpp microslip/elasticity/shore_hardness.hpp microslip/elasticity/stress.hpp microslip/elasticity/viscoelastic.hpp
  microslip/damage/*.hpp microslip/response/*.hpp microslip/friction/*.hpp microslip/interior/*.hpp
  microslip/railway/derailment.hpp microslip/railway/geometry/conicity.hpp microslip/railway/profile/profile.hpp
  microslip/railway/profile/profile_dimensions.hpp microslip/railway/profile/profile_preparation.hpp
  microslip/railway/profile/profile_slices.hpp microslip/railway/profile/profile_smoothing.hpp
  microslip/railway/profile/standard_profile.hpp
  microslip/railway/vehicle/wheelset_on_track.hpp microslip/railway/vehicle/wheelset_quantities.hpp
  microslip/railway/wheel_rail.hpp microslip/railway/wheel_rail_quantities.hpp
  microslip/rolling/*.hpp microslip/simplified/*.hpp microslip/table/creep_force_table.hpp
  microslip/table/making/*.hpp microslip/thermal/*.hpp)

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
list(TRANSFORM public_headers PREPEND ${root}/)
file(GLOB unread RELATIVE ${root} ${public_headers})
list(REMOVE_ITEM unread microslip/rolling/ellipse_solver.hpp microslip/rolling/layered_rolling.hpp) # parts of Solver
set(installed "")
while(unread)
  list(POP_FRONT unread header)
  if(header IN_LIST installed)
    continue()
  endif()
  list(APPEND installed ${header})
  file(STRINGS ${root}/${header} includes REGEX "^#include \"microslip/")
  list(TRANSFORM includes REPLACE "^#include \"(.*)\".*" "\\1")
  list(APPEND unread ${includes})
  cmake_path(GET header PARENT_PATH folder)
  file(INSTALL ${root}/${header} DESTINATION ${CMAKE_INSTALL_PREFIX}/${include_folder}/${folder})
endwhile()
