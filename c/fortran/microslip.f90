!> microslip from Fortran 2003: the names of microslip.h, which documents them. Compile this file with your program and
!> link with libmicroslip_c. Where C takes NULL pass c_null_ptr (c_null_funptr for the progress function). Paths and names
!> of problems are Fortran texts; microslip_set and microslip_get take numbers, texts and arrays.
module microslip
  use, intrinsic :: iso_c_binding
  implicit none
  private

  integer(c_int), parameter, public :: microslip_ok = 0, microslip_invalid_input = 1, microslip_not_converged = 2, &
    microslip_no_contact = 3, microslip_no_solution = 4, microslip_out_of_range = 5, microslip_implausible = 6, &
    microslip_null_pointer = 16, &
    microslip_wrong_size = 17, microslip_invalid_option = 18, microslip_out_of_memory = 19, microslip_no_result = 20, &
    microslip_internal_error = 21, microslip_in_use = 22
  integer(c_int), parameter, public :: microslip_coulomb = 0, microslip_linear = 1, microslip_rational = 2, &
    microslip_exponential = 3
  integer(c_int), parameter, public :: microslip_parabolic = 0, microslip_elliptic = 1
  integer(c_int), parameter, public :: microslip_three = 0, microslip_one = 1, microslip_blended = 2
  integer(c_int), parameter, public :: microslip_kalker = 0, microslip_computed = 1
  integer(c_int), parameter, public :: microslip_double = 0, microslip_single = 1
  integer(c_int), parameter, public :: microslip_forward = 0, microslip_backward = 1
  integer(c_int), parameter, public :: microslip_bodies_problem = 0, microslip_wheel_problem = 1, &
    microslip_wheelset_problem = 2
  integer(c_int), parameter, public :: microslip_contact_quantity = 0, microslip_contact_field = 1, &
    microslip_wheel_state = 2, microslip_wheel_result = 3, microslip_wheel_derivative = 4, microslip_wheel_patch = 5, &
    microslip_wheelset_contact = 6, microslip_wheelset_result = 7, microslip_bodies_input = 8, microslip_wheel_input = 9, &
    microslip_wheelset_input = 10
  integer(c_int), parameter, public :: microslip_number_input = 0, microslip_numbers_input = 1, microslip_whole_input = 2, &
    microslip_wholes_input = 3, microslip_text_input = 4, microslip_word_input = 5
  integer, parameter, public :: microslip_error_length = 256
  integer, parameter, public :: microslip_element_inputs = 4, microslip_element_forces = 3
  integer(c_int), parameter, public :: microslip_made_for_abi = 2

  type, bind(c), public :: microslip_error
    integer(c_int) :: code = 0
    character(kind=c_char) :: text(microslip_error_length) = c_null_char
  end type

  !> Texts for microslip_text.
  type, bind(c), public :: microslip_build
    type(c_ptr) :: version, commit, compiler, build_type
  end type

  type, bind(c), public :: microslip_contact
    real(c_double) :: a = 0, b = 0
    real(c_double) :: shear_modulus = 0, poisson_ratio = 0
    real(c_double) :: normal_force = 0, rolling_speed = 1
    real(c_double) :: creepage_longitudinal = 0, creepage_lateral = 0, spin = 0
    real(c_double) :: friction = 0
    integer(c_int) :: friction_law = microslip_coulomb
    real(c_double) :: friction_drop(2) = 0, friction_half_velocity(2) = 0
  end type

  type, bind(c), public :: microslip_forces
    real(c_double) :: fx = 0, fy = 0, mz = 0
    real(c_double) :: adhesion_area = 0, slip_area = 0
    integer(c_int) :: status = 0
  end type

  !> Element (k, n) of C's jacobian, row n and column k counted from 1: columns xi, eta, phi, Fn come first here.
  type, bind(c), public :: microslip_derivatives
    type(microslip_forces) :: forces
    real(c_double) :: jacobian(4, 3) = 0
  end type

  integer(c_int), parameter, public :: microslip_roll_equilibrium = 0, microslip_roll_none = 1

  type, bind(c), public :: microslip_bodies
    real(c_double) :: rolling_radius(2), transverse_radius(2)
    real(c_double) :: young_modulus(2), poisson_ratio(2)
  end type

  type, bind(c), public :: microslip_hertz
    real(c_double) :: a, b, approach, peak_pressure, stiffness
    real(c_double) :: shear_modulus, poisson_ratio, dissimilarity
  end type

  type, bind(c), public :: microslip_fastsim2_options
    integer(c_size_t) :: struct_size
    integer(c_int) :: mx, my, bound, flexibility, coefficients, direction
    real(c_double) :: slope_initial, slope_at_infinity, slope_decay
    integer(c_int) :: precision
  end type

  !> Set struct_size = c_sizeof(quantity) before use; microslip_text makes Fortran texts of the pointers.
  type, bind(c), public :: microslip_quantity
    integer(c_size_t) :: struct_size = 0
    type(c_ptr) :: name = c_null_ptr, symbol = c_null_ptr, unit = c_null_ptr, shift_unit = c_null_ptr, &
      description = c_null_ptr
    type(c_ptr) :: range = c_null_ptr
    real(c_double) :: least = 0, largest = 0, missing = 0
    type(c_ptr) :: missing_word = c_null_ptr
    integer(c_int) :: kind = 0
  end type

  interface
    function microslip_contact_check(contact, error) bind(c) result(code)
      import
      type(microslip_contact), intent(in) :: contact
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_polach_friction(static_coefficient, ratio, decay, contact, error) bind(c) result(code)
      import
      real(c_double), value :: static_coefficient, ratio, decay
      type(microslip_contact), intent(inout) :: contact
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_hertz_from_load(bodies, normal_force, hertz, error) bind(c) result(code)
      import
      type(microslip_bodies), intent(in) :: bodies
      real(c_double), value :: normal_force
      type(microslip_hertz), intent(out) :: hertz
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_hertz_warnings(bodies, hertz, text, error) bind(c) result(code)
      import
      type(microslip_bodies), intent(in) :: bodies
      type(microslip_hertz), intent(in) :: hertz
      type(c_ptr), intent(out) :: text
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    subroutine microslip_free_text(text) bind(c)
      import
      type(c_ptr), value :: text
    end subroutine

    function microslip_count(list) bind(c) result(count)
      import
      integer(c_int), value :: list
      integer(c_size_t) :: count
    end function

    function microslip_fastsim2_options_init(options, size) bind(c) result(code)
      import
      type(microslip_fastsim2_options), intent(out) :: options
      integer(c_size_t), value :: size
      integer(c_int) :: code
    end function

    function microslip_fastsim2_create(options, solver, error) bind(c) result(code)
      import
      type(microslip_fastsim2_options), intent(in) :: options
      type(c_ptr), intent(out) :: solver
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    subroutine microslip_fastsim2_destroy(solver) bind(c)
      import
      type(c_ptr), value :: solver
    end subroutine

    function microslip_fastsim2_solve(solver, count, contacts, forces) bind(c) result(code)
      import
      type(c_ptr), value :: solver
      integer(c_size_t), value :: count
      type(microslip_contact), intent(in) :: contacts(*)
      type(microslip_forces), intent(inout) :: forces(*)
      integer(c_int) :: code
    end function

    function microslip_fastsim2_differentiate(solver, count, contacts, derivatives) bind(c) result(code)
      import
      type(c_ptr), value :: solver
      integer(c_size_t), value :: count
      type(microslip_contact), intent(in) :: contacts(*)
      type(microslip_derivatives), intent(inout) :: derivatives(*)
      integer(c_int) :: code
    end function

    function microslip_creep_table_read(file, direction, table, error) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: file(*)
      integer(c_int), value :: direction
      type(c_ptr), intent(out) :: table
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    subroutine microslip_creep_table_destroy(table) bind(c)
      import
      type(c_ptr), value :: table
    end subroutine

    function microslip_creep_table_solve(table, count, contacts, forces) bind(c) result(code)
      import
      type(c_ptr), value :: table
      integer(c_size_t), value :: count
      type(microslip_contact), intent(in) :: contacts(*)
      type(microslip_forces), intent(inout) :: forces(*)
      integer(c_int) :: code
    end function

    function microslip_creep_table_differentiate(table, count, contacts, derivatives) bind(c) result(code)
      import
      type(c_ptr), value :: table
      integer(c_size_t), value :: count
      type(microslip_contact), intent(in) :: contacts(*)
      type(microslip_derivatives), intent(inout) :: derivatives(*)
      integer(c_int) :: code
    end function

    function microslip_build_info() bind(c) result(info)
      import
      type(microslip_build) :: info
    end function

    !> `text`, the file that microslip respond --poles writes, ends with c_null_char.
    function microslip_force_element_create(text, element, error) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: text(*)
      type(c_ptr), intent(out) :: element
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    subroutine microslip_force_element_destroy(element) bind(c)
      import
      type(c_ptr), value :: element
    end subroutine

    function microslip_force_element_step(element, distance, input, forces) bind(c) result(code)
      import
      type(c_ptr), value :: element
      real(c_double), value :: distance
      real(c_double), intent(in) :: input(microslip_element_inputs)
      real(c_double), intent(inout) :: forces(microslip_element_forces)
      integer(c_int) :: code
    end function

    !> `input`: c_loc of the numbers, or c_null_ptr.
    function microslip_force_element_reset(element, input) bind(c) result(code)
      import
      type(c_ptr), value :: element, input
      integer(c_int) :: code
    end function

    function microslip_force_element_state_size(element) bind(c) result(count)
      import
      type(c_ptr), value :: element
      integer(c_size_t) :: count
    end function

    function microslip_force_element_get_state(element, count, state) bind(c) result(code)
      import
      type(c_ptr), value :: element
      integer(c_size_t), value :: count
      real(c_double), intent(inout) :: state(*)
      integer(c_int) :: code
    end function

    function microslip_force_element_set_state(element, count, state) bind(c) result(code)
      import
      type(c_ptr), value :: element
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: state(*)
      integer(c_int) :: code
    end function

    function microslip_fastsim2_solve_fields(solver, contact, forces, error) bind(c) result(code)
      import
      type(c_ptr), value :: solver
      type(microslip_contact), intent(in) :: contact
      type(microslip_forces), intent(out) :: forces
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    !> `name` ends with c_null_char: 'fx' // c_null_char.
    function microslip_fastsim2_quantity(solver, name, value, error) bind(c) result(code)
      import
      type(c_ptr), value :: solver
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(out) :: value
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_fastsim2_field(solver, name, count, values, error) bind(c) result(code)
      import
      type(c_ptr), value :: solver
      character(kind=c_char), intent(in) :: name(*)
      integer(c_size_t), value :: count
      real(c_double), intent(out) :: values(*)
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_problem_create(kind, problem, error) bind(c) result(code)
      import
      integer(c_int), value :: kind
      type(c_ptr), intent(out) :: problem
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    !> `text` and `name` end with c_null_char.
    function microslip_problem_read(text, name, problem, error) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: text(*), name(*)
      type(c_ptr), intent(out) :: problem
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    subroutine microslip_problem_destroy(problem) bind(c)
      import
      type(c_ptr), value :: problem
    end subroutine

    !> microslip_text makes a Fortran text of `text`.
    function microslip_problem_text(problem, text, error) bind(c) result(code)
      import
      type(c_ptr), value :: problem
      type(c_ptr), intent(out) :: text
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_set_progress(problem, progress, data, error) bind(c) result(code)
      import
      type(c_ptr), value :: problem
      type(c_funptr), value :: progress
      type(c_ptr), value :: data
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_solve(problem, error) bind(c) result(code)
      import
      type(c_ptr), value :: problem
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    !> Element (k, n) of jacobian(3, 3) is the derivative of force n by creepage k; count is 9.
    function microslip_differentiate(problem, count, jacobian, error) bind(c) result(code)
      import
      type(c_ptr), value :: problem
      integer(c_size_t), value :: count
      real(c_double), intent(inout) :: jacobian(*)
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    !> `text` and `name` end with c_null_char; microslip_text makes a Fortran text of `json`.
    function microslip_solve_case(text, name, json, error) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: text(*), name(*)
      type(c_ptr), intent(out) :: json
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_wheel_rail_create(problem, wheel_rail, error) bind(c) result(code)
      import
      type(c_ptr), value :: problem
      type(c_ptr), intent(out) :: wheel_rail
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    subroutine microslip_wheel_rail_destroy(wheel_rail) bind(c)
      import
      type(c_ptr), value :: wheel_rail
    end subroutine

    function microslip_wheel_rail_state(wheel_rail, width, state) bind(c) result(code)
      import
      type(c_ptr), value :: wheel_rail
      integer(c_size_t), value :: width
      real(c_double), intent(inout) :: state(*)
      integer(c_int) :: code
    end function

    !> Rows are columns here: states(state_width, count), results(result_width, count).
    function microslip_wheel_rail_solve(wheel_rail, count, state_width, states, result_width, results, status) bind(c) &
        result(code)
      import
      type(c_ptr), value :: wheel_rail
      integer(c_size_t), value :: count, state_width, result_width
      real(c_double), intent(in) :: states(*)
      real(c_double), intent(inout) :: results(*)
      integer(c_int), intent(inout) :: status(*)
      integer(c_int) :: code
    end function

    !> Each state starts from the one before.
    function microslip_wheel_rail_continue(wheel_rail, count, state_width, states, result_width, results, status) &
        bind(c) result(code)
      import
      type(c_ptr), value :: wheel_rail
      integer(c_size_t), value :: count, state_width, result_width
      real(c_double), intent(in) :: states(*)
      real(c_double), intent(inout) :: results(*)
      integer(c_int), intent(inout) :: status(*)
      integer(c_int) :: code
    end function

    !> Element (k, n, i) of jacobian(column_count, row_count, count) is the derivative of result n by number k of the
    !> state i.
    function microslip_wheel_rail_differentiate(wheel_rail, count, state_width, states, result_width, results, status, &
        row_count, column_count, jacobian) bind(c) result(code)
      import
      type(c_ptr), value :: wheel_rail
      integer(c_size_t), value :: count, state_width, result_width, row_count, column_count
      real(c_double), intent(in) :: states(*)
      real(c_double), intent(inout) :: results(*), jacobian(*)
      integer(c_int), intent(inout) :: status(*)
      integer(c_int) :: code
    end function

    !> values(width, capacity); c_loc of it, or c_null_ptr to count the patches only.
    function microslip_wheel_rail_patches(wheel_rail, width, capacity, values, count, error) bind(c) result(code)
      import
      type(c_ptr), value :: wheel_rail
      integer(c_size_t), value :: width, capacity
      type(c_ptr), value :: values
      integer(c_size_t), intent(inout) :: count
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    !> contacts(width, count)
    function microslip_wheelset_contacts(wheel_rail, roll, yaw, count, lateral, width, contacts, status, error) bind(c) &
        result(code)
      import
      type(c_ptr), value :: wheel_rail
      integer(c_int), value :: roll
      real(c_double), value :: yaw
      integer(c_size_t), value :: count, width
      real(c_double), intent(in) :: lateral(*)
      real(c_double), intent(inout) :: contacts(*)
      integer(c_int), intent(inout) :: status(*)
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function

    function microslip_equivalent_conicity(wheel_rail, roll, contact_distance, count, amplitudes, conicity, error) &
        bind(c) result(code)
      import
      type(c_ptr), value :: wheel_rail
      integer(c_int), value :: roll
      real(c_double), value :: contact_distance
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: amplitudes(*)
      real(c_double), intent(out) :: conicity(*)
      type(microslip_error), intent(inout) :: error
      integer(c_int) :: code
    end function
  end interface

  !> Sets an input by its path: a number, a text, an array.
  interface microslip_set
    module procedure set_number, set_text, set_array
  end interface
  !> Gets it; texts and arrays are allocated.
  interface microslip_get
    module procedure get_number, get_text, get_array
  end interface

  public :: microslip_contact_check, microslip_polach_friction, microslip_hertz_from_load
  public :: microslip_hertz_warnings, microslip_free_text
  public :: microslip_count, microslip_index, microslip_describe
  public :: microslip_fastsim2_options_init, microslip_fastsim2_create, microslip_fastsim2_destroy
  public :: microslip_fastsim2_solve, microslip_fastsim2_differentiate
  public :: microslip_fastsim2_solve_fields
  public :: microslip_creep_table_read, microslip_creep_table_destroy
  public :: microslip_creep_table_solve, microslip_creep_table_differentiate
  public :: microslip_force_element_create, microslip_force_element_destroy, microslip_force_element_step
  public :: microslip_force_element_reset, microslip_force_element_state_size
  public :: microslip_force_element_get_state, microslip_force_element_set_state
  public :: microslip_fastsim2_quantity, microslip_fastsim2_field
  public :: microslip_problem_create, microslip_problem_read, microslip_problem_destroy, microslip_problem_text
  public :: microslip_set, microslip_unset, microslip_get, microslip_set_progress
  public :: microslip_solve, microslip_differentiate, microslip_number, microslip_field
  public :: microslip_solve_case
  public :: microslip_wheel_rail_create, microslip_wheel_rail_destroy, microslip_wheel_rail_state
  public :: microslip_wheel_rail_solve, microslip_wheel_rail_continue
  public :: microslip_wheel_rail_differentiate, microslip_wheel_rail_patches
  public :: microslip_wheelset_contacts, microslip_equivalent_conicity
  public :: microslip_warning
  public :: microslip_version, microslip_build_info, microslip_abi, microslip_code_text, microslip_error_text, microslip_text

contains

  function set_number(problem, path, value, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path
    real(c_double), intent(in) :: value
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    interface
      function c_set(problem, path, value, error) bind(c, name='microslip_set') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: path(*)
        real(c_double), value :: value
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_set(problem, trim(path) // c_null_char, value, error)
  end function

  function set_text(problem, path, value, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path, value
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    interface
      function c_set_text(problem, path, value, error) bind(c, name='microslip_set_text') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: path(*), value(*)
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_set_text(problem, trim(path) // c_null_char, trim(value) // c_null_char, error)
  end function

  function set_array(problem, path, values, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path
    real(c_double), intent(in) :: values(:)
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    interface
      function c_set_array(problem, path, count, values, error) bind(c, name='microslip_set_array') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: path(*)
        integer(c_size_t), value :: count
        real(c_double), intent(in) :: values(*)
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_set_array(problem, trim(path) // c_null_char, size(values, kind=c_size_t), values, error)
  end function

  !> Goes back to the default.
  function microslip_unset(problem, path, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    interface
      function c_unset(problem, path, error) bind(c, name='microslip_unset') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: path(*)
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_unset(problem, trim(path) // c_null_char, error)
  end function

  function get_number(problem, path, value, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path
    real(c_double), intent(inout) :: value
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    interface
      function c_get(problem, path, value, error) bind(c, name='microslip_get') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: path(*)
        real(c_double), intent(inout) :: value
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_get(problem, trim(path) // c_null_char, value, error)
  end function

  function get_text(problem, path, value, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path
    character(:), allocatable, intent(inout) :: value
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    type(c_ptr) :: text
    interface
      function c_get_text(problem, path, value, error) bind(c, name='microslip_get_text') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: path(*)
        type(c_ptr), intent(inout) :: value
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    text = c_null_ptr
    code = c_get_text(problem, trim(path) // c_null_char, text, error)
    if (code == microslip_ok) value = microslip_text(text)
    call microslip_free_text(text)
  end function

  function get_array(problem, path, values, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: path
    real(c_double), allocatable, target, intent(inout) :: values(:)
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    integer(c_size_t) :: count
    interface
      function c_get_array(problem, path, capacity, values, count, error) bind(c, name='microslip_get_array') &
          result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: path(*)
        integer(c_size_t), value :: capacity
        type(c_ptr), value :: values
        integer(c_size_t), intent(inout) :: count
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_get_array(problem, trim(path) // c_null_char, 0_c_size_t, c_null_ptr, count, error)
    if (code /= microslip_ok) return
    if (allocated(values)) deallocate (values)
    allocate (values(count))
    code = c_get_array(problem, trim(path) // c_null_char, count, c_loc(values), count, error)
  end function

  !> A number of the result by its name.
  function microslip_number(problem, name, value, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: name
    real(c_double), intent(inout) :: value
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    interface
      function c_number(problem, name, value, error) bind(c, name='microslip_number') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: name(*)
        real(c_double), intent(inout) :: value
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_number(problem, trim(name) // c_null_char, value, error)
  end function

  !> A field of the result by its name, allocated as values(columns, rows).
  function microslip_field(problem, name, values, error) result(code)
    type(c_ptr), intent(in) :: problem
    character(*), intent(in) :: name
    real(c_double), allocatable, intent(inout) :: values(:, :)
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    integer(c_size_t) :: columns, rows
    interface
      function c_field_size(problem, name, columns, rows, error) bind(c, name='microslip_field_size') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: name(*)
        integer(c_size_t), intent(inout) :: columns, rows
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
      function c_field(problem, name, count, values, error) bind(c, name='microslip_field') result(code)
        import
        type(c_ptr), value :: problem
        character(kind=c_char), intent(in) :: name(*)
        integer(c_size_t), value :: count
        real(c_double), intent(inout) :: values(*)
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_field_size(problem, trim(name) // c_null_char, columns, rows, error)
    if (code /= microslip_ok) return
    if (allocated(values)) deallocate (values)
    allocate (values(columns, rows))
    code = c_field(problem, trim(name) // c_null_char, columns * rows, values, error)
  end function

  !> Version of the library that is running, e.g. "1.0.0".
  function microslip_version() result(text)
    character(:), allocatable :: text
    interface
      function c_version() bind(c, name='microslip_version') result(text)
        import
        type(c_ptr) :: text
      end function
    end interface
    text = microslip_text(c_version())
  end function

  !> Of the binary interface of the library that is running; this module is made for microslip_made_for_abi.
  function microslip_abi() result(number)
    integer(c_int) :: number
    interface
      function c_abi() bind(c, name='microslip_abi') result(number)
        import
        integer(c_int) :: number
      end function
    end interface
    number = c_abi()
  end function

  !> What a code means, in a few words.
  function microslip_code_text(code) result(text)
    integer(c_int), intent(in) :: code
    character(:), allocatable :: text
    interface
      function c_code_text(code) bind(c, name='microslip_code_text') result(text)
        import
        integer(c_int), value :: code
        type(c_ptr) :: text
      end function
    end interface
    text = microslip_text(c_code_text(code))
  end function

  !> Where a number stands in a list, counted from 1, as in Fortran's arrays; 0 if it has none of this name, and the error
  !> tells the nearest one.
  function microslip_index(list, name, error) result(index)
    integer(c_int), intent(in) :: list
    character(*), intent(in) :: name
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: index
    interface
      function c_index(list, name, error) bind(c, name='microslip_index') result(index)
        import
        integer(c_int), value :: list
        character(kind=c_char), intent(in) :: name(*)
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: index
      end function
    end interface
    index = c_index(list, trim(name) // c_null_char, error) + 1
  end function

  !> What stands at an index of a list, counted from 1.
  function microslip_describe(list, index, quantity, error) result(code)
    integer(c_int), intent(in) :: list, index
    type(microslip_quantity), intent(inout) :: quantity
    type(microslip_error), intent(inout) :: error
    integer(c_int) :: code
    interface
      function c_describe(list, index, quantity, error) bind(c, name='microslip_describe') result(code)
        import
        integer(c_int), value :: list
        integer(c_size_t), value :: index
        type(microslip_quantity), intent(inout) :: quantity
        type(microslip_error), intent(inout) :: error
        integer(c_int) :: code
      end function
    end interface
    code = c_describe(list, int(index - 1, c_size_t), quantity, error)
  end function

  !> The text of the k-th warning, counted from 0: bit k of a warning code; empty from the first that there is not.
  function microslip_warning(k) result(text)
    integer(c_int), intent(in) :: k
    character(:), allocatable :: text
    interface
      function c_warning(k) bind(c, name='microslip_warning') result(text)
        import
        integer(c_int), value :: k
        type(c_ptr) :: text
      end function
    end interface
    text = microslip_text(c_warning(k))
  end function

  !> The words of an error.
  function microslip_error_text(error) result(text)
    type(microslip_error), intent(in) :: error
    character(:), allocatable :: text
    integer :: i
    text = ''
    do i = 1, microslip_error_length
      if (error%text(i) == c_null_char) exit
      text = text // error%text(i)
    end do
  end function

  !> A C string as a Fortran one; empty if there is none.
  function microslip_text(pointer) result(text)
    type(c_ptr), intent(in) :: pointer
    character(:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer(c_size_t) :: i, length
    interface
      function c_length(text) bind(c, name='strlen') result(length)
        import
        type(c_ptr), value :: text
        integer(c_size_t) :: length
      end function
    end interface
    length = 0
    if (c_associated(pointer)) length = c_length(pointer)
    allocate (character(length) :: text)
    if (length == 0) return
    call c_f_pointer(pointer, letters, [length])
    do i = 1, length
      text(i:i) = letters(i)
    end do
  end function

end module
