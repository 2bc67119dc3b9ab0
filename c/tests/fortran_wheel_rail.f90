! A wheel on a rail through the Fortran module: numbers by name, derivatives beside differences, patches beside their sum.
!
!   fortran_wheel_rail RAIL WHEEL      files of profiles
program fortran_wheel_rail
  use, intrinsic :: iso_c_binding
  use microslip
  implicit none
  integer(c_int), parameter :: states_solved = 2
  type(c_ptr) :: wheel_rail
  type(microslip_error) :: error
  real(c_double), allocatable :: states(:, :), results(:, :), jacobian(:, :, :), moved(:, :), again(:, :)
  integer(c_int) :: status(states_solved), yaw, force_y, force_z
  integer(c_size_t) :: width, result_width, row_count, count

  count = states_solved
  width = microslip_count(microslip_wheel_state)
  result_width = microslip_count(microslip_wheel_result)
  row_count = microslip_count(microslip_wheel_derivative)
  allocate (states(width, count), moved(width, count))
  allocate (results(result_width, count), again(result_width, count), jacobian(width, row_count, count))
  yaw = at(microslip_wheel_state, 'yaw')
  force_y = at(microslip_wheel_result, 'force_y')
  force_z = at(microslip_wheel_result, 'force_z')
  call make()
  call look_at_derivatives()
  call look_at_patches()
  call look_at_contacts()
  call look_at_lists()
  call microslip_wheel_rail_destroy(wheel_rail)
  print '(a)', 'all is as it should be'

contains

  subroutine require(holds, what)
    logical, intent(in) :: holds
    character(*), intent(in) :: what
    if (holds) return
    print '(2a)', 'not so: ', what
    error stop
  end subroutine

  function at(list, name) result(index)
    integer(c_int), intent(in) :: list
    character(*), intent(in) :: name
    integer(c_int) :: index
    index = microslip_index(list, name, error)
    call require(index > 0, microslip_error_text(error))
  end function

  function argument(number) result(text)
    integer, intent(in) :: number
    character(:), allocatable :: text
    integer :: length
    call get_command_argument(number, length=length)
    allocate (character(length) :: text)
    call get_command_argument(number, text)
  end function

  subroutine set(problem, path, value)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path
    real(c_double), intent(in) :: value
    call require(microslip_set(problem, path, value, error) == microslip_ok, microslip_error_text(error))
  end subroutine

  subroutine make()
    type(c_ptr) :: problem
    call require(microslip_problem_create(microslip_wheel_problem, problem, error) == microslip_ok, 'problem_create')
    call set(problem, 'track.gauge', 1.435_c_double)
    call set(problem, 'track.cant', 0.05_c_double)
    call require(microslip_set(problem, 'rail.profile', argument(1), error) == microslip_ok, 'the rail')
    call require(microslip_set(problem, 'wheelset.profile', argument(2), error) == microslip_ok, 'the wheel')
    call set(problem, 'wheelset.nominal_radius', 0.46_c_double)
    call set(problem, 'wheelset.flange_back_distance', 1.36_c_double)
    call set(problem, 'wheel.lateral', 0.00604_c_double)
    call set(problem, 'wheel.vertical_force', 80e3_c_double)
    call set(problem, 'wheel.forward_velocity', 30.0_c_double)
    call set(problem, 'material.young_modulus', 210e9_c_double)
    call set(problem, 'material.poisson_ratio', 0.28_c_double)
    call set(problem, 'friction.coefficient', 0.3_c_double)
    call look_at_inputs(problem)
    call require(microslip_wheel_rail_create(problem, wheel_rail, error) == microslip_ok, microslip_error_text(error))
    call microslip_problem_destroy(problem)
  end subroutine

  !> What was set is read back, defaults too; a misspelt path is refused with the nearest; the problem has a result.
  subroutine look_at_inputs(problem)
    type(c_ptr), intent(in) :: problem
    real(c_double) :: value, force
    real(c_double), allocatable :: values(:), field(:, :)
    character(:), allocatable :: word
    call require(microslip_get(problem, 'wheel.lateral', value, error) == microslip_ok, 'get')
    call require(abs(value - 0.00604_c_double) < 1e-12, 'the lateral displacement')
    call require(microslip_get(problem, 'wheel.side', word, error) == microslip_ok, 'get of a word')
    call require(word == 'left', 'its default')
    call require(microslip_set(problem, 'rail.trim', [-0.03_c_double, 0.03_c_double], error) == microslip_ok, 'trim')
    call require(microslip_get(problem, 'rail.trim', values, error) == microslip_ok, 'get of an array')
    call require(size(values) == 2 .and. values(2) > 0, 'its numbers')
    call require(microslip_unset(problem, 'rail.trim', error) == microslip_ok, 'unset')
    call require(microslip_get(problem, 'rail.trim', values, error) == microslip_no_result, 'nothing is left')
    call require(microslip_set(problem, 'track.gage', 1.0_c_double, error) == microslip_invalid_option, 'a wrong path')
    call require(index(microslip_error_text(error), 'did you mean track.gauge?') > 0, microslip_error_text(error))
    call require(microslip_solve(problem, error) == microslip_ok, microslip_error_text(error))
    call require(microslip_number(problem, 'force_z', force, error) == microslip_ok, microslip_error_text(error))
    call require(abs(force - 80e3_c_double) < 1, 'the force is carried')
    call require(microslip_field(problem, 'normal_force', field, error) == microslip_ok, microslip_error_text(error))
    call require(size(field, 2) == 1 .and. all(field > 0), 'the patches')
  end subroutine

  subroutine look_at_derivatives()
    real(c_double), parameter :: step = 1e-6_c_double
    integer :: k
    real(c_double) :: difference
    do k = 1, states_solved
      call require(microslip_wheel_rail_state(wheel_rail, width, states(:, k)) == microslip_ok, 'the first state')
    end do
    call require(abs(states(at(microslip_wheel_state, 'vertical_force'), 1) - 80e3_c_double) < 1e-9, 'its force')
    states(yaw, 2) = 0.002_c_double
    call require(microslip_wheel_rail_differentiate(wheel_rail, count, width, states, result_width, results, status, &
      row_count, width, jacobian) == microslip_ok, 'differentiate')
    moved = states
    moved(yaw, :) = moved(yaw, :) + step
    call require(microslip_wheel_rail_solve(wheel_rail, count, width, moved, result_width, again, status) == &
      microslip_ok, 'solve')
    do k = 1, states_solved
      call require(abs(results(force_z, k) - 80e3_c_double) < 1, 'the force is carried')
      difference = (again(force_y, k) - results(force_y, k)) / step
      call require(abs(jacobian(yaw, at(microslip_wheel_derivative, 'force_y'), k) - difference) < &
        0.02_c_double * abs(difference), 'dFy/dyaw is a difference')
    end do
  end subroutine

  subroutine look_at_patches()
    real(c_double), allocatable, target :: patches(:, :)
    integer(c_size_t) :: patch_width, there
    real(c_double) :: vertical
    integer :: k
    there = 0
    call require(microslip_wheel_rail_patches(wheel_rail, 0_c_size_t, 0_c_size_t, c_null_ptr, there, error) == &
      microslip_ok, microslip_error_text(error))
    call require(there == nint(again(at(microslip_wheel_result, 'patch_count'), states_solved)), 'count of patches')
    patch_width = microslip_count(microslip_wheel_patch)
    allocate (patches(patch_width, there))
    call require(microslip_wheel_rail_patches(wheel_rail, patch_width, there, c_loc(patches), there, error) == &
      microslip_ok, microslip_error_text(error))
    vertical = 0
    do k = 1, int(there)
      associate (angle => patches(at(microslip_wheel_patch, 'angle'), k), &
          normal => patches(at(microslip_wheel_patch, 'normal_force'), k), fy => patches(at(microslip_wheel_patch, 'fy'), k))
        vertical = vertical + normal * cos(angle) + fy * sin(angle)
      end associate
    end do
    call require(abs(vertical - 80e3_c_double) < 80, 'the patches carry the force')
  end subroutine

  subroutine look_at_contacts()
    real(c_double) :: contacts(5, 2), lateral(2)
    integer(c_int) :: found(2)
    lateral = [-0.003_c_double, 0.003_c_double]
    call require(microslip_wheelset_contacts(wheel_rail, microslip_roll_equilibrium, 0.0_c_double, 2_c_size_t, lateral, &
      5_c_size_t, contacts, found, error) == microslip_ok, microslip_error_text(error))
    associate (difference => contacts(at(microslip_wheelset_contact, 'rolling_radius_difference'), :))
      call require(abs(difference(1) + difference(2)) < 1e-9_c_double .and. difference(2) > 0, 'the wheels are alike')
    end associate
  end subroutine

  subroutine look_at_lists()
    type(microslip_quantity) :: quantity
    quantity%struct_size = c_sizeof(quantity)
    call require(microslip_describe(microslip_wheel_state, yaw, quantity, error) == microslip_ok, 'describe')
    call require(microslip_text(quantity%name) == 'yaw', 'its name')
    call require(microslip_text(quantity%unit) == 'rad', 'its unit')
    call require(microslip_index(microslip_wheel_state, 'yav', error) == 0, 'a name that there is not')
    call require(index(microslip_error_text(error), 'did you mean yaw?') > 0, microslip_error_text(error))
  end subroutine
end program
