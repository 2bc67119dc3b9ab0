! The Manchester contact benchmark A-2.2 through libcontact in Fortran: both wheels, 21 states each. manchester.c says
! more.
!
!   gfortran PREFIX/share/microslip/fortran/contact_addon.f90 manchester.f90 -L PREFIX/lib -lcontact -o manchester
!   ./manchester RAIL.prr WHEEL.prw
program manchester
  use, intrinsic :: iso_c_binding, only: c_double, c_int
  use contact_addon
  implicit none
  integer, parameter :: states = 21, most_values = 40
  integer(c_int), parameter :: whole = -1
  real(c_double), parameter :: roll(states) = [ &
    0.00000000d0, -0.00002304d0, -0.00005049d0, -0.00008103d0, -0.00011280d0, -0.00014570d0, -0.00018030d0, &
    -0.00021680d0, -0.00025570d0, -0.00029770d0, -0.00035540d0, -0.00047770d0, -0.00062720d0, -0.00437600d0, &
    -0.00639300d0, -0.00764200d0, -0.00860600d0, -0.00940800d0, -0.01010113d0, -0.01071386d0, -0.01126431d0]
  real(c_double), parameter :: pitch_velocity(states) = [ &
    -4.34811810d0, -4.34741340d0, -4.34657520d0, -4.34624400d0, -4.34591970d0, -4.34556270d0, -4.34515030d0, &
    -4.34466880d0, -4.34409300d0, -4.34337150d0, -4.33536370d0, -4.33188640d0, -4.32937180d0, -4.27488340d0, &
    -4.26356290d0, -4.25757470d0, -4.25348570d0, -4.25032450d0, -4.24775610d0, -4.24556650d0, -4.24363750d0]
  character(len=1024) :: rail, wheel
  integer(c_int) :: version, error, ire, state, patches, patch
  real(c_double) :: forces(24), position(6)

  if (command_argument_count() /= 2) stop 'usage: manchester RAIL.prr WHEEL.prw'
  call get_command_argument(1, rail)
  call get_command_argument(2, wheel)
  call cntc_initializefirst(version, error, 0_c_int, ' ', ' ', ' ', 1_c_int, 1_c_int, 1_c_int)
  if (error /= 0) stop 1
  do ire = 1, 2
    call cntc_initialize(ire, 1_c_int, version, error, ' ', 1_c_int)
    if (error /= 0) stop 1
    call set_up(ire)
  end do
  do ire = 1, 2
    do state = 1, states
      call set_state(ire, state)
      call ask_for_sensitivities(ire, merge(3, 0, state == states))
      call cntc_calculate(ire, whole, error)
      if (error < 0) stop 1
      call cntc_getglobalforces(ire, whole, 24_c_int, forces)
      call cntc_getwheelsetposition(ire, 6_c_int, position)
      call cntc_getnumcontactpatches(ire, patches)
      print '(a, 3(1x, i0), 7(1x, es17.9))', 'wheel', ire, state, patches, position(3), forces(1:3), forces(7:9)
      do patch = 1, patches
        call print_patch(ire, state, patch)
      end do
      if (state == states) then
        call print_fields(ire, 1)
        call print_sensitivities(ire, 1)
      end if
    end do
  end do
  call cntc_finalizelast()

contains

  ! What does not change from state to state.
  subroutine set_up(ire)
    integer(c_int), intent(in) :: ire
    integer(c_int) :: flags(6), values(6)
    flags = [CNTC_if_units, CNTC_ic_config, CNTC_ic_tang, CNTC_ic_pvtime, CNTC_ic_norm, CNTC_ic_discns]
    values = [CNTC_un_cntc, ire - 1, 3, 2, 1, 2]
    call cntc_setflags(ire, whole, 6_c_int, flags, values)
    call cntc_setmaterialparameters(ire, whole, 0_c_int, 4_c_int, [0.28d0, 0.28d0, 82000d0, 82000d0])
    call cntc_setfrictionmethod(ire, whole, 0_c_int, 2_c_int, [0.3d0, 0.3d0])
    call cntc_setverticalforce(ire, 10000d0)
    call cntc_setpotcontact(ire, whole, -1_c_int, 5_c_int, [0.2d0, 0.2d0, 1.5707963267948966d0, 8d0, 4d0])
    call cntc_setrollingstepsize(ire, whole, 0d0, 1d0)
    call cntc_settrackdimensions(ire, 3_c_int, 11_c_int, &
                                 [14d0, 0d0, 1435d0, 0d0, 0d0, 0d0, 0d0, 0d0, 0d0, 0d0, 0d0])
    call set_profile(ire, trim(rail), 0)
    call cntc_setwheelsetdimensions(ire, 3_c_int, 3_c_int, [1360d0, -70d0, 460d0])
    call set_profile(ire, trim(wheel), 1)
  end subroutine set_up

  subroutine set_profile(ire, file, itype)
    integer(c_int), intent(in) :: ire, itype
    character(len=*), intent(in) :: file
    call cntc_setprofileinputfname(ire, file, len(file, c_int), 3_c_int, [itype, 0, 0], 2_c_int, [1d0, 0d0])
  end subroutine set_profile

  subroutine set_state(ire, state)
    integer(c_int), intent(in) :: ire, state
    call cntc_setwheelsetposition(ire, 2_c_int, 6_c_int, &
                                  [0d0, 0.5d0*(state - 1), 0d0, roll(state), 0.0012d0*(state - 1), 0d0])
    call cntc_setwheelsetvelocity(ire, 2_c_int, 6_c_int, [2000d0, 0d0, 0d0, 0d0, 0d0, pitch_velocity(state)])
  end subroutine set_state

  subroutine print_patch(ire, state, icp)
    integer(c_int), intent(in) :: ire, state, icp
    real(c_double) :: at(most_values), fn, tx, ty, mz, pen, xi, eta, phi, v, c, h, s, pmax
    call cntc_getcontactlocation(ire, icp, int(most_values, c_int), at)
    call cntc_getreferencevelocity(ire, icp, v)
    call cntc_getpenetration(ire, icp, pen)
    call cntc_getcreepages(ire, icp, xi, eta, phi)
    call cntc_getcontactforces(ire, icp, fn, tx, ty, mz)
    call cntc_getcontactpatchareas(ire, icp, c, h, s)
    call cntc_getmaximumpressure(ire, icp, pmax)
    print '(a, 3(1x, i0), 17(1x, es17.9))', 'patch', ire, state, icp, at(1:4), at(6:7), v, pen, xi, eta, phi, &
      fn, tx, ty, mz, c, pmax
  end subroutine print_patch

  ! Pressures and tractions of all elements, and what they sum up to.
  subroutine print_fields(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    integer(c_int) :: mx, my
    integer(c_int), allocatable :: division(:)
    real(c_double), allocatable :: pn(:), px(:), py(:)
    real(c_double) :: dx, dy
    call cntc_getnumelements(ire, icp, mx, my)
    call cntc_getgriddiscretization(ire, icp, dx, dy)
    allocate (pn(mx*my), px(mx*my), py(mx*my), division(mx*my))
    call cntc_gettractions(ire, icp, mx*my, pn, px, py)
    call cntc_getelementdivision(ire, icp, mx*my, division)
    print '(a, 5(1x, i0), 2(1x, es17.9))', 'fields', ire, icp, mx, my, count(division > 0), sum(pn)*dx*dy, &
      sum(px)*dx*dy
  end subroutine print_fields

  subroutine print_sensitivities(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    real(c_double) :: sens(16)
    call cntc_getsensitivities(ire, icp, 4_c_int, 4_c_int, sens)
    print '(a, 1x, i0, 16(1x, es13.5))', 'sensitivities', ire, sens
  end subroutine print_sensitivities

  ! For the state that is calculated next.
  subroutine ask_for_sensitivities(ire, which)
    integer(c_int), intent(in) :: ire, which
    call cntc_setflags(ire, whole, 1_c_int, [CNTC_ic_sens], [which])
  end subroutine ask_for_sensitivities

end program manchester
