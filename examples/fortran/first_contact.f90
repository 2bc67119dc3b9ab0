! A wheel on a rail in Fortran: Hertz, FASTSIM2 with derivatives, the exact theory by paths of inputs, and a field.
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

  !> Sets an input by its path, as case files have it; what is left out has its default.
  subroutine set(problem, path, value)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path
    real(c_double), intent(in) :: value
    call demand(microslip_set(problem, path, value, error))
  end subroutine

  subroutine set_bodies(problem)
    type(c_ptr), intent(in) :: problem
    call set(problem, 'body1.rolling_radius', 0.46_c_double)
    call set(problem, 'body1.transverse_radius', flat)
    call set(problem, 'body1.young_modulus', 210e9_c_double)
    call set(problem, 'body1.poisson_ratio', 0.28_c_double)
    call set(problem, 'body2.rolling_radius', flat)
    call set(problem, 'body2.transverse_radius', 0.3_c_double)
    call set(problem, 'body2.young_modulus', 210e9_c_double)
    call set(problem, 'body2.poisson_ratio', 0.28_c_double)
  end subroutine

  function number(problem, name) result(value)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: name
    real(c_double) :: value
    call demand(microslip_number(problem, name, value, error))
  end function

  subroutine exact_theory()
    type(c_ptr) :: problem
    real(c_double), allocatable :: px(:, :), py(:, :)
    call demand(microslip_problem_create(microslip_bodies_problem, problem, error))
    call set_bodies(problem)
    call set(problem, 'load.normal_force', 80e3_c_double)
    call set(problem, 'friction.coefficient', 0.3_c_double)
    call set(problem, 'motion.rolling_speed', 30.0_c_double)
    call set(problem, 'motion.creepage_longitudinal', 0.0018_c_double)
    call set(problem, 'motion.creepage_lateral', 0.0006_c_double)
    call set(problem, 'motion.spin', 0.4_c_double)
    call demand(microslip_set(problem, 'solution.theory', 'exact', error))
    call demand(microslip_set(problem, 'solution.grid', [24.0_c_double, 24.0_c_double], error))
    call demand(microslip_solve(problem, error))
    call demand(microslip_field(problem, 'px', px, error))
    call demand(microslip_field(problem, 'py', py, error))
    print '(a, es16.8, a, es16.8, a, es16.8, a, es16.8, a)', 'exact    fx', number(problem, 'fx'), ' fy', &
      number(problem, 'fy'), ' N mz', number(problem, 'mz'), ' N m largest traction', maxval(hypot(px, py)), ' Pa'
    call microslip_problem_destroy(problem)
  end subroutine
end program
