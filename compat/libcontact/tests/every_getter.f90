! every_getter.c in Fortran: the same calls, and the same lines.
!
!   every_getter RAIL.prr WHEEL.prw
program every_getter
  use, intrinsic :: iso_c_binding, only: c_double, c_int
  use contact_addon
  implicit none
  integer(c_int), parameter :: whole = -1, right = 1, left = 2, contacts = 3, layer = 4
  real(c_double), parameter :: steel(4) = [0.28d0, 0.28d0, 82000d0, 82000d0]
  character(len=1024) :: rail, wheel
  integer(c_int) :: threads

  if (command_argument_count() /= 2) stop 1
  call get_command_argument(1, rail)
  call get_command_argument(2, wheel)
  call place_wheel(left)
  call set_up_ellipse(contacts, 2_c_int)
  call ask_too_early(contacts, 1_c_int)
  call cntc_setverticalforce(right, 80000d0)
  call add_points(right, whole)
  call set_up_wheel(left)
  call set_up_hot_sphere(contacts, 1_c_int)
  call calculate(contacts, 2_c_int)
  call set_up_layer(layer, 5_c_int)
  call set_up_wheel(right)
  call calculate(left, whole)
  call place_wheel(right)
  call calculate(layer, 5_c_int)
  call calculate(contacts, 1_c_int)
  call calculate(right, whole)
  call add_points(contacts, 2_c_int)
  call cntc_getmaxnumthreads(threads)
  call show_wheel(left)
  call show_contact(contacts, 1_c_int)
  call show_wheel(right)
  call show_contact(layer, 5_c_int)
  call show_hertz(layer, 5_c_int)
  call show_contact(contacts, 2_c_int)
  call show_hertz(contacts, 2_c_int)
  call show_interior(contacts, 2_c_int, 2_c_int)
  call show_interior(right, 1_c_int, whole)
  call show_flags(right, whole)
  call show_flags(contacts, 1_c_int)
  call show_flags(contacts, 2_c_int)
  call show_flags(layer, 5_c_int)
  call check_time(right, whole)
  call check_time(layer, 5_c_int)
  call cntc_finalizelast()

contains

  subroutine show(name, ire, icp, values)
    character(len=*), intent(in) :: name
    integer(c_int), intent(in) :: ire, icp
    real(c_double), intent(in) :: values(:)
    print '(a, 2(1x, i0), *(1x, es25.16e3))', name, ire, icp, values
  end subroutine show

  subroutine show_integers(name, ire, icp, values)
    character(len=*), intent(in) :: name
    integer(c_int), intent(in) :: ire, icp, values(:)
    print '(a, *(1x, i0))', name, ire, icp, values
  end subroutine show_integers

  function numbered(name, number)
    character(len=*), intent(in) :: name
    integer(c_int), intent(in) :: number
    character(len=:), allocatable :: numbered
    character(len=8) :: digits
    write (digits, '(i0)') number
    numbered = name//'_'//trim(digits)
  end function numbered

  subroutine set_flag(ire, icp, flag, value)
    integer(c_int), intent(in) :: ire, icp, flag, value
    call cntc_setflags(ire, icp, 1_c_int, [flag], [value])
  end subroutine set_flag

  subroutine set_profile(ire, file, itype)
    integer(c_int), intent(in) :: ire, itype
    character(len=*), intent(in) :: file
    call cntc_setprofileinputfname(ire, file, len(file, c_int), 3_c_int, [itype, 0, 0], 2_c_int, [1d0, 0d0])
  end subroutine set_profile

  subroutine ask_too_early(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    real(c_double) :: fn, fx, fy, mz
    call cntc_getcontactforces(ire, icp, fn, fx, fy, mz)
  end subroutine ask_too_early

  subroutine place_wheel(ire)
    integer(c_int), intent(in) :: ire
    call cntc_setwheelsetvelocity(ire, 2_c_int, 6_c_int, [30000d0, 0d0, 0d0, 0d0, 0d0, -65d0])
    call cntc_setwheelsetposition(ire, 2_c_int, 6_c_int, [0d0, 3d0, 0.2d0, -3d-4, 6d-3, 0d0])
  end subroutine place_wheel

  subroutine set_up_wheel(ire)
    integer(c_int), intent(in) :: ire
    call set_profile(ire, trim(wheel), 1_c_int)
    call cntc_settrackdimensions(ire, 3_c_int, 11_c_int, &
                                 [14d0, 0d0, 1435d0, 0.05d0, 0d0, 0d0, 0d0, 0d0, 0d0, 0d0, 0d0])
    call cntc_setwheelsetdimensions(ire, 3_c_int, 3_c_int, [1360d0, -70d0, 460d0])
    call cntc_setfrictionmethod(ire, whole, 0_c_int, 2_c_int, [0.3d0, 0.3d0])
    call cntc_setpotcontact(ire, whole, -1_c_int, 5_c_int, [0.5d0, 0.5d0, 1.5707963267948966d0, 8d0, 4d0])
    call set_profile(ire, trim(rail), 0_c_int)
    call cntc_setmaterialparameters(ire, whole, 0_c_int, 4_c_int, steel)
    call set_flag(ire, whole, CNTC_ic_config, merge(0_c_int, 1_c_int, ire == left))
  end subroutine set_up_wheel

  subroutine set_motion(ire, icp, vx, vy, phi)
    integer(c_int), intent(in) :: ire, icp
    real(c_double), intent(in) :: vx, vy, phi
    call cntc_setcreepages(ire, icp, vx, vy, phi)
    call cntc_setrollingstepsize(ire, icp, 0d0, 0.2d0)
    call cntc_setreferencevelocity(ire, icp, 2000d0)
  end subroutine set_motion

  subroutine set_up_hot_sphere(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    real(c_double), parameter :: heat(4) = [20d0, 450d0, 0.05d0, 7.85d-6]
    call cntc_setundeformeddistc(ire, icp, 1_c_int, 6_c_int, [0.005d0, 0d0, 0.005d0, 0d0, 0d0, 0d0])
    call cntc_settemperaturedata(ire, icp, 3_c_int, 8_c_int, [heat, heat])
    call cntc_setnormalforce(ire, icp, 1000d0)
    call cntc_setfrictionmethod(ire, icp, 4_c_int, 7_c_int, &
                                [0.2d0, 0.1d0, 50d0, 0d0, 10000d0, 0.001d0, 10d0])
    call cntc_setpotcontact(ire, icp, 1_c_int, 6_c_int, [21d0, 21d0, -1.05d0, -1.05d0, 0.1d0, 0.1d0])
    call set_motion(ire, icp, 0.001d0, -0.0005d0, 0.0001d0)
    call cntc_setmaterialparameters(ire, icp, 0_c_int, 4_c_int, steel)
  end subroutine set_up_hot_sphere

  subroutine set_up_ellipse(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    call set_flag(ire, icp, CNTC_ic_sens, 3_c_int)
    call cntc_setfrictionmethod(ire, icp, 0_c_int, 2_c_int, [0.3d0, 0.3d0])
    call cntc_settangentialforces(ire, icp, 0.4d0, 0d0)
    call set_motion(ire, icp, 0d0, 0.0005d0, 0d0)
    call cntc_setnormalforce(ire, icp, 2000d0)
    call set_flag(ire, icp, CNTC_ic_force, 1_c_int)
    call cntc_sethertzcontact(ire, icp, -3_c_int, 5_c_int, [16d0, 16d0, 1d0, 0.8d0, 1.25d0])
    call cntc_setmaterialparameters(ire, icp, 0_c_int, 4_c_int, steel)
  end subroutine set_up_ellipse

  subroutine set_up_layer(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    call cntc_setpenetration(ire, icp, 0.01d0)
    call set_motion(ire, icp, 0.004d0, 0.002d0, 0d0)
    call cntc_setfrictionmethod(ire, icp, 0_c_int, 2_c_int, [0.5d0, 0.5d0])
    call cntc_setmaterialparameters(ire, icp, 4_c_int, 8_c_int, [steel, 8200d0, 0.02d0, 60d0, 500d0])
    call cntc_sethertzcontact(ire, icp, -3_c_int, 5_c_int, [12d0, 12d0, 1d0, 1d0, 1.2d0])
  end subroutine set_up_layer

  subroutine add_points(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    call subs_addblock(ire, icp, 1_c_int, 9_c_int, 2_c_int, 1_c_int, 2_c_int, [0d0, 0.5d0], [0.25d0], [0.5d0, -1d0])
  end subroutine add_points

  subroutine calculate(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    integer(c_int) :: error
    call cntc_calculate(ire, icp, error)
    if (error < 0) stop 1
  end subroutine calculate

  subroutine show_interior(ire, icp, calculated_icp)
    integer(c_int), intent(in) :: ire, icp, calculated_icp
    integer(c_int) :: error, sizes(3), k
    real(c_double) :: values(4*21)
    call subs_calculate(ire, calculated_icp, error)
    if (error < 0) stop 1
    call subs_getblocksize(ire, icp, 1_c_int, sizes(1), sizes(2), sizes(3))
    call show_integers('subs_getblocksize', ire, icp, sizes)
    call subs_getresults(ire, icp, 1_c_int, 4_c_int, 21_c_int, [(k, k=1, 21)], values)
    call show('subs_getresults', ire, icp, values)
  end subroutine show_interior

  subroutine show_fields(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    integer(c_int), parameter :: codes(17) = [ &
      CNTC_fld_h, CNTC_fld_mu, CNTC_fld_px, CNTC_fld_py, CNTC_fld_pn, CNTC_fld_ux, CNTC_fld_uy, CNTC_fld_un, &
      CNTC_fld_sx, CNTC_fld_sy, CNTC_fld_wx, CNTC_fld_wy, CNTC_fld_taucrt, CNTC_fld_uplsx, CNTC_fld_uplsy, &
      CNTC_fld_temp1, CNTC_fld_temp2]
    integer(c_int) :: mx, my, k
    integer(c_int), allocatable :: division(:)
    real(c_double), allocatable :: a(:), b(:), c(:)
    call cntc_getnumelements(ire, icp, mx, my)
    call show_integers('cntc_getnumelements', ire, icp, [mx, my])
    allocate (a(mx*my), b(mx*my), c(mx*my), division(mx*my))
    do k = 1, size(codes)
      call cntc_getfielddata(ire, icp, codes(k), mx*my, a)
      call show(numbered('cntc_getfielddata', codes(k)), ire, icp, a)
    end do
    call cntc_gettractions(ire, icp, mx*my, a, b, c)
    call show('cntc_gettractions_pn', ire, icp, a)
    call show('cntc_gettractions_px', ire, icp, b)
    call show('cntc_gettractions_py', ire, icp, c)
    call cntc_getmicroslip(ire, icp, mx*my, a, b)
    call show('cntc_getmicroslip_sx', ire, icp, a)
    call show('cntc_getmicroslip_sy', ire, icp, b)
    call cntc_getdisplacements(ire, icp, mx*my, a, b, c)
    call show('cntc_getdisplacements_un', ire, icp, a)
    call show('cntc_getdisplacements_ux', ire, icp, b)
    call show('cntc_getdisplacements_uy', ire, icp, c)
    call cntc_getelementdivision(ire, icp, mx*my, division)
    call show_integers('cntc_getelementdivision', ire, icp, division)
  end subroutine show_fields

  subroutine show_contact(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    integer(c_int), parameter :: lengths(3) = [6, 22, 7]
    integer(c_int) :: task
    real(c_double) :: v(40)
    call cntc_getreferencevelocity(ire, icp, v(1))
    call show('cntc_getreferencevelocity', ire, icp, v(:1))
    call cntc_getgriddiscretization(ire, icp, v(1), v(2))
    call show('cntc_getgriddiscretization', ire, icp, v(:2))
    call cntc_getpenetration(ire, icp, v(1))
    call show('cntc_getpenetration', ire, icp, v(:1))
    call cntc_getcreepages(ire, icp, v(1), v(2), v(3))
    call show('cntc_getcreepages', ire, icp, v(:3))
    call cntc_getcontactforces(ire, icp, v(1), v(2), v(3), v(4))
    call show('cntc_getcontactforces', ire, icp, v(:4))
    call cntc_getcontactpatchareas(ire, icp, v(1), v(2), v(3))
    call show('cntc_getcontactpatchareas', ire, icp, v(:3))
    call cntc_getmaximumpressure(ire, icp, v(1))
    call show('cntc_getmaximumpressure', ire, icp, v(:1))
    call cntc_getmaximumtraction(ire, icp, v(1))
    call show('cntc_getmaximumtraction', ire, icp, v(:1))
    call cntc_getmaximumtemperature(ire, icp, v(1), v(2))
    call show('cntc_getmaximumtemperature', ire, icp, v(:2))
    call cntc_getpotcontact(ire, icp, 6_c_int, v)
    call show('cntc_getpotcontact', ire, icp, v(:6))
    do task = 1, 3
      call cntc_getparameters(ire, icp, task, lengths(task), v)
      call show(numbered('cntc_getparameters', task), ire, icp, v(:lengths(task)))
    end do
    call cntc_getsensitivities(ire, icp, 4_c_int, 4_c_int, v)
    call show('cntc_getsensitivities', ire, icp, v(:16))
    call show_fields(ire, icp)
  end subroutine show_contact

  subroutine show_hertz(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    real(c_double) :: v(10)
    call cntc_gethertzcontact(ire, icp, 10_c_int, v)
    call show('cntc_gethertzcontact', ire, icp, v)
  end subroutine show_hertz

  subroutine show_wheel(ire)
    integer(c_int), intent(in) :: ire
    integer(c_int) :: patches, patch, itype
    real(c_double) :: v(40)
    real(c_double), allocatable :: points(:)
    call cntc_getnumcontactpatches(ire, patches)
    call show_integers('cntc_getnumcontactpatches', ire, whole, [patches])
    call cntc_getwheelsetposition(ire, 6_c_int, v)
    call show('cntc_getwheelsetposition', ire, whole, v(:6))
    call cntc_getwheelsetvelocity(ire, 6_c_int, v)
    call show('cntc_getwheelsetvelocity', ire, whole, v(:6))
    call cntc_getgriddiscretization(ire, whole, v(1), v(2))
    call show('cntc_getgriddiscretization', ire, whole, v(:2))
    call cntc_getglobalforces(ire, whole, 24_c_int, v)
    call show('cntc_getglobalforces', ire, whole, v(:24))
    do patch = 1, patches
      call cntc_getglobalforces(ire, patch, 24_c_int, v)
      call show('cntc_getglobalforces', ire, patch, v(:24))
    end do
    do patch = 1, patches
      call cntc_getcontactlocation(ire, patch, 38_c_int, v)
      call show('cntc_getcontactlocation', ire, patch, v(:38))
      call show_contact(ire, patch)
    end do
    do itype = 0, 1
      call cntc_getprofilevalues(ire, 0_c_int, 2_c_int, [itype, 0_c_int], 0_c_int, [0d0], 1_c_int, v)
      allocate (points(2*nint(v(1))))
      call cntc_getprofilevalues_new(ire, 1_c_int, 2_c_int, [itype, 0_c_int], 0_c_int, [0d0], size(points, kind=c_int), &
                                     points)
      call show(numbered('cntc_getprofilevalues', itype), ire, whole, points)
      deallocate (points)
    end do
  end subroutine show_wheel

  subroutine show_flags(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    integer(c_int), parameter :: codes(14) = [ &
      CNTC_ic_pvtime, CNTC_ic_bound, CNTC_ic_tang, CNTC_ic_norm, CNTC_ic_force, CNTC_ic_frclaw, CNTC_ic_inflcf, &
      CNTC_ic_mater, CNTC_ic_heat, CNTC_ic_iestim, CNTC_ic_output, CNTC_ic_return, CNTC_if_units, CNTC_if_ncase]
    integer(c_int) :: values(14)
    call cntc_getflags(ire, icp, 14_c_int, codes, values)
    call show_integers('cntc_getflags', ire, icp, values)
  end subroutine show_flags

  subroutine check_time(ire, icp)
    integer(c_int), intent(in) :: ire, icp
    real(c_double) :: cpu, wall
    call cntc_getcalculationtime(ire, icp, cpu, wall)
    if (.not. wall > 0) stop 1
    call cntc_resetcalculationtime(ire, icp)
    call cntc_getcalculationtime(ire, icp, cpu, wall)
    if (wall > 0) stop 1
  end subroutine check_time

end program every_getter
