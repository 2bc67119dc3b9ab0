! A wheel on a rail in Fortran: Hertz, FASTSIM2 with derivatives, the exact theory, and a field.
!
!   gfortran microslip.f90 first_contact.f90 $(pkg-config --libs microslip_c) -o first_contact
program first_contact
  use, intrinsic :: ieee_arithmetic
  use, intrinsic :: iso_c_binding
  use microslip
  implicit none
  type(microslip_bodies) :: bodies
  type(microslip_hertz) :: hertz
  type(microslip_contact) :: contact
  type(microslip_error) :: error
  real(c_double) :: flat

  print '(2a)', 'microslip ', microslip_version()
  flat = ieee_value(flat, ieee_positive_inf)
  bodies = microslip_bodies([0.46_c_double, flat], [flat, 0.3_c_double], [210e9_c_double, 210e9_c_double], &
    [0.28_c_double, 0.28_c_double])
  call demand(microslip_hertz_from_load(bodies, 80e3_c_double, hertz, error))
  print '(a, es16.8, a, es16.8, a)', 'Hertz    a', hertz%a, ' b', hertz%b, ' m'
  contact = microslip_contact(a=hertz%a, b=hertz%b, shear_modulus=hertz%shear_modulus, &
    poisson_ratio=hertz%poisson_ratio, normal_force=80e3_c_double, rolling_speed=30.0_c_double, &
    friction=0.3_c_double, creepage_longitudinal=0.0018_c_double, creepage_lateral=0.0006_c_double, spin=0.4_c_double)
  call simplified_theory()
  call exact_theory()

contains

  !> Ends the program with the error's words unless all is well.
  subroutine demand(code)
    integer(c_int), intent(in) :: code
    if (code == microslip_ok) return
    print '(4a)', microslip_error_text(error), ' (', microslip_code_text(code), ')'
    error stop
  end subroutine

  subroutine simplified_theory()
    type(c_ptr) :: solver
    type(microslip_fastsim2_options) :: options
    type(microslip_contact) :: contacts(2) ! braked and driven
    type(microslip_derivatives) :: found(2)
    integer :: k
    contacts = contact
    contacts(2)%creepage_longitudinal = -contact%creepage_longitudinal
    call demand(microslip_fastsim2_options_init(options, c_sizeof(options)))
    call demand(microslip_fastsim2_create(options, solver, error))
    if (microslip_fastsim2_differentiate(solver, 2_c_size_t, contacts, found) /= microslip_ok) &
      call demand(microslip_contact_check(contact, error))
    call microslip_fastsim2_destroy(solver)
    do k = 1, 2
      print '(a, es16.8, a, es16.8, a, es16.8, a, es16.8, a)', 'FASTSIM2 fx', found(k)%forces%fx, ' fy', &
        found(k)%forces%fy, ' N mz', found(k)%forces%mz, ' N m dfx/dxi', found(k)%jacobian(1, 1), ' N'
    end do
  end subroutine

  subroutine exact_theory()
    type(c_ptr) :: solver
    type(microslip_exact_options) :: options
    type(microslip_exact_motion) :: motion
    type(microslip_exact_result) :: result
    real(c_double), allocatable :: px(:), py(:)
    integer(c_size_t) :: count
    call demand(microslip_exact_options_init(options, c_sizeof(options)))
    call demand(microslip_exact_motion_init(motion, c_sizeof(motion)))
    result%struct_size = c_sizeof(result)
    call demand(microslip_exact_create(options, solver, error))
    call demand(microslip_exact_solve(solver, contact, motion, result, error))
    count = int(result%mx, c_size_t) * result%my
    allocate (px(count), py(count))
    call demand(microslip_exact_get(solver, microslip_field_px, count, px, error))
    call demand(microslip_exact_get(solver, microslip_field_py, count, py, error))
    call microslip_exact_destroy(solver)
    print '(a, es16.8, a, es16.8, a, es16.8, a, es16.8, a)', 'exact    fx', result%forces%fx, ' fy', &
      result%forces%fy, ' N mz', result%forces%mz, ' N m largest traction', maxval(hypot(px, py)), ' Pa'
  end subroutine
end program
